#pragma once

#include "meshing/formats/read_mesh.hpp"

namespace tripus::meshing {

/// Mends what programs leave in good surfaces, each with a note that counts: equal points become
/// one, triangles without area and points of no triangle go. If that does not close the surface,
/// and the following does, then also: one of two equal triangles goes, or both; points on open
/// edges become one where they lie closer together than a small part of the size; triangles are
/// split where a point lies in the middle of their open edge (a T-junction). Faces that reading cut
/// into triangles are cut along other diagonals where the first ones collide. What stays open is
/// given back with its open edges, which validation then names.
///
/// The numbers of points and cells in the file are kept in `lines`. Never throws: coordinates that
/// are not finite and corners that do not exist are left as they are.
SurfaceFile mend(SurfaceFile file);

/// Of a tetrahedral mesh only: equal points become one, if no tetrahedron has two of them, and
/// points of no tetrahedron go.
TetrahedralFile mend(TetrahedralFile file);

}  // namespace tripus::meshing
