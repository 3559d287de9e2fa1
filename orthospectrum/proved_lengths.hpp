#pragma once

#include <optional>
#include <string>
#include <vector>

#include "orthospectrum/spectrum.hpp"
#include "structure/proof/proof.hpp"

namespace tripus::orthospectrum {

/// Lengths of arcs with every rounding accounted for. That there are no further arcs in between is
/// not proved.
struct ProvedLengths {
  bool proved = false;                                     ///< the metric, and every length
  std::string reason;                                      ///< why not; empty if proved
  std::vector<std::optional<structure::Interval>> arcs{};  ///< [arcs] as in Spectrum::arcs

  /// All lengths of a group; nothing unless each is proved.
  std::optional<structure::Interval> of(const Grouping& grouping, const ArcGroup& group) const;
};

/// Proves the metric, and from it the length of each arc by its way through the faces.
///   spectrum  of this triangulation and these lengths, with arcs and faces kept
ProvedLengths prove_lengths(const topology::Triangulation& triangulation,
                            std::span<const double> edge_lengths, const Spectrum& spectrum,
                            const Context& context = {});

}  // namespace tripus::orthospectrum
