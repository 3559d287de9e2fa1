#pragma once

#include <string>
#include <vector>

#include "base/stop.hpp"
#include "meshing/tetrahedral_mesh.hpp"
#include "meshing/validate.hpp"

namespace tripus::meshing::detail {

/// Faces of one tetrahedron alone, counterclockwise from outside where tetrahedra are in positive
/// order; those with equal corners follow each other in no order of meaning.
std::vector<Triangle> boundary_faces(const TetrahedralMesh& mesh);

/// Whether tetrahedra in positive order fill a region: what is wrong if not, nothing if they do.
///
/// Their boundary is the surface, or a subdivision of it with new points. Positive tetrahedra fill
/// what their boundary encloses, once everywhere, if that is embedded. It is then the surface up to
/// isotopy: each of its triangles lies on a triangle of the surface up to rounding, so it lies in
/// a collar S x [-e, e] of the surface S; each component encloses the volume of the one that it has
/// points of, so it runs once around that; and it has its genus (Waldhausen 1968, as for tubes in
/// tube/tube_surface.cpp).
/// Exact but for "up to rounding", which is tolerance::kOnSurface.
std::string boundary_fault(const TetrahedralMesh& mesh, const Region& region, const Stop& stop);

}  // namespace tripus::meshing::detail
