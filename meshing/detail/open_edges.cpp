#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <unordered_map>

#include "base/tolerances.hpp"
#include "meshing/detail/connectivity.hpp"
#include "meshing/detail/mending.hpp"
#include "meshing/detail/polygon.hpp"

namespace tripus::meshing::detail {
namespace {

double square_distance(const Point& a, const Point& b) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return sum;
}

std::vector<std::uint32_t> ends_of(const SurfaceMesh& mesh, const std::vector<OpenEdge>& open) {
  std::vector<std::uint32_t> ends;
  for (const OpenEdge& edge : open)
    for (const std::uint32_t k : {edge.side, (edge.side + 1) % 3})
      ends.push_back(mesh.triangles[edge.triangle][k]);
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  return ends;
}

using Cell = std::array<std::int64_t, 3>;

struct CellHash {
  std::size_t operator()(const Cell& cell) const {
    std::uint64_t hash = 0x9e3779b97f4a7c15u;
    for (const std::int64_t x : cell) {
      hash ^= static_cast<std::uint64_t>(x);
      hash *= 0xff51afd7ed558ccdu;
      hash ^= hash >> 32;
    }
    return static_cast<std::size_t>(hash);
  }
};

/// A point in the middle of a side: its place along it, from 0 to 1.
struct OnSide {
  double along;
  std::uint32_t point;
};

/// Where a point lies on the segment a b, at most so far from it and farther from its ends.
double place_on(const Point& a, const Point& b, const Point& p, double distance) {
  constexpr double kNowhere = -1;
  const double square = distance * distance, length = square_distance(a, b);
  if (square_distance(a, p) <= square || square_distance(b, p) <= square) return kNowhere;
  double along = 0;
  for (std::size_t k = 0; k < 3; ++k) along += (p[k] - a[k]) * (b[k] - a[k]);
  along /= length;
  if (!(along > 0 && along < 1)) return kNowhere;
  Point foot;
  for (std::size_t k = 0; k < 3; ++k) foot[k] = a[k] + along * (b[k] - a[k]);
  // Rounding of the foot alone, where the points lie exactly on the side.
  const double rounding = 1e-30 * (length + square_distance(a, Point{}));
  return square_distance(foot, p) <= square + rounding ? along : kNowhere;
}

/// The ends of open edges by their coordinate along the longest axis.
class Candidates {
 public:
  Candidates(const SurfaceMesh& mesh, const std::vector<std::uint32_t>& ends)
      : mesh_(mesh), ends_(ends) {
    Point low = mesh.points[ends[0]], high = low;
    for (const std::uint32_t end : ends)
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], mesh.points[end][k]);
        high[k] = std::max(high[k], mesh.points[end][k]);
      }
    for (std::size_t k = 1; k < 3; ++k)
      if (high[k] - low[k] > high[axis_] - low[axis_]) axis_ = k;
    std::sort(ends_.begin(), ends_.end(), [&](std::uint32_t a, std::uint32_t b) {
      return coordinate(a) != coordinate(b) ? coordinate(a) < coordinate(b) : a < b;
    });
  }

  /// The points on the side from a to b, in order. Spends `work`; nothing once it is used up.
  std::vector<OnSide> on(std::uint32_t a, std::uint32_t b, double distance,
                         std::size_t& work) const {
    const double low = std::min(coordinate(a), coordinate(b)) - distance;
    const double high = std::max(coordinate(a), coordinate(b)) + distance;
    auto end = std::lower_bound(ends_.begin(), ends_.end(), low,
                                [&](std::uint32_t e, double x) { return coordinate(e) < x; });
    std::vector<OnSide> found;
    for (; end != ends_.end() && coordinate(*end) <= high && work > 0; ++end, --work) {
      if (*end == a || *end == b) continue;
      const double along = place_on(mesh_.points[a], mesh_.points[b], mesh_.points[*end], distance);
      if (along > 0) found.push_back({along, *end});
    }
    std::sort(found.begin(), found.end(),
              [](const OnSide& x, const OnSide& y) { return x.along < y.along; });
    return found;
  }

 private:
  double coordinate(std::uint32_t point) const { return mesh_.points[point][axis_]; }

  const SurfaceMesh& mesh_;
  std::vector<std::uint32_t> ends_;
  std::size_t axis_ = 0;
};

}  // namespace

