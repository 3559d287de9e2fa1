#pragma once

#include <vector>

#include "meshing/surface_mesh.hpp"

namespace tripus::meshing::tube {

/// Euler characteristics of the components of a closed oriented manifold, sorted.
/// Throws InternalError, naming the edge or vertex, if the mesh is none.
std::vector<long> euler_characteristics(const SurfaceMesh& mesh);

}  // namespace tripus::meshing::tube
