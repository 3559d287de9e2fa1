#pragma once

#include "geometry/detail/ball_functions.hpp"
#include "geometry/enclosure_formulae.hpp"

/// Lower bounds of the Jacobian by diagonal matrices.
namespace tripus::geometry {
namespace {

/// An estimate, from below but for rounding, of the least eigenvalue of the symmetric A [6 x 6]:
/// |A^-4|_F^(-1/4). Nothing rests on it.
template <class Real>
inline Real least_eigenvalue_estimate(const Real (&A)[6][6]) {
  // A = L diag(d) L^T, then W = L^-1 and A^-1 = W^T diag(1/d) W.
  Real L[6][6], W[6][6], over_d[6], B[6][6], next[6][6];
  for (int k = 0; k < 6; ++k) {
    Real d = A[k][k];
    for (int j = 0; j < k; ++j) d = d - L[k][j] * L[k][j] / over_d[j];
    over_d[k] = 1.0 / d;
    for (int i = k + 1; i < 6; ++i) {
      Real x = A[i][k];
      for (int j = 0; j < k; ++j) x = x - L[i][j] * L[k][j] / over_d[j];
      L[i][k] = x * over_d[k];
    }
  }
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < i; ++j) {
      Real x = L[i][j];
      for (int k = j + 1; k < i; ++k) x = x + L[i][k] * W[k][j];
      W[i][j] = -x;
    }
    W[i][i] = broadcast<Real>(1.0);
  }
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j <= i; ++j) {
      Real x = broadcast<Real>(0.0);
      for (int k = i; k < 6; ++k) x = x + W[k][i] * W[k][j] * over_d[k];
      B[i][j] = B[j][i] = x;
    }
  for (int squaring = 0; squaring < 2; ++squaring) {
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j <= i; ++j) {
        Real x = B[i][0] * B[0][j];
        for (int k = 1; k < 6; ++k) x = x + B[i][k] * B[k][j];
        next[i][j] = next[j][i] = x;
      }
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j) B[i][j] = next[i][j];
  }
  Real sum = broadcast<Real>(0.0);
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) sum = sum + B[i][j] * B[i][j];
  return 1.0 / square_root(square_root(square_root(sum)));
}

/// Weights with J >= diag(weight) for every member of the packed Jacobian [21]. With S = diag(S_i),
/// S J S - lambda I > 0 says J > lambda S^-2; S makes the diagonal about 1, which is nearly the
/// best that a diagonal scaling can do. Returns the smallest pivot: the weights are proved if it is
/// > 0.
template <class Real>
inline Real corner_weights(const Ball<Real>* jacobian, Real (&weight)[6]) {
  Real S[6], A[6][6];
  Ball<Real> scaled[21];
  for (int i = 0; i < 6; ++i) S[i] = 1.0 / square_root(jacobian[packed_index(i, i)].m);
  for (int i = 0; i < 6; ++i)
    for (int j = i; j < 6; ++j) {
      scaled[packed_index(i, j)] = (jacobian[packed_index(i, j)] * exactly(S[i])) * exactly(S[j]);
      A[i][j] = A[j][i] = scaled[packed_index(i, j)].m;
    }
  const Real lambda = 0.9 * least_eigenvalue_estimate(A);
  for (int i = 0; i < 6; ++i) weight[i] = lambda / (S[i] * S[i]) * (2 - kUp);
  const Real pivot =
      smallest_pivot(scaled, exactly(lambda), [](const Ball<Real>& x) { return lower(x); });
  const Real zero = broadcast<Real>(0.0);
  return lambda > zero ? pivot : zero;
}

}  // namespace
}  // namespace tripus::geometry
