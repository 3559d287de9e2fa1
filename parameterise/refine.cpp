#include "parameterise/refine.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <queue>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "geometry/hyperbolic_space.hpp"
#include "meshing/predicates.hpp"
#include "meshing/validate_tetrahedra.hpp"

namespace tripus::parameterise {
namespace {

using meshing::Tetrahedron;
using topology::slot_of;

/// A tetrahedron of the old mesh, or a part of one.
struct Part {
  Tetrahedron corners;
  std::uint32_t whole;            ///< the old tetrahedron, whose frame it has
  std::array<int, 4> face;        ///< the face of the old one in which this one lies, or -1
  std::array<Vector4, 4> images;  ///< of the corners, in that frame
};

std::size_t place_of(const Tetrahedron& corners, std::uint32_t point) {
  return static_cast<std::size_t>(std::ranges::find(corners, point) - corners.begin());
}

/// The mesh while its edges are bisected.
class Bisection {
 public:
  Bisection(const MarkedSolid& solid, const std::vector<Vector4>& map)
      : points_(solid.mesh.points), parts_at_(solid.mesh.points.size()) {
    parts_.reserve(2 * solid.mesh.tetrahedra.size());
    for (std::uint32_t t = 0; t < solid.mesh.tetrahedra.size(); ++t) {
      Part part{solid.mesh.tetrahedra[t], t, {0, 1, 2, 3}, {}};
      for (std::size_t v = 0; v < 4; ++v) {
        part.images[v] = solid.group->matrix(solid.corners[4 * t + v]) * map[part.corners[v]];
        parts_at_[part.corners[v]].push_back(t);
      }
      parts_.push_back(part);
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = i + 1; j < 4; ++j) push(part, i, j);
    }
  }

  void run(std::size_t tetrahedra) {
    while (parts_.size() < tetrahedra && !longest_.empty()) {
      const Edge edge = longest_.top();
      longest_.pop();
      find_star(edge.a, edge.b);
      if (!star_.empty()) bisect(edge.a, edge.b);
    }
  }

  const std::vector<Part>& parts() const { return parts_; }
  const std::vector<meshing::Point>& points() const { return points_; }

 private:
  struct Edge {
    double length;
    std::uint32_t a, b;
    friend auto operator<=>(const Edge&, const Edge&) = default;
  };

  void push(const Part& part, std::size_t i, std::size_t j) {
    const auto [a, b] = std::minmax(part.corners[i], part.corners[j]);
    longest_.push({geometry::hyperbolic_distance(part.images[i], part.images[j]), a, b});
  }

  /// The parts around an edge; none if it was bisected before.
  void find_star(std::uint32_t a, std::uint32_t b) {
    if (parts_at_[b].size() < parts_at_[a].size()) std::swap(a, b);
    // A part has left the ends of the edges that were bisected in it.
    std::erase_if(parts_at_[a], [&](std::uint32_t n) {
      return std::ranges::find(parts_[n].corners, a) == parts_[n].corners.end();
    });
    star_.clear();
    for (const std::uint32_t n : parts_at_[a])
      if (std::ranges::find(parts_[n].corners, b) != parts_[n].corners.end()) star_.push_back(n);
  }

  bool is_positive(const Tetrahedron& corners) const {
    return meshing::orientation(points_[corners[0]], points_[corners[1]], points_[corners[2]],
                                points_[corners[3]]) > 0;
  }

  void bisect(std::uint32_t a, std::uint32_t b) {
    meshing::Point halfway;
    for (std::size_t k = 0; k < 3; ++k) halfway[k] = points_[a][k] / 2 + points_[b][k] / 2;
    const auto middle = static_cast<std::uint32_t>(points_.size());
    points_.push_back(halfway);
    for (const std::uint32_t n : star_)
      for (const std::uint32_t end : {a, b}) {
        Tetrahedron half = parts_[n].corners;
        half[place_of(half, end)] = middle;
        if (is_positive(half)) continue;
        points_.pop_back();
        return;
      }
    parts_at_.emplace_back();
    for (const std::uint32_t n : star_) {
      const std::size_t i = place_of(parts_[n].corners, a), j = place_of(parts_[n].corners, b);
      const Vector4 sum = parts_[n].images[i] + parts_[n].images[j];
      const Vector4 image = sum / std::sqrt(-geometry::lorentz_product(sum, sum));
      Part& at_a = parts_[n];
      Part at_b = at_a;
      // Each half keeps the face across the middle from its end; the other is the cut.
      at_a.corners[j] = at_b.corners[i] = middle;
      at_a.images[j] = at_b.images[i] = image;
      at_a.face[i] = at_b.face[j] = -1;
      for (std::size_t k = 0; k < 4; ++k)
        if (k != j) push(at_a, j, k);
      push(at_b, i, j);
      const auto next = static_cast<std::uint32_t>(parts_.size());
      parts_at_[middle].push_back(n);
      for (const std::uint32_t corner : at_b.corners) parts_at_[corner].push_back(next);
      parts_.push_back(at_b);
    }
  }

