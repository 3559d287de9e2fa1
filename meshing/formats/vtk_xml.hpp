#pragma once

#include <string_view>

#include "meshing/formats/read_mesh.hpp"

namespace tripus::meshing {

/// VTK's XML files of an UnstructuredGrid (.vtu) or PolyData (.vtp): text, base64 or appended
/// arrays (raw or base64), of either byte order, compressed by zlib or not; of several pieces all.
/// What is read of the cells is what read_vtk reads. Throws InvalidInput with the array and what
/// was expected.
MeshFile read_vtk_xml(std::string_view text);

/// Whether the first element of a text is VTK's.
bool starts_vtk_xml(std::string_view content);

}  // namespace tripus::meshing
