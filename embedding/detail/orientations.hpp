#pragma once

#include <vector>

#include "topology/gluings.hpp"

namespace tripus::embedding::detail {

/// [T] 1 or -1: the frames of neighbours in the spanning forest of the dual graph agree, where the
/// labels of a face are matched by an odd permutation exactly when they have the same orientation.
/// So in an orientable triangulation all neighbours agree.
std::vector<int> orientations(const topology::Gluings& gluings);

}  // namespace tripus::embedding::detail
