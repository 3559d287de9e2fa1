#pragma once

#include <string_view>

#include "meshing/formats/read_mesh.hpp"

namespace tripus::meshing {

/// PLY, text or binary of either byte order. Only x, y, z of "vertex" and the index list of "face"
/// are used; other properties and elements are skipped. Faces must be triangles. Throws
/// InvalidInput with the line or byte.
SurfaceFile read_ply(std::string_view text);

}  // namespace tripus::meshing
