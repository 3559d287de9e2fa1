#pragma once

#include <utility>

#include "geometry/batch.hpp"
#include "geometry/detail/gram_kernel.hpp"
#include "geometry/detail/scaled_kernel.hpp"

/// The kernel with ideal vertices: that of gram_kernel.hpp with a diagonal of 0 and 1. Purely
/// hyperideal input does not come here: there the diagonal costs nothing.
namespace tripus::geometry {
namespace {

/// -G_ij (as c) and s_ij of the six edges, docs/theory.md (77): cosh and sinh between hyperideal
/// vertices, the exponential at one ideal vertex, twice that between two. Returns a mask of the
/// lanes with a length beyond kUnscaledLimit, whose entries are of no use.
template <class Real, class Diagonal>
inline auto mixed_edges(const Real* l, const Diagonal* d, Real* c, Real* s) {
  const Real zero = broadcast<Real>(0.0);
  const Real limit = broadcast<Real>(kUnscaledLimit);
  auto too_long = zero > limit;
  for (int e = 0; e < 6; ++e) {
    const EdgeFrame f = kEdgeFrames[e];
    const auto hyperideal = d[f.i] * d[f.j] > zero;
    const Real size = hyperideal ? maximum(l[e], zero) : magnitude(l[e]);
    too_long |= size > limit;
    const SinhCosh<Real> h = sinh_cosh(minimum(size, limit));
    const Real grown = h.cosh + h.sinh;
    const Real once = l[e] < zero ? 1.0 / grown : grown;
    const Real exponential = d[f.i] + d[f.j] > zero ? once : 2.0 * once;
    s[e] = hyperideal ? h.sinh : exponential;
    c[e] = hyperideal ? h.cosh : exponential;
  }
  return too_long;
}

/// gram_kernel with the Jacobian's diagonal 0 where a length <= 0 counts as 0.
template <class Real, class Diagonal>
inline Real mixed_gram_kernel(const Real* c, const Real* s, const Diagonal* d, Real* theta,
                              Real* jacobian) {
  const Real det = gram_kernel(c, s, d, opposite_products(c, s), theta, jacobian);
  if (jacobian != nullptr) {
    const Real zero = broadcast<Real>(0.0);
    for (int e = 0; e < 6; ++e) {
      Real& entry = jacobian[packed_index(e, e)];
      entry = s[e] > zero ? entry : zero;
    }
  }
  return det;
}

}  // namespace
}  // namespace tripus::geometry
