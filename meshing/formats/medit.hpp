#pragma once

#include <string>
#include <string_view>

#include "meshing/formats/read_mesh.hpp"

namespace tripus::meshing {

/// Medit's .mesh, as text: a tetrahedral mesh if it has tetrahedra, else a surface of triangles and
/// quadrilaterals. Other sections and all reference numbers are skipped; hexahedra and prisms are
/// refused. Throws InvalidInput with the line.
MeshFile read_medit(std::string_view text);

/// With the triangles of the boundary, which TetGen and others expect.
std::string write_medit(const TetrahedralMesh& mesh);

}  // namespace tripus::meshing
