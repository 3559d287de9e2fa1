#pragma once

#include <string>
#include <string_view>

#include "meshing/formats/read_mesh.hpp"

namespace tripus::meshing {

/// Wavefront OBJ: v and f lines, which "\\" continues; negative (relative) indices are understood.
/// Normals, colours, textures, groups, materials, lines, points and the commands of renderers are
/// skipped; curves and curved surfaces are refused.
/// Throws InvalidInput with the line or byte.
SurfaceFile read_obj(std::string_view text);

/// Whether the first line that says something is one of a face, a point or what may come before.
bool starts_obj(std::string_view content);

std::string write_obj(const SurfaceMesh& mesh);

}  // namespace tripus::meshing
