#pragma once

#include <string>
#include <string_view>

#include "meshing/formats/read_mesh.hpp"

namespace tripus::meshing {

/// Geomview's OFF, as text: "OFF", counts, points, faces. Also COFF, NOFF and STOFF, whose extra
/// columns are skipped. Polygons with more than three corners are refused.
/// Throws InvalidInput with the line.
SurfaceFile read_off(std::string_view text);

/// OFF with coordinates that read back to the same doubles.
std::string write_off(const SurfaceMesh& mesh);

}  // namespace tripus::meshing
