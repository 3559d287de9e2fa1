// The boundary of the manifold is the union of the vertex links. The bigon meets them in two arcs,
// each of which closes up: in the link of p it runs from the end of the opposite edge there across
// the triangle of one tetrahedron, over one side, and across the triangle of the other back to
// where it began. What the annulus can be is read off the pieces into which its curves cut the
// links: Euler characteristics of pieces, and which piece holds which end of the edge.
#include "structure/closed_bigon.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>

namespace tripus::structure {
namespace {

using topology::EdgeCorner;
using topology::Perm4;
using topology::Triangulation;

/// A tetrahedron at the edge x y of valence 2, with the opposite edge p q.
struct Side {
  std::size_t t = 0;
  int x = 0, y = 0, p = 0, q = 0;
  int end(int which) const { return which == 0 ? p : q; }
};

/// Whether edge class direction and p to q agree.
bool runs_from_p(const Triangulation& triangulation, const Side& side) {
  const int edge = topology::kEdgeNumber[side.p][side.q];
  const auto corners = triangulation.corners(triangulation.edge_class(side.t, edge));
  const auto here = std::ranges::find_if(corners, [&](const EdgeCorner& corner) {
    return corner.tetrahedron() == side.t && corner.edge() == edge;
  });
  return (topology::kEdgeEnds[edge][0] == side.p) != here->reversed();
}

/// The two tetrahedra at an edge of valence 2, with labels that agree across both faces; nothing if
/// they are one tetrahedron.
std::optional<std::array<Side, 2>> sides_of(const Triangulation& triangulation, std::size_t edge) {
  if (triangulation.valence(edge) != 2) return std::nullopt;
  const EdgeCorner corner = triangulation.corners(edge)[0];
  const std::size_t t = corner.tetrahedron();
  const auto [x, y] = topology::kEdgeEnds[corner.edge()];
  const auto [p, q] = topology::kEdgeEnds[5 - corner.edge()];
  const std::size_t other = triangulation.gluings().neighbour(t, q);
  if (other == t) return std::nullopt;
  const Perm4 g = triangulation.gluings().gluing(t, q);
  return std::array<Side, 2>{Side{t, x, y, p, q}, Side{other, g(x), g(y), g(p), g(q)}};
}

/// A corner of a triangle of the vertex links: in tetrahedron t, at vertex v, on the edge v u.
struct Corner {
  std::size_t t;
  int v, u;
};

/// The vertex links, cut along one or both curves of the annulus.
class CutLinks {
 public:
  CutLinks(const Triangulation& triangulation, const std::array<Side, 2>& sides,
           std::array<bool, 2> is_cut)
      : triangulation_(triangulation),
        sides_(sides),
        is_cut_(is_cut),
        neighbours_(4 * triangulation.tetrahedron_count() + 4),
        euler_(neighbours_.size(), 1),
        piece_(neighbours_.size(), kNone) {
    join_across_sides();
    add_vertices();
    number_pieces();
  }

  /// Whether the curve at p (0) or at q (1) has a disc on one side.
  bool has_disc_at(int end) const {
    return std::ranges::any_of(parts(end), [&](std::size_t part) { return euler(part) == 1; });
  }

