#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "structure/proof/proof.hpp"

namespace tripus::structure {

/// A way from the truncation of a vertex of a tetrahedron across faces, each of the tetrahedron
/// that the way is in, to the truncation of a vertex of the last one.
struct ArcPath {
  std::size_t tetrahedron = 0;
  int start = 0;
  std::span<const std::uint8_t> faces;
  int end = 0;
};

/// For each way an enclosure of the length of the geodesic arc that leads from the one boundary
/// plane to the other at right angles to both: all such ways between the same two planes are one
/// arc. Nothing where the enclosure does not tell the two planes apart. At most some 400 edge
/// classes use lengths of 50 digits, more those of the proof, which serve for short ways only.
///   proof  of this triangulation, proved, claim kMetric
/// Throws InvalidInput for a way that is none. Source: docs/orthospectrum.md section 5.
std::vector<std::optional<Interval>> prove_arc_lengths(const topology::Triangulation& triangulation,
                                                       const Proof& proof,
                                                       std::span<const ArcPath> paths,
                                                       const Context& context = {});

}  // namespace tripus::structure
