#pragma once

#include <optional>
#include <string>
#include <vector>

#include "canonical/decomposition.hpp"
#include "canonical/isometries.hpp"
#include "canonical/proto_canonical.hpp"
#include "canonical/subdivision.hpp"
#include "structure/retriangulate.hpp"
#include "structure/solve.hpp"

namespace tripus::canonical {

struct CanonizeOptions {
  structure::SolveOptions solve;  ///< `evidence`: that of an input for which nothing is found
  /// Whether to look for other triangulations of the manifold, smaller ones first, where this one
  /// carries no metric.
  bool retriangulate = true;
  structure::RetriangulateOptions retriangulation;  ///< budget and seed of that
  ProtoCanonicalOptions proto_canonical;
};

/// A hyperbolic manifold with geodesic boundary, cusps or both, or an orbifold whose singular edges
/// are edges of its triangulation, known up to isometry.
struct CanonicalManifold {
  topology::Triangulation triangulation;              ///< subdivides the canonical decomposition
  structure::Report report;                           ///< the metric on it
  std::vector<topology::ConeAngle> cone_angles = {};  ///< [E] of it; empty for 2 pi everywhere
  double volume_error = 0;                            ///< estimate of what the volume may be off
  FaceKinds faces;                                    ///< with the margins of every decision
  /// Where the path starts: the input, made `oriented`; or a simplification of it, as
  /// decode_isosig(simplified) gives it.
  std::string simplified;            ///< empty: the input
  std::vector<topology::Move> path;  ///< from there to `triangulation`
  Decomposition decomposition;
  CanonicalOrder order;
  IsometryGroup isometries;
  IsometrySignature signature;
  std::string cells;  ///< "4 tetrahedra", "1 octahedron"
};

/// What became of it: a manifold, or why not.
struct CanonizeAnswer {
  std::optional<CanonicalManifold> manifold;
  /// Of the input; without a manifold, with the evidence there is.
  structure::Report report;
  std::string message;                                  ///< one sentence for a person
  structure::Advice advice = structure::Advice::kNone;  ///< where nothing was found
};

/// Checks that there can be a canonical decomposition: what topology::require_solvable checks, and
/// that no vertex is finite. Throws InvalidInput as that does, Unsupported for a finite vertex.
void require_canonizable(const topology::Triangulation& triangulation,
                         std::span<const topology::ConeAngle> cone_angles = {});

/// The canonical decomposition with everything that follows from it: Kojima's if there is geodesic
/// boundary, with cusps that are small enough; Epstein's and Penner's, with cusps of one volume, if
/// there are cusps only. The cone angles are those of the options: then isometries keep them.
/// Throws what `require_canonizable` does.
CanonizeAnswer canonize(const topology::Triangulation& triangulation,
                        const CanonizeOptions& options = {});

/// The same where the metric is known: `report` is geometric, of this triangulation.
/// Nothing if no triangulation without concave faces was found. Throws Stopped if
/// options.stop is set after that.
std::optional<CanonicalManifold> canonize_metric(const topology::Triangulation& triangulation,
                                                 const structure::Report& report,
                                                 const ProtoCanonicalOptions& options = {});

/// Lengths, ascending, of the edges of the canonical decomposition: those edge classes of its
/// triangulation that at least three true faces meet (others lie within a cell or a polygon).
std::vector<double> cell_edge_lengths(const CanonicalManifold& manifold);

}  // namespace tripus::canonical