  std::vector<meshing::Point> points_;
  std::vector<Part> parts_;
  std::vector<std::vector<std::uint32_t>> parts_at_;  ///< each point; some have left it
  std::priority_queue<Edge> longest_;
  std::vector<std::uint32_t> star_;
};

/// The pole of a boundary plane, as exact as its truncation.
Vector4 exact(DeckGroup& group, const Vector4& pole) {
  const auto found = group.exact_pole(pole);
  return found ? Vector4(group.matrix(found->element) * found->pole) : pole;
}

}  // namespace

void require_refinable(std::size_t tetrahedra) {
  if (tetrahedra > kMostRefined)
    throw InvalidInput("a mesh is refined to at most " + std::to_string(kMostRefined) +
                       " tetrahedra, not " + std::to_string(tetrahedra));
}

void refine(MarkedSolid& solid, std::vector<Vector4>& points, std::size_t tetrahedra) {
  require_refinable(tetrahedra);
  Bisection bisection(solid, points);
  bisection.run(tetrahedra);
  const std::vector<Part>& parts = bisection.parts();
  DeckGroup& group = *solid.group;
  const std::size_t old_points = points.size();
  const std::vector<Tetrahedron> wholes = std::move(solid.mesh.tetrahedra);
  const std::vector<std::uint32_t> old_values = std::move(solid.values);
  const std::vector<std::uint32_t> old_corners = std::move(solid.corners);

  solid.mesh.points = bisection.points();
  solid.mesh.tetrahedra.clear();
  for (const Part& part : parts) solid.mesh.tetrahedra.push_back(part.corners);
  solid.gluings = meshing::gluings_of(solid.mesh);
  solid.values.assign(4 * parts.size(), 0);
  solid.corners.assign(4 * parts.size(), kNoFrame);
  for (std::size_t t = 0; t < parts.size(); ++t) {
    const Part& part = parts[t];
    for (std::size_t v = 0; v < 4; ++v) {
      if (part.face[v] >= 0)
        solid.values[4 * t + v] = old_values[slot_of(part.whole, part.face[v])];
      if (part.corners[v] < old_points)
        solid.corners[4 * t + v] =
            old_corners[4 * part.whole + place_of(wholes[part.whole], part.corners[v])];
    }
  }
  give_frames(solid);

  points.resize(solid.mesh.points.size(), Vector4::Zero());
  solid.poles.resize(points.size(), Vector4::Zero());
  for (std::size_t t = 0; t < parts.size(); ++t) {
    const Part& part = parts[t];
    for (std::size_t v = 0; v < 4; ++v) {
      const std::uint32_t point = part.corners[v];
      if (point < old_points) continue;
      const std::uint32_t back = group.inverse(solid.corners[4 * t + v]);
      if (points[point].isZero(0))
        points[point] = geometry::on_hyperboloid(group.matrix(back) * part.images[v]);
      for (std::size_t f = 0; f < 4; ++f) {
        if (f == v || !solid.gluings.is_open(t, static_cast<int>(f)) ||
            !solid.poles[point].isZero(0))
          continue;
        // The face lies in one of the old boundary, which lies on one plane.
        const std::size_t u = static_cast<std::size_t>(part.face[f] + 1) % 4;
        const Vector4& pole = solid.poles[wholes[part.whole][u]];
        if (pole.isZero(0)) continue;
        const std::uint32_t way = group.product(back, old_corners[4 * part.whole + u]);
        solid.poles[point] = exact(group, group.matrix(way) * pole);
      }
    }
  }
  solid.start = points;
}

}  // namespace tripus::parameterise
