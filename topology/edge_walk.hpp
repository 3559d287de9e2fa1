#pragma once

#include "topology/triangulation.hpp"

namespace tripus::topology {

/// A position on the way around an edge: in tetrahedron t, along its edge from vertex a to vertex
/// b, about to leave through face c; it came in through face d. {a,b,c,d} = {0,1,2,3}.
struct EdgeWalk {
  std::size_t t;
  int a, b, c, d;

  /// At edge e of tetrahedron t, directed as kEdgeEnds.
  static EdgeWalk start(std::size_t t, int e) {
    const auto [a, b] = kEdgeEnds[static_cast<std::size_t>(e)];
    const auto [c, d] = kEdgeEnds[static_cast<std::size_t>(5 - e)];
    return {t, a, b, c, d};
  }
  /// Through face c, which must not be open.
  void step(const Gluings& gluings) {
    const Perm4 p = gluings.gluing(t, c);
    t = gluings.neighbour(t, c);
    a = p(a);
    b = p(b);
    const int left = p(c);
    c = p(d);
    d = left;
  }
  int edge() const { return kEdgeNumber[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)]; }
  bool reversed() const { return a > b; }
};

}  // namespace tripus::topology