  /// Whether both curves together bound an annulus that holds exactly one end of the edge x y.
  bool has_annulus_with_one_end() const {
    const Side& side = sides_[0];
    const std::size_t at_x = piece_[part({side.t, side.x, side.y})];
    const std::size_t at_y = piece_[part({side.t, side.y, side.x})];
    for (const std::size_t a : parts(0))
      for (const std::size_t b : parts(1))
        if (piece_[a] == piece_[b] && euler(a) == 0 && (at_x == piece_[a]) != (at_y == piece_[a]))
          return true;
    return false;
  }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  /// Which of the two tetrahedra, and which of the curves, cut the triangle of a corner.
  struct Cut {
    int side, end;
  };
  std::optional<Cut> cut_of(const Corner& corner) const {
    for (int side = 0; side < 2; ++side)
      for (int end = 0; end < 2; ++end)
        if (is_cut_[end] && corner.t == sides_[side].t && corner.v == sides_[side].end(end))
          return Cut{side, end};
    return std::nullopt;
  }
  /// Whether a curve passes through the corner.
  bool is_tip(const Corner& corner) const {
    const auto cut = cut_of(corner);
    return cut && corner.u == sides_[cut->side].end(1 - cut->end);
  }
  /// The part of a triangle at a corner that is no tip. A triangle that is cut has the part at the
  /// edge to x under its own number, that at the edge to y behind all triangles.
  std::size_t part(const Corner& corner) const {
    const auto cut = cut_of(corner);
    if (cut && corner.u == sides_[cut->side].y)
      return 4 * triangulation_.tetrahedron_count() +
             static_cast<std::size_t>(2 * cut->end + cut->side);
    return 4 * corner.t + static_cast<std::size_t>(corner.v);
  }
  /// The four parts along a curve.
  std::array<std::size_t, 4> parts(int end) const {
    const auto at = [&](int side, int u) {
      return part({sides_[side].t, sides_[side].end(end), u});
    };
    return {at(0, sides_[0].x), at(0, sides_[0].y), at(1, sides_[1].x), at(1, sides_[1].y)};
  }

  /// Every side of every triangle once; the sides that a curve crosses in two halves.
  void join_across_sides() {
    const auto& gluings = triangulation_.gluings();
    for (std::size_t t = 0; t < triangulation_.tetrahedron_count(); ++t) {
      for (int f = 0; f < 4; ++f) {
        const std::pair<std::size_t, int> there{gluings.neighbour(t, f), gluings.gluing(t, f)(f)};
        if (there < std::pair(t, f)) continue;
        for (int v = 0; v < 4; ++v)
          if (v != f) join_across(t, f, v);
      }
    }
  }
  void join_across(std::size_t t, int f, int v) {
    const std::size_t other = triangulation_.gluings().neighbour(t, f);
    const Perm4 g = triangulation_.gluings().gluing(t, f);
    std::array<int, 2> ends{};
    for (int u = 0, n = 0; u < 4; ++u)
      if (u != f && u != v) ends[n++] = u;
    const auto cut = cut_of({t, v, f});
    if (cut && f == sides_[cut->side].end(1 - cut->end)) {  // both halves of a side that is crossed
      for (const int u : ends) join(part({t, v, u}), part({other, g(v), g(u)}));
      return;
    }
    // A side between a tip and another corner is along the part at the latter.
    const int here = is_tip({t, v, ends[0]}) ? ends[1] : ends[0];
    const int there = is_tip({other, g(v), g(ends[0])}) ? ends[1] : ends[0];
    join(part({t, v, here}), part({other, g(v), g(there)}));
  }
  void join(std::size_t a, std::size_t b) {
    neighbours_[a].push_back(b);
    neighbours_[b].push_back(a);
    --euler_[a];
  }

  /// Every end of an edge class once, but those that a curve passes through.
  void add_vertices() {
    for (std::size_t e = 0; e < triangulation_.edge_count(); ++e) {
      const EdgeCorner corner = triangulation_.corners(e)[0];
      const auto [a, b] = topology::kEdgeEnds[corner.edge()];
      const Corner start{corner.tetrahedron(), a, b}, end{corner.tetrahedron(), b, a};
      if (!is_on_curve(e, !corner.reversed())) ++euler_[part(start)];
      if (!is_on_curve(e, corner.reversed())) ++euler_[part(end)];
    }
  }
  bool is_on_curve(std::size_t e, bool is_start) const {
    const Side& side = sides_[0];
    const int opposite = topology::kEdgeNumber[side.p][side.q];
    return e == triangulation_.edge_class(side.t, opposite) &&
           is_cut_[is_start == runs_from_p(triangulation_, side) ? 0 : 1];
  }

  void number_pieces() {
    std::vector<std::size_t> stack;
    for (std::size_t start = 0; start < piece_.size(); ++start) {
      if (piece_[start] != kNone) continue;
      const std::size_t piece = euler_of_piece_.size();
      euler_of_piece_.push_back(0);
      piece_[start] = piece;
      stack.push_back(start);
      while (!stack.empty()) {
        const std::size_t here = stack.back();
        stack.pop_back();
        euler_of_piece_[piece] += euler_[here];
        for (const std::size_t next : neighbours_[here]) {
          if (piece_[next] != kNone) continue;
          piece_[next] = piece;
          stack.push_back(next);
        }
      }
    }
  }
  int euler(std::size_t part) const { return euler_of_piece_[piece_[part]]; }

