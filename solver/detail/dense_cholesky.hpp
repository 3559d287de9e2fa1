#pragma once

#include <cstddef>
#include <span>

namespace tripus::solver::detail {

/// Cholesky factorisation in place. a [n x n], column-major, lower triangle only: on entry A, on
/// exit L with A = L L^T and the reciprocals of the diagonal of L on the diagonal. Returns false,
/// with a unspecified, where a pivot is not above kPivot times its diagonal entry (or not finite):
/// A is then not numerically positive definite.
bool factor_cholesky(std::span<double> a, std::size_t n);

/// Solves L L^T x = b in place, b [n], with the output of `factor_cholesky`.
void solve_cholesky(std::span<const double> a, std::size_t n, std::span<double> b);

/// A pivot that has lost all but some three digits to cancellation says nothing about its sign.
inline constexpr double kPivot = 1e-13;

}  // namespace tripus::solver::detail
