#pragma once

#include <string>
#include <string_view>

#include "meshing/formats/read_mesh.hpp"

namespace tripus::meshing {

/// Gmsh's .msh of the versions 2 and 4.1, text or binary: a tetrahedral mesh if it has tetrahedra,
/// else a surface of triangles and quadrilaterals. Curved cells count by their corners; points and
/// lines, physical groups, entities and data are skipped; hexahedra, prisms and pyramids are
/// refused. Throws InvalidInput with the line or byte.
MeshFile read_gmsh(std::string_view text);

/// Version 2.2, text, which everything reads.
std::string write_gmsh(const TetrahedralMesh& mesh);

}  // namespace tripus::meshing
