#pragma once

#include <algorithm>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "topology/gluings.hpp"

namespace tripus::testing {

/// The same triangulation with tetrahedra and their vertices in random order.
inline topology::Gluings relabelled(const topology::Gluings& gluings, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  const std::size_t count = gluings.tetrahedron_count();
  std::vector<topology::TetrahedronIndex> number(count);
  std::vector<topology::Perm4> labels(count);
  for (std::size_t t = 0; t < count; ++t) {
    number[t] = static_cast<topology::TetrahedronIndex>(t);
    std::swap(number[t], number[engine() % (t + 1)]);
    labels[t] = topology::Perm4::from_rank(static_cast<int>(engine() % 24));
  }
  topology::Gluings result(count);
  for (std::size_t t = 0; t < count; ++t)
    for (int f = 0; f < 4; ++f) {
      if (gluings.is_open(t, f)) continue;
      const topology::TetrahedronIndex other = gluings.neighbour(t, f);
      result.set_one_side(number[t], labels[t](f), number[other],
                          labels[other] * gluings.gluing(t, f) * labels[t].inverse());
    }
  return result;
}

}  // namespace tripus::testing
