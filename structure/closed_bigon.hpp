#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "topology/triangulation.hpp"

namespace tripus::structure {

/// A surface that an edge of valence 2 carries if its two opposite edges are one edge class: the
/// bigon between these closes to an annulus or a Moebius band, properly embedded in the manifold,
/// that meets the edge exactly once. docs/theory.md section 5.1.
struct ClosedBigon {
  /// What follows about the manifold.
  enum class Consequence {
    kMoebiusBand,       ///< a Moebius band: no hyperbolic manifold contains one
    kDisc,              ///< one curve bounds a disc in the boundary, the other does not
    kEssentialAnnulus,  ///< its curves bound no discs, and it is parallel to no part of the
                        ///< boundary
    kNothing,           ///< an annulus, perhaps a trivial one: a hint, no more
  };
  Consequence consequence = Consequence::kNothing;
  std::uint32_t edge = 0;      ///< edge class of valence 2, which the surface meets once
  std::uint32_t opposite = 0;  ///< edge class that lies in the surface
  /// Whether it proves that the manifold is not hyperbolic.
  bool decides() const { return consequence != Consequence::kNothing; }
  friend bool operator==(const ClosedBigon&, const ClosedBigon&) = default;
};
/// "moebius band" or "annulus".
std::string_view surface_name(const ClosedBigon& bigon);
/// "moebius band", "disc", "essential annulus" or "none".
std::string_view to_string(ClosedBigon::Consequence consequence);
/// A sentence for a person: what was found, and what follows.
std::string message(const ClosedBigon& bigon);

/// The closed bigon with the first consequence in the order above; nothing if there is none. Exact,
/// in O(T) for each edge of valence 2 that closes up. Only for connected orientable triangulations
/// without finite vertices; nothing for others. Source: docs/theory.md section 5.1, (110)-(112).
std::optional<ClosedBigon> closed_bigon(const topology::Triangulation& triangulation);

}  // namespace tripus::structure
