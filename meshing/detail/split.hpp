#pragma once

#include <cstddef>

#include "meshing/tetrahedral_mesh.hpp"

namespace tripus::meshing::detail {

struct SplitOptions {
  double max_volume = 0;       ///< split what is larger; 0: nothing for its size
  std::size_t tetrahedra = 0;  ///< split the largest until there are so many
  std::size_t most = 0;        ///< tetrahedra that there is room for
};

/// Splits tetrahedra at their centroids, the largest first, so that no face is touched: what a
/// mesher cannot refine without new points on the boundary. The new tetrahedra have the sign of
/// the old one (exact); one too flat for that is left when only a number is asked for.
/// Throws Unsupported if `most` is not enough, or one is too flat for `max_volume`.
void split_largest(TetrahedralMesh& mesh, const SplitOptions& options);

/// Volume of a tetrahedron, negative if its corners are not in positive order.
double volume_of(const TetrahedralMesh& mesh, const Tetrahedron& t);

}  // namespace tripus::meshing::detail
