#pragma once

#include <string_view>

#include "meshing/formats/read_mesh.hpp"

namespace tripus::meshing {

/// TetGen's pair of files: points (.node) and tetrahedra (.ele), numbered from 0 or 1 as the first
/// point is. Attributes and markers are skipped; of tetrahedra with ten points the four corners
/// count.
/// Throws InvalidInput with file and line.
TetrahedralFile read_tetgen(std::string_view node_text, std::string_view ele_text);

}  // namespace tripus::meshing
