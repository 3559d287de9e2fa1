#pragma once

#include <string>
#include <string_view>

#include "meshing/formats/read_mesh.hpp"

namespace tripus::meshing {

/// VTK's legacy format, text or binary, versions 1 to 5: UNSTRUCTURED_GRID (tetrahedra, or the
/// faces if there are none) and POLYDATA (polygons and strips), its sections in any order and case,
/// among them FIELD and METADATA. Points, lines and all data are skipped; other cells are refused.
/// Indices of the type vtkIdType, and long ones, take 4 bytes or 8, as the file shows.
/// Throws InvalidInput with the line or byte.
MeshFile read_vtk(std::string_view text);

/// Whether a text begins as the format demands, in any case of the letters.
bool starts_vtk(std::string_view content);

std::string write_vtk(const TetrahedralMesh& mesh);

}  // namespace tripus::meshing
