#pragma once

#include <cstdint>
#include <random>

#include "topology/simplify/reducer.hpp"

namespace tripus::topology {

/// A random local search: a *trial* makes a few random 2-3 and 4-4 moves next to one another and
/// lets the reducer run from there. Unless that comes out with more tetrahedra (or more finite
/// vertices) than before, it is kept; so the search walks over plateaus. A trial costs the same
/// whatever T is.
class LocalSearch {
 public:
  LocalSearch(MutableTriangulation& triangulation, Reducer& reducer, std::uint64_t seed)
      : m_(&triangulation), reducer_(&reducer), engine_(seed) {}

  enum class Result : std::uint8_t { kUndone, kLevel, kBetter };

  /// One trial with up to `depth` random moves from tetrahedron t on.
  Result trial(TetrahedronIndex t, int depth);
  /// Below n > 0. The standard distributions differ between libraries; the engine does not.
  std::uint64_t draw(std::uint64_t n) { return engine_() % n; }

 private:
  bool random_move(TetrahedronIndex t);

  MutableTriangulation* m_;
  Reducer* reducer_;
  std::mt19937_64 engine_;
};

}  // namespace tripus::topology
