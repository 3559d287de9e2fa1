#pragma once

#include <string>
#include <string_view>

#include "meshing/formats/read_mesh.hpp"

namespace tripus::meshing {

/// STL, text (in any case of the letters, "end loop" as well as "endloop") or binary (with bytes
/// after the last triangle, or a count of 0 that the length of the file corrects). The format
/// repeats every corner; corners with equal coordinates become one point, in the order in which
/// they first appear. Normals and colours are skipped.
/// Throws InvalidInput with the line or byte.
SurfaceFile read_stl(std::string_view text);

/// A binary STL has no mark but its length: 80 bytes, a count, 50 bytes for each triangle. With
/// `by_name`, the name of the file says STL, and a length that does not fit is no objection.
bool starts_stl(std::string_view data, bool by_name);

std::string write_stl(const SurfaceMesh& mesh);

}  // namespace tripus::meshing
