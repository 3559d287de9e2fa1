#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "meshing/detail/places.hpp"
#include "meshing/surface_mesh.hpp"

namespace tripus::meshing::detail {

/// Two numbers without their order, such as the ends of an edge, as one for tables.
using PairKey = std::uint64_t;

constexpr PairKey pair_key(std::uint32_t a, std::uint32_t b) {
  return a < b ? PairKey{a} << 32 | b : PairKey{b} << 32 | a;
}

/// How the triangles of a closed surface hang together. Side k of a triangle runs from corner k to
/// corner k+1; a side is written 3 * triangle + k.
struct Connectivity {
  std::vector<std::uint32_t> mate;          ///< [3T] the side on the other triangle
  std::vector<std::uint32_t> component_of;  ///< [T] numbered by their first triangles
  std::uint32_t component_count = 0;
  std::vector<bool> turned;  ///< [T] to be turned round so that neighbours agree
};

/// Checks that every edge is in two triangles, that the triangles at every point form one fan, and
/// that the surface is two-sided; triangles are all different. `name` says what a triangle is
/// called in messages, `places` what points and edges are. In O(T log T).
/// Throws InvalidInput.
Connectivity require_closed_manifold(const std::vector<Triangle>& triangles,
                                     std::size_t point_count,
                                     const std::function<std::string(std::size_t)>& name,
                                     const Places& places);

}  // namespace tripus::meshing::detail
