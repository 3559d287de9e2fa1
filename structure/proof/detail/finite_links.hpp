#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "structure/proof/detail/arb_number.hpp"
#include "structure/proof/detail/cone_metric.hpp"

namespace tripus::structure::detail {

/// Enclosures of a vector.
using Direction = std::array<Arb, 3>;
Arb dot(const Direction& a, const Direction& b);

/// An edge class that ends at a vertex, and in which direction: of all places at which the end
/// appears when the link is unfolded from one triangle, the least box.
struct EdgeEnd {
  std::size_t edge = 0;
  Direction direction;
};

/// The ends of all edges at a finite vertex class; nothing where an enclosure is too wide.
///   angles  [T] dihedral angles
/// Source: docs/theory.md 9.8.
std::optional<std::vector<EdgeEnd>> unfolded_link(
    const topology::Triangulation& triangulation, std::size_t vertex,
    const std::vector<std::array<Arb, 6>>& angles);

}  // namespace tripus::structure::detail
