#pragma once

#include <string_view>

#include "meshing/formats/read_mesh.hpp"

namespace tripus::meshing {

/// STL, text or binary. The format repeats every corner; corners with equal coordinates become one
/// point, in the order in which they first appear.
/// Throws InvalidInput with the line or byte.
SurfaceFile read_stl(std::string_view text);

/// A binary STL has no mark but its length: 80 bytes, a count, 50 bytes for each triangle.
bool is_binary_stl(std::string_view data);

}  // namespace tripus::meshing
