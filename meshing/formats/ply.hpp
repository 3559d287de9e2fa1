#pragma once

#include <string>
#include <string_view>

#include "meshing/formats/read_mesh.hpp"

namespace tripus::meshing {

/// PLY, text or binary of either byte order. Only x, y, z of "vertex", the index lists of "face"
/// and "tristrips" are used; other properties and elements are skipped. Throws InvalidInput with
/// the line or byte.
SurfaceFile read_ply(std::string_view text);

/// Binary, little-endian, with coordinates in double precision.
std::string write_ply(const SurfaceMesh& mesh);

}  // namespace tripus::meshing
