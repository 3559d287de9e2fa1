#pragma once

#include <string>
#include <string_view>

#include "meshing/formats/read_mesh.hpp"

namespace tripus::meshing {

/// VTK's legacy format, text or binary, versions 1 to 5: UNSTRUCTURED_GRID (tetrahedra, or
/// triangles if there are none) and POLYDATA (triangles). Points, lines and all data are skipped;
/// other cells are refused. Throws InvalidInput with the line or byte.
MeshFile read_vtk(std::string_view text);

std::string write_vtk(const TetrahedralMesh& mesh);

}  // namespace tripus::meshing
