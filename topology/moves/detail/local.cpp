#include "topology/moves/detail/local.hpp"

namespace tripus::topology::detail {

std::size_t valence(const Gluings& gluings, const EdgeWalk& start) {
  std::size_t count = 0;
  EdgeWalk walk = start;
  do {
    if (gluings.is_open(walk.t, walk.c)) return 0;
    walk.step(gluings);
    ++count;
  } while (!is_same_corner(walk, start));
  return count;
}

bool is_same_edge(const Gluings& gluings, std::size_t t, int edge, std::size_t other,
                  int other_edge) {
  const auto start = EdgeWalk::start(t, edge);
  EdgeWalk walk = start;
  do {
    if (walk.t == other && walk.edge() == other_edge) return true;
    if (gluings.is_open(walk.t, walk.c)) return false;
    walk.step(gluings);
  } while (!is_same_corner(walk, start));
  return false;
}

void face_candidates(const Triangulation& triangulation, MoveKind kind, std::vector<Move>& moves) {
  const Gluings& gluings = triangulation.gluings();
  for (TetrahedronIndex t = 0; t < gluings.tetrahedron_count(); ++t)
    for (int f = 0; f < 4; ++f) {
      const TetrahedronIndex other = gluings.neighbour(t, f);
      if (other > t || (other == t && gluings.gluing(t, f)(f) > f))
        moves.push_back({.kind = kind, .tetrahedron = t, .place = static_cast<std::uint8_t>(f)});
    }
}

void edge_candidates(const Triangulation& triangulation, MoveKind kind, int choices,
                     std::vector<Move>& moves) {
  for (std::size_t e = 0; e < triangulation.edge_count(); ++e) {
    const EdgeCorner first = triangulation.corners(e)[0];
    for (int choice = 0; choice < choices; ++choice)
      moves.push_back({.kind = kind,
                       .tetrahedron = static_cast<TetrahedronIndex>(first.tetrahedron()),
                       .place = static_cast<std::uint8_t>(first.edge()),
                       .choice = static_cast<std::uint8_t>(choice)});
  }
}

void vertex_candidates(const Triangulation& triangulation, MoveKind kind,
                       std::vector<Move>& moves) {
  std::vector<bool> seen(triangulation.vertex_count(), false);
  for (TetrahedronIndex t = 0; t < triangulation.tetrahedron_count(); ++t)
    for (int v = 0; v < 4; ++v) {
      const auto vertex = triangulation.vertex_class(t, v);
      if (seen[vertex]) continue;
      seen[vertex] = true;
      moves.push_back({.kind = kind, .tetrahedron = t, .place = static_cast<std::uint8_t>(v)});
    }
}

}  // namespace tripus::topology::detail
