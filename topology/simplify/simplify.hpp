#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>

#include "base/stop.hpp"
#include "topology/gluings.hpp"

namespace tripus::topology {

struct SimplifyOptions {
  std::uint64_t seed = 0;  ///< of the search; the same result for the same seed on every platform
  /// How long to search once nothing gets smaller directly: a factor of the default number of
  /// trials, which is linear in T. 0: no search, except for ways to remove finite vertices.
  double effort = 1.0;
  /// Called now and then with what is going on ("collapse", "reduce", "search") and with T.
  std::function<void(std::string_view stage, std::size_t tetrahedra)> progress = {};
  /// Where it becomes true, simplify returns soon, with what it has.
  Stop stop{};
};

struct Simplified {
  Gluings gluings;
  std::size_t given = 0;      ///< T of the input
  std::size_t collapsed = 0;  ///< T when no edge could be collapsed any more
  std::size_t reduced = 0;    ///< T after the moves that make it smaller
  /// Finite vertices that should have gone: 0 unless the run was stopped or the search gave up.
  std::size_t finite_vertices_left = 0;
  bool stopped = false;  ///< by stop

  std::size_t tetrahedron_count() const { return gluings.tetrahedron_count(); }
};

/// A small triangulation of the same manifold. Edges are collapsed until only those vertices are
/// left whose links are no spheres (one finite vertex in a component that has no others); then
/// moves make it smaller while they can; then a random search looks for ways out of local minima,
/// with trials whose number is linear in T. Disconnected and non-orientable inputs are welcome;
/// oriented tables stay oriented. Cost: near linear in T; about 90 bytes a tetrahedron besides the
/// input. Throws InvalidInput, as the constructor of Triangulation does, if the table is not closed
/// up (see cone_boundary) or not consistent, and if the effort is negative or not finite.
Simplified simplify(const Gluings& closed, const SimplifyOptions& options = {});

}  // namespace tripus::topology
