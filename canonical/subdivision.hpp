#pragma once

#include <string>

#include "canonical/decomposition.hpp"
#include "canonical/isometries.hpp"
#include "topology/gluings.hpp"

namespace tripus::canonical {

/// Cuts the cells into tetrahedra, in a way that depends on the isomorphism class of the
/// decomposition alone. Without new vertices wherever that works for the cells one after the other,
/// as it does for pyramids and polyhedra with triangular faces only; a cell for which it does not
/// is coned from a new, finite vertex inside. Tetrahedra by themselves stay as they are.
///
/// If the decomposition is orientable, the labels 0123 of every tetrahedron have the orientation of
/// the flag order.flags[0].
/// Source: docs/canonical.md section 4.
topology::Gluings subdivision(const Decomposition& decomposition, const CanonicalOrder& order);

/// The same with the cone angles [E] of its edge classes; empty if the decomposition has none.
struct LabelledSubdivision {
  topology::Triangulation triangulation;
  std::vector<topology::ConeAngle> cone_angles;
};
LabelledSubdivision labelled_subdivision(const Decomposition& decomposition,
                                         const CanonicalOrder& order);

/// A complete invariant of the manifold that decodes to a triangulation of it.
struct IsometrySignature {
  /// The isomorphism signature of the subdivision, which is the canonical triangulation itself
  /// where all cells are tetrahedra. Two manifolds are homeomorphic exactly when these are equal.
  /// With cone angles the labelled one (topology::labelled_isosig).
  std::string unoriented;
  /// The same and a sign: "+" if an isometry that keeps orientations carries the decoded
  /// triangulation, with the labels 0123 of tetrahedron 0 positive, to the manifold, with those of
  /// the tetrahedron 0 that it was given with; "-" if it does so for the mirror image. No sign if
  /// both do, or if there are no orientations.
  std::string oriented;
};

IsometrySignature isometry_signature(const Decomposition& decomposition,
                                     const CanonicalOrder& order, bool is_amphicheiral);

}  // namespace tripus::canonical
