#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/hyperbolic_space.hpp"

namespace tripus::embedding::detail {

/// A set of points of R^3 that are at least `separation` apart, but for errors: tells whether a
/// point is new. What lies within a quarter of the separation of a point is that point. A hash
/// table of cubes so small that a cube holds at most one point.
class PositionTable {
 public:
  explicit PositionTable(double separation)
      : reach_(separation / 4), cube_(separation / 2), slots_(1024, kEmpty) {}

  /// Adds the point, unless it is there: then returns how far off it is. Points are numbered 0, 1,
  /// 2,
  /// ... as they are added.
  std::optional<double> insert(const geometry::Vector3& point) {
    const Cube low = cube_of(point - geometry::Vector3::Constant(reach_));
    const Cube high = cube_of(point + geometry::Vector3::Constant(reach_));
    for (std::int64_t x = low.x; x <= high.x; ++x)
      for (std::int64_t y = low.y; y <= high.y; ++y)
        for (std::int64_t z = low.z; z <= high.z; ++z)
          if (const auto distance = distance_within({x, y, z}, point)) return distance;
    if (2 * (points_.size() + 1) > slots_.size()) grow();
    points_.push_back(point);
    put(static_cast<std::uint32_t>(points_.size() - 1));
    return std::nullopt;
  }

 private:
  static constexpr std::uint32_t kEmpty = 0xffffffffu;
  struct Cube {
    std::int64_t x, y, z;
    friend bool operator==(const Cube&, const Cube&) = default;
  };

  // Coordinates are far below separation / epsilon where points can still be told apart, so the
  // numbers of the cubes fit.
  Cube cube_of(const geometry::Vector3& point) const {
    return {static_cast<std::int64_t>(std::floor(point[0] / cube_)),
            static_cast<std::int64_t>(std::floor(point[1] / cube_)),
            static_cast<std::int64_t>(std::floor(point[2] / cube_))};
  }

  std::size_t slot_of(const Cube& cube) const {
    std::uint64_t hash = 0;
    for (const std::int64_t c : {cube.x, cube.y, cube.z}) {
      hash = (hash ^ static_cast<std::uint64_t>(c)) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 32;
    }
    return static_cast<std::size_t>(hash) & (slots_.size() - 1);
  }

  /// Distance to a point in the reach whose slot the cube leads to.
  std::optional<double> distance_within(const Cube& cube, const geometry::Vector3& point) const {
    for (std::size_t slot = slot_of(cube); slots_[slot] != kEmpty;
         slot = (slot + 1) & (slots_.size() - 1)) {
      const double distance = (points_[slots_[slot]] - point).norm();
      if (distance <= reach_) return distance;
    }
    return std::nullopt;
  }

  void put(std::uint32_t number) {
    std::size_t slot = slot_of(cube_of(points_[number]));
    while (slots_[slot] != kEmpty) slot = (slot + 1) & (slots_.size() - 1);
    slots_[slot] = number;
  }

  void grow() {
    slots_.assign(2 * slots_.size(), kEmpty);
    for (std::uint32_t n = 0; n < points_.size(); ++n) put(n);
  }

  double reach_, cube_;
  std::vector<geometry::Vector3> points_;
  std::vector<std::uint32_t> slots_;
};

}  // namespace tripus::embedding::detail
