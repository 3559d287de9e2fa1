#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "topology/cone_angle.hpp"
#include "topology/triangulation.hpp"

namespace tripus::structure {

/// What a theorem says of a triangulation from the valences of its edges alone, before anything is
/// computed.
struct ValenceTheorem {
  enum class Claim {
    kGeometric,   ///< this triangulation carries the metric
    kHyperbolic,  ///< the manifold is hyperbolic; of this triangulation nothing is said
  };
  enum class Condition {
    kAtLeastNine,  ///< geodesic boundary only, all valences >= 9: geometric [V9]
    kAlike,        ///< docs/theory.md (119): geometric
    kAtLeastSix,   ///< geodesic boundary only, all valences >= 6: hyperbolic [V6]
  };
  Condition condition = Condition::kAtLeastSix;
  std::size_t least_valence = 0;  ///< of the edge classes
  Claim claim() const;
  /// What proves it.
  std::string_view source() const;
};
/// "geometric" or "hyperbolic".
std::string_view to_string(ValenceTheorem::Claim claim);
/// A sentence for a person, with the source.
std::string message(const ValenceTheorem& theorem);

/// Geodesic boundary or cusps (no finite vertex) and no cone angles but 2 pi; the first condition
/// that holds, nothing where none does. O(T). Source: docs/theory.md section 5.
std::optional<ValenceTheorem> valence_theorem(
    const topology::Triangulation& triangulation,
    std::span<const topology::ConeAngle> cone_angles = {});

}  // namespace tripus::structure