  const Triangulation& triangulation_;
  const std::array<Side, 2>& sides_;
  const std::array<bool, 2> is_cut_;
  std::vector<std::vector<std::size_t>> neighbours_;  // [parts]
  std::vector<int> euler_;                            // [parts] open triangles, sides, vertices
  std::vector<std::size_t> piece_;                    // [parts]
  std::vector<int> euler_of_piece_;                   // [pieces]
};

ClosedBigon::Consequence consequence_of(const Triangulation& triangulation,
                                        const std::array<Side, 2>& sides) {
  using enum ClosedBigon::Consequence;
  if (runs_from_p(triangulation, sides[0]) != runs_from_p(triangulation, sides[1]))
    return kMoebiusBand;
  const bool disc_at_p = CutLinks(triangulation, sides, {true, false}).has_disc_at(0);
  const bool disc_at_q = CutLinks(triangulation, sides, {false, true}).has_disc_at(1);
  if (disc_at_p != disc_at_q) return kDisc;
  if (disc_at_p) return kNothing;
  const CutLinks both(triangulation, sides, {true, true});
  return both.has_annulus_with_one_end() ? kNothing : kEssentialAnnulus;
}

bool is_in_domain(const Triangulation& triangulation) {
  if (!triangulation.is_connected() || !triangulation.is_orientable()) return false;
  for (std::size_t v = 0; v < triangulation.vertex_count(); ++v)
    if (triangulation.link(v).euler_characteristic > 0) return false;
  return true;
}

}  // namespace

std::string_view surface_name(const ClosedBigon& bigon) {
  return bigon.consequence == ClosedBigon::Consequence::kMoebiusBand ? "moebius band" : "annulus";
}

std::string_view to_string(ClosedBigon::Consequence consequence) {
  switch (consequence) {
    case ClosedBigon::Consequence::kMoebiusBand:
      return "moebius band";
    case ClosedBigon::Consequence::kDisc:
      return "disc";
    case ClosedBigon::Consequence::kEssentialAnnulus:
      return "essential annulus";
    case ClosedBigon::Consequence::kNothing:
      break;
  }
  return "none";
}

std::string message(const ClosedBigon& bigon) {
  const std::string where = fmt::format("crosses edge class {}, of valence 2", bigon.edge);
  switch (bigon.consequence) {
    case ClosedBigon::Consequence::kMoebiusBand:
      return "The manifold is not hyperbolic: a Moebius band " + where + ".";
    case ClosedBigon::Consequence::kDisc:
      return "The manifold is not hyperbolic: an annulus " + where +
             ", of whose curves just one bounds a disc in the boundary.";
    case ClosedBigon::Consequence::kEssentialAnnulus:
      return "The manifold is not hyperbolic: an essential annulus " + where + ".";
    case ClosedBigon::Consequence::kNothing:
      break;
  }
  return "A hint, no more, that the manifold is not hyperbolic: an annulus " + where +
         "; it may be trivial.";
}

std::optional<ClosedBigon> closed_bigon(const Triangulation& triangulation) {
  if (!is_in_domain(triangulation)) return std::nullopt;
  std::optional<ClosedBigon> best;
  for (std::size_t e = 0; e < triangulation.edge_count(); ++e) {
    const auto sides = sides_of(triangulation, e);
    if (!sides) continue;
    const auto opposite = [&](const Side& side) {
      return triangulation.edge_class(side.t, topology::kEdgeNumber[side.p][side.q]);
    };
    if (opposite((*sides)[0]) != opposite((*sides)[1])) continue;
    const ClosedBigon found{consequence_of(triangulation, *sides), static_cast<std::uint32_t>(e),
                            opposite((*sides)[0])};
    if (!best || found.consequence < best->consequence) best = found;
  }
  return best;
}

}  // namespace tripus::structure
