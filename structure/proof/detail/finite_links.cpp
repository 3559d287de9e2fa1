#include "structure/proof/detail/finite_links.hpp"

#include <map>
#include <utility>

#include "geometry/edge_frames.hpp"
#include "topology/disjoint_sets.hpp"

namespace tripus::structure::detail {
namespace {

using geometry::kEdgeBetween;
using topology::Triangulation;

Direction operator+(const Direction& a, const Direction& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Direction operator*(const Arb& factor, const Direction& a) {
  return {factor * a[0], factor * a[1], factor * a[2]};
}
Direction cross(const Direction& a, const Direction& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Direction normalised(const Direction& a) { return (Arb(1.0) / square_root(dot(a, a))) * a; }

struct SineAndCosine {
  Arb sine, cosine;
  explicit SineAndCosine(const Arb& angle) {
    arb_sin_cos(sine.get(), cosine.get(), angle.get(), Precision::bits());
  }
};

/// The triangle in which a tetrahedron meets a small sphere about its vertex v: its corner w is on
/// the edge vw, and its angle there is the dihedral angle.
struct LinkTriangle {
  std::size_t tetrahedron = 0;
  int vertex = 0;
  std::array<Direction, 4> corner{};  // but at `vertex`
};

class Unfolding {
 public:
  Unfolding(const Triangulation& triangulation, const std::vector<std::array<Arb, 6>>& angles)
      : triangulation_(triangulation), angles_(angles) {}

  /// False where the side on which a triangle lies is not known.
  bool run(std::size_t vertex) {
    for (std::size_t t = 0; t < triangulation_.tetrahedron_count() && triangles_.empty(); ++t)
      for (int v = 0; v < 4 && triangles_.empty(); ++v)
        if (triangulation_.vertex_class(t, v) == vertex) take(first(t, v));
    for (std::size_t k = 0; k < triangles_.size(); ++k)
      for (int f = 0; f < 4; ++f)
        if (f != triangles_[k].vertex && !cross_side(k, f)) return false;
    return true;
  }

  /// Ends that are glued together are one.
  std::vector<EdgeEnd> ends() {
    std::map<std::size_t, EdgeEnd> found;
    for (const LinkTriangle& triangle : triangles_)
      for (int w = 0; w < 4; ++w) {
        if (w == triangle.vertex) continue;
        const std::size_t t = triangle.tetrahedron;
        const Direction& here = triangle.corner[static_cast<std::size_t>(w)];
        const auto [at, is_new] = found.try_emplace(
            representative(place(t, triangle.vertex, w)),
            EdgeEnd{triangulation_.edge_class(t, kEdgeBetween[triangle.vertex][w]), here});
        if (is_new) continue;
        for (std::size_t i = 0; i < 3; ++i) {
          Arb& x = at->second.direction[i];
          arb_union(x.get(), x.get(), here[i].get(), Precision::bits());
        }
      }
    std::vector<EdgeEnd> result;
    for (auto& [key, end] : found) result.push_back(std::move(end));
    return result;
  }

 private:
  static std::uint32_t place(std::size_t t, int v, int w) {
    return static_cast<std::uint32_t>(16 * t) + 4 * static_cast<std::uint32_t>(v) +
           static_cast<std::uint32_t>(w);
  }
  std::uint32_t representative(std::uint32_t at) {
    if (ends_.size() == 0) join_ends();
    return ends_.root(at);
  }
  void join_ends() {
    const topology::Gluings& gluings = triangulation_.gluings();
    ends_ = topology::DisjointSets(16 * triangulation_.tetrahedron_count());
    for (std::size_t t = 0; t < triangulation_.tetrahedron_count(); ++t)
      for (int f = 0; f < 4; ++f)
        for (int v = 0; v < 4; ++v)
          for (int w = 0; w < 4; ++w) {
            if (v == w || v == f || w == f) continue;
            const topology::Perm4 gluing = gluings.gluing(t, f);
            ends_.join(place(t, v, w), place(gluings.neighbour(t, f), gluing(v), gluing(w)));
          }
  }

  const Arb& angle(const LinkTriangle& triangle, int w) const {
    return angles_[triangle.tetrahedron]
                  [static_cast<std::size_t>(kEdgeBetween[triangle.vertex][w])];
  }
  /// The side between the corners a and b, by the law of cosines for angles.
  Arb cosine_of_side(const LinkTriangle& triangle, int a, int b) const {
    const int c = 6 - triangle.vertex - a - b;
    const SineAndCosine A(angle(triangle, a)), B(angle(triangle, b)), C(angle(triangle, c));
    return (C.cosine + A.cosine * B.cosine) / (A.sine * B.sine);
  }
  static Arb sine_of_side(const Arb& cosine) { return square_root(Arb(1.0) - square(cosine)); }

  LinkTriangle first(std::size_t t, int v) const {
    LinkTriangle triangle{t, v};
    const int a = v == 0 ? 1 : 0, b = v <= 1 ? 2 : 1, c = 6 - v - a - b;
    const Arb ab = cosine_of_side(triangle, a, b), ac = cosine_of_side(triangle, a, c);
    const SineAndCosine A(angle(triangle, a));
    auto& corner = triangle.corner;
    corner[static_cast<std::size_t>(a)] = {Arb(1.0), Arb(), Arb()};
    corner[static_cast<std::size_t>(b)] = {ab, sine_of_side(ab), Arb()};
    corner[static_cast<std::size_t>(c)] = {ac, sine_of_side(ac) * A.cosine,
                                           sine_of_side(ac) * A.sine};
    return triangle;
  }

  void take(LinkTriangle triangle) {
    known_.resize(4 * triangulation_.tetrahedron_count());
    known_[4 * triangle.tetrahedron + static_cast<std::size_t>(triangle.vertex)] = true;
    triangles_.push_back(std::move(triangle));
  }

  /// Unfolds the triangle beyond the side that lies in face f.
  bool cross_side(std::size_t k, int f) {
    const topology::Gluings& gluings = triangulation_.gluings();
    const std::size_t t = triangles_[k].tetrahedron;
    const int v = triangles_[k].vertex;
    int a = 0;
    while (a == v || a == f) ++a;
    const int b = 6 - v - f - a;
    const topology::Perm4 gluing = gluings.gluing(t, f);
    LinkTriangle next{gluings.neighbour(t, f), gluing(v)};
    if (known_[4 * next.tetrahedron + static_cast<std::size_t>(next.vertex)]) return true;
    const auto& corner = triangles_[k].corner;
    const Direction &at_a = corner[static_cast<std::size_t>(a)],
                    &at_b = corner[static_cast<std::size_t>(b)];
    const Direction normal = cross(at_a, at_b);
    const Arb side = dot(normal, corner[static_cast<std::size_t>(f)]);
    if (!side.positive() && !side.negative()) return false;
    const Direction away = Arb(side.positive() ? -1.0 : 1.0) * normalised(normal);
    const Direction along = normalised(at_b + (-dot(at_a, at_b)) * at_a);
    const Arb reach = cosine_of_side(next, gluing(a), gluing(f));
    const SineAndCosine A(angle(next, gluing(a)));
    next.corner[static_cast<std::size_t>(gluing(a))] = at_a;
    next.corner[static_cast<std::size_t>(gluing(b))] = at_b;
    next.corner[static_cast<std::size_t>(gluing(f))] =
        reach * at_a + sine_of_side(reach) * (A.cosine * along + A.sine * away);
    take(std::move(next));
    return true;
  }

  const Triangulation& triangulation_;
  const std::vector<std::array<Arb, 6>>& angles_;
  std::vector<LinkTriangle> triangles_;
  std::vector<bool> known_;
  topology::DisjointSets ends_;  ///< of edges, at their vertices; empty until they are asked for
};

}  // namespace

Arb dot(const Direction& a, const Direction& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

std::optional<std::vector<EdgeEnd>> unfolded_link(const Triangulation& triangulation,
                                                  std::size_t vertex,
                                                  const std::vector<std::array<Arb, 6>>& angles) {
  Unfolding unfolding(triangulation, angles);
  if (!unfolding.run(vertex)) return std::nullopt;
  auto ends = unfolding.ends();
  for (const EdgeEnd& end : ends)
    for (const Arb& x : end.direction)
      if (!x.finite()) return std::nullopt;
  return ends;
}

}  // namespace tripus::structure::detail
