#pragma once

#include <array>
#include <vector>

#include "embedding/embedding.hpp"
#include "geometry/moebius.hpp"

namespace tripus::embedding::detail {

/// [T] 1 or -1: the frames of neighbours in the spanning forest of the dual graph agree, where the
/// labels of a face are matched by an odd permutation exactly when they have the same orientation.
/// So in an orientable triangulation all neighbours agree.
std::vector<int> orientations(const topology::Gluings& gluings);

/// Whether the isometry across face f of tetrahedron t reverses orientation, by the gluings alone.
bool pairing_reverses(const std::vector<int>& orientation, const topology::Gluings& gluings,
                      std::size_t t, int f);

/// [T x 4] the face pairings of an embedding in SL(2,C) (and its other half), up to sign.
std::vector<std::array<geometry::MoebiusMap, 4>> moebius_pairings(const Embedding& embedding,
                                                                  const topology::Gluings& gluings);

}  // namespace tripus::embedding::detail
