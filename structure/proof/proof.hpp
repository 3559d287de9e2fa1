#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "base/context.hpp"
#include "topology/cone_angle.hpp"
#include "topology/triangulation.hpp"

namespace tripus::structure {

/// All real numbers from `lower` to `upper`.
struct Interval {
  double lower = 0;
  double upper = 0;
};

/// What was proved about a triangulation and lengths near which its co-volume is least. Every
/// rounding is accounted for: docs/theory.md section 9, docs/proof.md. With cusps, lengths within
/// the radii are those for some horospheres, with finite vertices those for some places of these.
struct Proof {
  enum class Claim {
    kMetric,  ///< the triangulation carries the metric, and |x_e - lengths_e| <= radii_e
    kFlat,    ///< a minimiser within the radii has the tetrahedra `flat`: there is no metric
  };
  bool proved = false;
  std::string reason;  ///< why not, one sentence; empty if proved
  Claim claim = Claim::kMetric;
  int bits = 53;                                 ///< of the most precise arithmetic that was needed
  std::size_t escalated = 0;                     ///< tetrahedra that doubles were not enough for
  std::vector<topology::ConeAngle> cone_angles;  ///< [E]; empty for 2 pi
  std::vector<double> lengths;                   ///< [E] exact centres
  std::vector<double> radii;                     ///< [E] upper bounds
  std::vector<double> weights;    ///< [E] d_e: Hess H >= diag(d) on the box; 0: vertices are finite
  std::vector<double> box;        ///< [E] half the sides of that box; radii are smaller
  Interval volume;                ///< of the manifold; not set for kFlat
  std::vector<std::size_t> flat;  ///< tetrahedra proved flat at the minimiser

  double largest_radius() const;
};

struct ProveOptions {
  bool volume = true;
  int most_bits = 4096;           ///< beyond this precision a tetrahedron is given up
  std::vector<std::size_t> flat;  ///< tetrahedra to hold flat, ascending: claim kFlat
  std::vector<topology::ConeAngle> cone_angles;  ///< [E]; empty for 2 pi
};

/// Tries to prove that there is a metric within rounding of these lengths, or, with `flat`, a
/// minimiser with flat tetrahedra. Time and memory are linear in the number of tetrahedra where all
/// vertices are hyperideal and no edge is parabolic, else those of a sparse factorisation; the
/// result does not depend on the number of threads. A proof that is stopped is not proved.
///   lengths  [E]  finite, > 0 between hyperideal vertices, 0 at a parabolic edge, as
///                 structure::solve finds them; any others are refused by `reason`
/// Throws InvalidInput for a triangulation outside the domain (topology::require_solvable) and for
/// a wrong number of lengths. Flat tetrahedra beside parabolic edges or finite vertices, and more
/// than 400 edge classes with the latter, are refused by `reason`. Source: docs/theory.md 9.
Proof prove(const topology::Triangulation& triangulation, std::span<const double> lengths,
            const ProveOptions& options = {}, const Context& context = {});

}  // namespace tripus::structure
