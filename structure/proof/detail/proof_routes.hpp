#pragma once

#include "structure/proof/detail/cone_metric.hpp"
#include "structure/proof/proof.hpp"

namespace tripus::structure::detail {

/// The strong-convexity test where no single tetrahedron is strictly convex in its lengths: at
/// cusps, whose horospheres can be moved, and at parabolic edges. The Hessian of all tetrahedra
/// together is shown to be positive definite once an edge at each cusp is held.
///   proof  lengths and box are set; the rest is filled in, `reason` if it is not proved
/// Source: docs/theory.md 9.6.
void prove_by_factorisation(const ConeMetric& metric, const ProveOptions& options,
                            const Context& context, Proof& proof);

/// The proof with finite vertices, where the co-volume is not convex: Krawczyk's test on as many
/// equations as are independent, with the lengths held that place the vertices; the curvatures of
/// the other edges then vanish, since rotations about them have product 1.
///   proof  lengths and box are set; the rest is filled in, `reason` if it is not proved
/// Source: docs/theory.md 9.8.
void prove_by_interval_newton(const ConeMetric& metric, const ProveOptions& options,
                              const Context& context, Proof& proof);

}  // namespace tripus::structure::detail
