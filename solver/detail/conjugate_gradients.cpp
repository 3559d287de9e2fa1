#include "solver/detail/conjugate_gradients.hpp"

#include <algorithm>
#include <cmath>

#include "solver/detail/dense_cholesky.hpp"
#include "solver/detail/vectors.hpp"

// Conjugate gradients for (H + S) d = -g with S = diag(shift), preconditioned by the diagonal
// blocks of H + S, stopped when the residual in the norm of the inverse preconditioner has fallen
// by the forcing factor. Every iterate is a descent direction, so an early stop is always usable.
//
// Curvature that is not positive beyond rounding: on the first iteration it is reported, and the
// caller raises the shift; later the direction reached so far is taken.

namespace tripus::solver::detail {
namespace {

constexpr double kZeroCurvature = 1e-14;  // of p . diag(H + S) p

/// Iterations of one solve; beyond, rounding has long destroyed the conjugacy.
long iteration_limit(std::size_t n) {
  return static_cast<long>(std::min<std::size_t>(2 * n + 10, 2000));
}

}  // namespace

ConjugateGradients::ConjugateGradients(std::size_t dimension, std::size_t block_size)
    : n_(dimension),
      block_size_(block_size),
      blocks_((n_ + block_size - 1) / block_size * block_size * block_size),
      factors_(blocks_.size()),
      diagonal_(n_),
      r_(n_),
      z_(n_),
      p_(n_),
      q_(n_) {}

std::span<const double> ConjugateGradients::load(const Evaluation& at) {
  at.hessian_diagonal_blocks(block_size_, blocks_);
  const std::size_t b = block_size_;
  for (std::size_t i = 0; i < n_; ++i) {
    diagonal_[i] = blocks_[(i / b) * b * b + (i % b) * (b + 1)];
  }
  return diagonal_;
}

bool ConjugateGradients::factor_preconditioner(std::span<const double> shift) {
  const std::size_t b = block_size_;
  if (b == 1) {
    for (std::size_t i = 0; i < n_; ++i) {
      const double pivot = blocks_[i] + shift[i];
      if (!(pivot > 0)) return false;
      factors_[i] = 1 / pivot;
    }
    return true;
  }
  std::copy(blocks_.begin(), blocks_.end(), factors_.begin());
  for (std::size_t first = 0, k = 0; first < n_; first += b, ++k) {
    const std::span<double> block(factors_.data() + k * b * b, b * b);
    for (std::size_t i = 0; i < b; ++i) {
      // Variables beyond the last get a unit diagonal.
      block[i * (b + 1)] = first + i < n_ ? block[i * (b + 1)] + shift[first + i] : 1;
    }
    if (factor_cholesky(block, b)) continue;
    // Singular: fall back to the diagonal of this block, as a factor.
    std::fill(block.begin(), block.end(), 0.0);
    for (std::size_t i = 0; i < b; ++i) {
      const double pivot = first + i < n_ ? diagonal_[first + i] + shift[first + i] : 1;
      if (!(pivot > 0)) return false;
      block[i * (b + 1)] = 1 / std::sqrt(pivot);
    }
  }
  return true;
}

/// z = M^-1 r; returns r . z.
double ConjugateGradients::precondition() {
  const std::size_t b = block_size_;
  if (b == 1) {
    double sum = 0;
    for (std::size_t i = 0; i < n_; ++i) {
      z_[i] = factors_[i] * r_[i];
      sum += r_[i] * z_[i];
    }
    return sum;
  }
  double padded[64];
  for (std::size_t first = 0, k = 0; first < n_; first += b, ++k) {
    const std::size_t count = std::min(b, n_ - first);
    std::fill(std::copy_n(r_.data() + first, count, padded), padded + b, 0.0);
    solve_cholesky({factors_.data() + k * b * b, b * b}, b, {padded, b});
    std::copy_n(padded, count, z_.data() + first);
  }
  return dot(r_.data(), z_.data(), n_);
}

bool ConjugateGradients::solve(const Evaluation& at, std::span<const double> shift,
                               std::span<const double> g, double forcing, std::span<double> d) {
  if (!factor_preconditioner(shift)) return false;
  for (std::size_t i = 0; i < n_; ++i) {
    r_[i] = -g[i];
    d[i] = 0;
  }
  double rz = precondition();
  const double enough = forcing * forcing * rz;
  std::copy(z_.begin(), z_.end(), p_.begin());
  const long limit = iteration_limit(n_);
  for (long k = 0; k < limit; ++k) {
    at.hessian_times(p_, q_);
    ++iterations_;
    double pq = 0, pdp = 0;
    for (std::size_t i = 0; i < n_; ++i) {
      q_[i] += shift[i] * p_[i];
      pq += p_[i] * q_[i];
      pdp += (diagonal_[i] + shift[i]) * p_[i] * p_[i];
    }
    if (!(pq > kZeroCurvature * pdp)) return k > 0;
    const double alpha = rz / pq;
    for (std::size_t i = 0; i < n_; ++i) {
      d[i] += alpha * p_[i];
      r_[i] -= alpha * q_[i];
    }
    const double previous = rz;
    rz = precondition();
    if (!(rz > enough)) return true;
    const double beta = rz / previous;
    for (std::size_t i = 0; i < n_; ++i) p_[i] = z_[i] + beta * p_[i];
  }
  return true;
}

}  // namespace tripus::solver::detail
