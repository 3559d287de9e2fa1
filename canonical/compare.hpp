#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "canonical/canonize.hpp"

namespace tripus::canonical {

enum class Verdict { kHomeomorphic, kDifferent, kUnresolved };
std::string_view to_string(Verdict verdict);

/// Whether two manifolds are homeomorphic, and how it was decided.
struct Comparison {
  Verdict verdict = Verdict::kUnresolved;
  /// What decided: "boundary", "orientability", "homology", "orthospectrum", "volume",
  /// "decomposition", "triangulation"; empty if nothing did.
  std::string decided_by;
  std::string message;  ///< one sentence for a person
  /// The isometry as a map of the cells of the first manifold to those of the second.
  std::optional<CellMap> isometry;
  /// Whether one keeps the orientations that the labels 0123 of tetrahedron 0 give, and whether one
  /// reverses them. Both false where there are no orientations, or nothing was found.
  bool keeps_orientation = false;
  bool reverses_orientation = false;
  /// The two manifolds as far as they had to be computed.
  std::optional<CanonicalManifold> first, second;
};

/// Invariants are compared from the cheapest on: the genera of the boundary components,
/// orientability, first homology, for large triangulations the shortest orthogonal arcs, volume,
/// canonical decomposition.
/// "Different" by volume or by decomposition and "homeomorphic" by decomposition rest on
/// floating-point metrics and on tilt signs with the margins of FaceKinds.
/// Throws InvalidInput for triangulations that structure::solve refuses.
Comparison compare(const topology::Triangulation& first, const topology::Triangulation& second,
                   const CanonizeOptions& options = {});

}  // namespace tripus::canonical