Edges edges_of(const std::vector<Triangle>& triangles) {
  std::vector<std::pair<PairKey, OpenEdge>> sides;
  sides.reserve(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k) {
      sides.push_back({pair_key(triangles[t][k], triangles[t][(k + 1) % 3]), {t, k}});
    }
  std::sort(sides.begin(), sides.end(),
            [](const auto& x, const auto& y) { return x.first < y.first; });
  Edges edges;
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    while (end < sides.size() && sides[end].first == sides[i].first) ++end;
    if (end - i == 1) edges.open.push_back(sides[i].second);
    edges.is_crowded |= end - i > 2;
  }
  std::sort(edges.open.begin(), edges.open.end(), [](const OpenEdge& x, const OpenEdge& y) {
    return x.triangle != y.triangle ? x.triangle < y.triangle : x.side < y.side;
  });
  return edges;
}

std::size_t weld(SurfaceMesh& mesh, const std::vector<OpenEdge>& open, double distance) {
  std::unordered_map<Cell, std::vector<std::uint32_t>, CellHash> grid;
  std::unordered_map<std::uint32_t, std::uint32_t> number;
  for (const std::uint32_t end : ends_of(mesh, open)) {
    Cell cell;
    for (std::size_t k = 0; k < 3; ++k)
      cell[k] = static_cast<std::int64_t>(
          std::clamp(std::floor(mesh.points[end][k] / distance), -9e18, 9e18));
    double nearest = distance * distance;
    std::uint32_t found = end;
    for (int n = 0; n < 27; ++n) {
      const auto place =
          grid.find({cell[0] + n % 3 - 1, cell[1] + n / 3 % 3 - 1, cell[2] + n / 9 - 1});
      if (place == grid.end()) continue;
      for (const std::uint32_t other : place->second) {
        const double apart = square_distance(mesh.points[end], mesh.points[other]);
        if (apart > nearest) continue;
        nearest = apart;
        found = other;
      }
    }
    if (found == end) {
      grid[cell].push_back(end);
    } else {
      number[end] = found;
    }
  }
  if (!number.empty())
    for (Triangle& t : mesh.triangles)
      for (std::uint32_t& corner : t)
        if (const auto other = number.find(corner); other != number.end()) corner = other->second;
  return number.size();
}

std::size_t split_at_points(SurfaceMesh& mesh, std::vector<std::uint32_t>& cell_of,
                            const std::vector<OpenEdge>& open, double distance) {
  if (open.empty()) return 0;
  const Candidates candidates(mesh, ends_of(mesh, open));
  std::size_t work = 200'000'000;  // comparisons: a second
  std::map<std::uint32_t, std::array<std::vector<OnSide>, 3>> split;
  for (const OpenEdge& edge : open) {
    const Triangle& t = mesh.triangles[edge.triangle];
    auto points = candidates.on(t[edge.side], t[(edge.side + 1) % 3], distance, work);
    if (!points.empty()) split[edge.triangle][edge.side] = std::move(points);
  }
  if (work == 0) return 0;
  std::vector<Triangle> parts;
  for (const auto& [triangle, sides] : split) {
    std::vector<std::uint32_t> polygon;
    std::vector<std::uint8_t> on;  // the sides of the triangle that each corner lies on
    for (std::size_t k = 0; k < 3; ++k) {
      const auto side = static_cast<std::uint8_t>(1u << k);
      const auto last = static_cast<std::uint8_t>(1u << (k + 2) % 3);
      polygon.push_back(mesh.triangles[triangle][k]);
      on.push_back(side | last);
      for (const OnSide& each : sides[k]) {
        polygon.push_back(each.point);
        on.push_back(side);
      }
    }
    if (polygon.size() > kMostCorners) return 0;
    parts.clear();
    cut_polygon(mesh.points, polygon, parts, on);
    mesh.triangles[triangle] = parts[0];
    for (std::size_t i = 1; i < parts.size(); ++i) {
      mesh.triangles.push_back(parts[i]);
      cell_of.push_back(cell_of[triangle]);
    }
  }
  return split.size();
}

}  // namespace tripus::meshing::detail
