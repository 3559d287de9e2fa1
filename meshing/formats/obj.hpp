#pragma once

#include <string_view>

#include "meshing/formats/read_mesh.hpp"

namespace tripus::meshing {

/// Wavefront OBJ: v and f lines; normals, textures, groups and materials are skipped. Faces must be
/// triangles; negative (relative) indices are understood.
/// Throws InvalidInput with the line or byte.
SurfaceFile read_obj(std::string_view text);

}  // namespace tripus::meshing
