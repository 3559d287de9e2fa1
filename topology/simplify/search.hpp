#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "topology/simplify/reducer.hpp"

namespace tripus::topology {

/// What the search makes small: first of all the number of finite vertices.
struct SearchSize {
  std::size_t finite_vertices = 0;
  std::size_t tetrahedra = 0;
  friend auto operator<=>(const SearchSize&, const SearchSize&) = default;
};

/// A random local search: a *trial* makes a few random moves next to one another (2-3 and 4-4, and
/// 1-4 where a finite vertex is to go) and lets the reducer run from there. Unless that comes out
/// larger than before, it is kept; so the search walks over plateaus. (Letting it climb by one or
/// two tetrahedra as well was found to make no difference.) A trial costs the same whatever T is.
class LocalSearch {
 public:
  /// `finite_to_keep`: finite vertices that are to stay.
  LocalSearch(MutableTriangulation& triangulation, Reducer& reducer, std::size_t finite_to_keep,
              std::uint64_t seed)
      : m_(&triangulation), reducer_(&reducer), finite_to_keep_(finite_to_keep), engine_(seed) {}

  SearchSize size() const { return {m_->finite_vertex_count(), m_->tetrahedron_count()}; }
  bool has_finite_to_go() const { return m_->finite_vertex_count() > finite_to_keep_; }

  /// One trial with up to `depth` random moves.
  void trial(int depth);

 private:
  /// Below n > 0. The standard distributions differ between libraries; the engine does not.
  std::uint64_t draw(std::uint64_t n) { return engine_() % n; }
  TetrahedronIndex draw_place();
  bool random_move(TetrahedronIndex t);
  void run_from_seeds();

  MutableTriangulation* m_;
  Reducer* reducer_;
  std::size_t finite_to_keep_;
  std::mt19937_64 engine_;
  std::vector<TetrahedronIndex> seeds_;  // made by the random moves of a trial
};

}  // namespace tripus::topology
