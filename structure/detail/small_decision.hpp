#pragma once

#include <optional>

#include "structure/certificate.hpp"
#include "topology/cone_angle.hpp"
#include "topology/triangulation.hpp"

namespace tripus::structure::detail {

/// What is decided about a triangulation of few tetrahedra without looking for a metric, exactly
/// and in microseconds.
struct SmallDecision {
  /// That there is no strict angle structure; if there is none, there is one.
  std::optional<Certificate> certificate;
  /// Whether the co-volume may have a minimiser, with flat tetrahedra, all the same.
  bool may_be_degenerate = false;
};

/// Nothing beyond SmallProgramme::kMostTetrahedra, where some vertex is not hyperideal or some cone
/// angle not 2 pi, and where numbers grow too large: then others must decide. The certificate has
/// not been checked. Certificates of valence 1 and 2 come without a programme; docs/theory.md
/// section 5.
std::optional<SmallDecision> decide_small(const topology::Triangulation& triangulation,
                                          std::span<const topology::ConeAngle> cone_angles);

/// Whether some edge has a valence that no strict angle structure allows: 1 or 2.
bool has_low_valence(const topology::Triangulation& triangulation);

}  // namespace tripus::structure::detail
