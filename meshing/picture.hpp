#pragma once

#include <string>

#include "meshing/manifold.hpp"
#include "meshing/tetrahedral_mesh.hpp"

namespace tripus::meshing {

// Pictures as SVG, without any library: triangles from the farthest to the nearest.

/// The boundary as seen through its near side: walls that face the viewer from within the solid.
std::string boundary_picture(const TetrahedralMesh& solid);

/// The tetrahedra behind a plane through the middle; where they were cut in another colour.
std::string cut_picture(const TetrahedralMesh& solid);

/// The same with a cone point above the boundary, and edges to the boundary points that are seen.
std::string cone_picture(const TetrahedralMesh& solid);

/// Bars: the number of tetrahedra at each stage, on a logarithmic scale.
std::string stages_picture(const MeshedManifold& manifold);

}  // namespace tripus::meshing
