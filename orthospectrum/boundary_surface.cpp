#include "orthospectrum/boundary_surface.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>
#include <tuple>

#include <Eigen/Dense>

#include "base/tolerances.hpp"
#include "orthospectrum/detail/steps.hpp"

namespace tripus::orthospectrum {
namespace {

double lorentz(const Vector3& x, const Vector3& y) {
  return x[0] * y[0] + x[1] * y[1] - x[2] * y[2];
}

/// Unit normal of the line through two points, on the side of a third.
Vector3 normal_towards(const Vector3& a, const Vector3& b, const Vector3& inside) {
  Vector3 normal = a.cross(b);
  normal[2] = -normal[2];
  normal /= std::sqrt(lorentz(normal, normal));
  return lorentz(normal, inside) < 0 ? Vector3(-normal) : normal;
}

/// sinh of half the distance of two points, twice: keeps its digits for near points.
double chord(const Vector3& x, const Vector3& y) {
  const Vector3 difference = x - y;
  return std::sqrt(std::max(0.0, lorentz(difference, difference)));
}

/// Distance of a point from the segment between two others.
double distance_from_segment(const Vector3& x, const Vector3& a, const Vector3& b) {
  const Vector3 normal = normal_towards(a, b, x);
  const double over = lorentz(normal, x);
  const Vector3 foot = x - over * normal;  // times cosh of the distance
  const double cosh = std::sqrt(1 + over * over), side = -lorentz(a, b);
  if (-lorentz(foot, a) <= side * cosh && -lorentz(foot, b) <= side * cosh) return std::asinh(over);
  return 2 * std::asinh(std::min(chord(x, a), chord(x, b)) / 2);
}

/// Where the middle of a developed tile lies, to tell copies apart: middles of different copies are
/// further apart than this. Beyond the distances that are drawn it would not be.
using Place = std::tuple<std::int64_t, std::int64_t>;
Place place_of(const Matrix3& isometry) {
  constexpr double kCells = 1e6;
  const double z = 1 + isometry(2, 2);
  return {std::llround(kCells * isometry(0, 2) / z), std::llround(kCells * isometry(1, 2) / z)};
}

/// The same place may be rounded to neighbouring cells.
class Places {
 public:
  bool insert(const Matrix3& isometry, Tile tile) {
    const auto [x, y] = place_of(isometry);
    for (std::int64_t dx = -1; dx <= 1; ++dx)
      for (std::int64_t dy = -1; dy <= 1; ++dy)
        if (const auto found = places_.find({x + dx, y + dy});
            found != places_.end() && found->second == tile)
          return false;
    places_[{x, y}] = tile;
    return true;
  }

 private:
  std::map<Place, Tile> places_;
};

}  // namespace

Vector3 point_of(const ArcEnd& end) {
  return Vector3(end.x, end.y, 1) / std::sqrt(1 - end.x * end.x - end.y * end.y);
}

BoundarySurface::BoundarySurface(const topology::Triangulation& triangulation,
                                 std::span<const double> edge_lengths) {
  const detail::Steps steps(triangulation, edge_lengths);
  const std::size_t tiles = 4 * triangulation.tetrahedron_count();
  for (std::size_t n = 0; n < tiles; ++n) {
    const detail::Triangle& triangle = steps.triangle(n / 4, static_cast<int>(n % 4));
    is_tile_.push_back(!steps.is_ideal(n / 4, static_cast<int>(n % 4)));
    vertices_.push_back(triangle.corners);
    Matrix3 corners = Matrix3::Zero();
    for (std::size_t k = 0; k < 3 && is_tile_.back(); ++k) {
      const Vector3 foot(triangle.feet[k][0], triangle.feet[k][1], triangle.feet[k][2]);
      corners.col(column(k)) = foot / std::sqrt(-lorentz(foot, foot));
    }
    corners_.push_back(corners);
  }
  sides_.resize(tiles);
  const auto frame = [](const Vector3& a, const Vector3& b, const Vector3& normal) {
    Matrix3 result;
    result << a, b, normal;
    return result;
  };
  for (std::size_t n = 0; n < tiles; ++n) {
    for (std::size_t k = 0; k < 3 && is_tile_[n]; ++k) {
      const detail::Step& step = steps.step(n / 4, vertices_[n][k]);
      const Tile there{step.tetrahedron, step.labels[n % 4]};
      const auto corner_there = [&](std::size_t c) {
        const std::uint8_t label = step.labels[vertices_[n][c]];
        const auto& labels = vertices_[index(there)];
        return corner(there,
                      static_cast<std::size_t>(std::ranges::find(labels, label) - labels.begin()));
      };
      const Tile here{static_cast<std::uint32_t>(n / 4), static_cast<std::uint32_t>(n % 4)};
      const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
      const Vector3 p = corner(here, a), q = corner(here, b);
      const Vector3 p_there = corner_there(a), q_there = corner_there(b);
      const Matrix3 to = frame(p, q, -normal_towards(p, q, corner(here, k)));
      const Matrix3 from =
          frame(p_there, q_there, normal_towards(p_there, q_there, corner_there(k)));
      sides_[n][k] = {there, to * from.inverse()};
    }
  }
}

std::vector<DevelopedTile> BoundarySurface::develop(Tile from, double radius,
                                                    std::size_t most_tiles) const {
  struct Waiting {
    double cosh;  // of the distance of its middle
    std::size_t order;
    DevelopedTile tile;
    bool operator<(const Waiting& other) const {
      return std::tie(cosh, order) > std::tie(other.cosh, other.order);
    }
  };
  std::priority_queue<Waiting> queue;
  std::size_t order = 0;
  const auto wait = [&](Tile tile, const Matrix3& isometry) {
    queue.push({isometry(2, 2), order++, {tile, isometry, false}});
  };
  std::vector<DevelopedTile> result;
  std::vector<char> seen(sides_.size());
  Places places;
  wait(from, Matrix3::Identity());
  while (!queue.empty()) {
    DevelopedTile next = queue.top().tile;
    const double cosh = queue.top().cosh;
    queue.pop();
    next.first = seen[index(next.tile)] == 0;
    // First copies are never left out; others only lead on within the radius.
    if (!next.first && (cosh > std::cosh(radius) || result.size() >= most_tiles)) continue;
    if (!places.insert(next.isometry, next.tile)) continue;
    seen[index(next.tile)] = 1;
    for (const Side& side : sides_[index(next.tile)])
      wait(side.across, next.isometry * side.isometry);
    result.push_back(next);
  }
  return result;
}

std::vector<DevelopedTile> BoundarySurface::meeting(Tile from, const Vector3& centre,
                                                    double radius) const {
  // What touches the disc from outside does not meet it.
  const double within = radius * (1 - tolerance::kArcReach);
  std::vector<DevelopedTile> result;
  std::vector<DevelopedTile> waiting{{from, Matrix3::Identity(), true}};
  Places places;
  while (!waiting.empty()) {
    const DevelopedTile next = waiting.back();
    waiting.pop_back();
    if (!places.insert(next.isometry, next.tile)) continue;
    result.push_back(next);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3 a = next.isometry * corner(next.tile, (k + 1) % 3);
      const Vector3 b = next.isometry * corner(next.tile, (k + 2) % 3);
      if (distance_from_segment(centre, a, b) >= within) continue;
      const Side& side = sides_[index(next.tile)][k];
      waiting.push_back({side.across, next.isometry * side.isometry, false});
    }
  }
  return result;
}

}  // namespace tripus::orthospectrum
