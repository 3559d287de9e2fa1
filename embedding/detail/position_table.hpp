#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/hyperbolic_space.hpp"

namespace tripus::embedding::detail {

/// A set of points of R^3 that are known to be at least `separation` apart, each known up to a
/// small error: tells whether a point is new. A hash table of cubes so small that a cube holds at
/// most one point; a point near a wall of its cube is also looked for on the other side.
class PositionTable {
 public:
  explicit PositionTable(double separation) : cube_(separation / 2), slots_(1024, kEmpty) {}

  /// Adds the point with its number (the numbers are 0, 1, 2, ... in turn) and returns true, unless
  /// a point within `error` < separation / 4 of it is there.
  bool insert(const geometry::Vector3& point, std::uint32_t number, double error) {
    const Cube low = cube_of(point - geometry::Vector3::Constant(error));
    const Cube high = cube_of(point + geometry::Vector3::Constant(error));
    for (std::int64_t x = low.x; x <= high.x; ++x)
      for (std::int64_t y = low.y; y <= high.y; ++y)
        for (std::int64_t z = low.z; z <= high.z; ++z)
          if (holds_near({x, y, z}, point, error)) return false;
    if (2 * (points_.size() + 1) > slots_.size()) grow();
    points_.push_back(point);
    put(number);
    return true;
  }

 private:
  static constexpr std::uint32_t kEmpty = 0xffffffffu;
  struct Cube {
    std::int64_t x, y, z;
    friend bool operator==(const Cube&, const Cube&) = default;
  };

  // Coordinates are at most separation / (8 * 64 epsilon) where points can still be told apart, so
  // the numbers of the cubes fit.
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

  bool holds_near(const Cube& cube, const geometry::Vector3& point, double error) const {
    for (std::size_t slot = slot_of(cube); slots_[slot] != kEmpty;
         slot = (slot + 1) & (slots_.size() - 1)) {
      const geometry::Vector3& other = points_[slots_[slot]];
      if ((other - point).cwiseAbs().maxCoeff() <= error) return true;
    }
    return false;
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

  double cube_;
  std::vector<geometry::Vector3> points_;
  std::vector<std::uint32_t> slots_;
};

}  // namespace tripus::embedding::detail
