#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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
  std::string message;                                  ///< one sentence for a person
  structure::Advice advice = structure::Advice::kNone;  ///< where nothing was found
  /// The isometry as a map of the cells of the first manifold to those of the second.
  std::optional<CellMap> isometry;
  /// Whether one keeps the orientations that the labels 0123 of tetrahedron 0 give, and whether one
  /// reverses them. Both false where there are no orientations, or nothing was found.
  bool keeps_orientation = false;
  bool reverses_orientation = false;
  /// False if the two above rest on an orientation that is not known: see Orientations.
  bool orientations_known = true;
  /// The two manifolds as far as they had to be computed.
  std::optional<CanonicalManifold> first, second;
};

/// An isometry between two manifolds, by what it does to their canonical decompositions.
struct Isometry {
  CellMap cells;
  std::vector<std::uint32_t> boundary_images;  ///< [V] of the vertex classes of `triangulation`
  /// Whether it keeps the orientations that the labels 0123 of tetrahedron 0 give; meaningless for
  /// manifolds that are not orientable.
  bool keeps_orientation = false;
};

/// All isometries, as many as the isometry group has elements; none if the manifolds, or their cone
/// angles, are not the same.
std::vector<Isometry> isometries(const CanonicalManifold& from, const CanonicalManifold& to);

/// Whether the labels of both triangulations mean orientations. A signature without a sign says
/// nothing about them; an isometry of chiral manifolds then may keep or reverse them.
enum class Orientations { kKnown, kNotKnown };

/// A triangulation and the cone angles [E] of its edge classes; empty for 2 pi everywhere.
struct Labelled {
  const topology::Triangulation& triangulation;
  std::vector<topology::ConeAngle> cone_angles;
};

/// Invariants are compared from the cheapest on: the boundary components (what is not a sphere
/// among the vertex links), orientability, first homology, for large triangulations the shortest
/// orthogonal arcs, volume, canonical decomposition. Where that of one or both was not found, a
/// triangulation is looked for that moves reach from both. "Different" by volume or by
/// decomposition and "homeomorphic" by decomposition rest on floating-point metrics and on tilt
/// signs with the margins of FaceKinds. Throws what `require_canonizable` does, unless the
/// boundary, orientability or homology decides.
Comparison compare(const topology::Triangulation& first, const topology::Triangulation& second,
                   const CanonizeOptions& options = {},
                   Orientations orientations = Orientations::kKnown);
/// The same for orbifolds: "homeomorphic" then means that singular edges go to singular edges with
/// the same cone angles. Only what is left of the invariants then is compared.
Comparison compare(const Labelled& first, const Labelled& second,
                   const CanonizeOptions& options = {},
                   Orientations orientations = Orientations::kKnown);

}  // namespace tripus::canonical
