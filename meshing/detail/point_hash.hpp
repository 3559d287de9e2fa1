#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "meshing/surface_mesh.hpp"

namespace tripus::meshing::detail {

/// Of points without -0, which is equal to 0.
struct PointHash {
  std::size_t operator()(const Point& p) const {
    std::uint64_t hash = 0x9e3779b97f4a7c15u;
    for (const double x : p) {
      hash ^= std::bit_cast<std::uint64_t>(x);
      hash *= 0xff51afd7ed558ccdu;
      hash ^= hash >> 32;
    }
    return static_cast<std::size_t>(hash);
  }
};

}  // namespace tripus::meshing::detail
