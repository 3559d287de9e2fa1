#include <algorithm>

#include "solver/detail/dense_cholesky.hpp"
#include "solver/detail/direct_systems.hpp"

namespace tripus::solver::detail {

DenseSystem::DenseSystem(const Problem& problem)
    : problem_(problem),
      pins_(problem.pins()),
      n_(problem.dimension()),
      memory_(n_ * (2 * n_ + 1)) {
  double* at = memory_.data();
  matrix_ = {at, n_ * n_};
  diagonal_ = {at + n_ * n_, n_};
  factor_ = {at + n_ * n_ + n_, n_ * n_};
}

std::span<const double> DenseSystem::load(const Evaluation& at) {
  if (!at.dense_hessian(matrix_)) {
    const SparsityPattern& pattern = problem_.hessian_pattern();
    values_.resize(pattern.row.size());
    at.hessian_values(values_);
    std::fill(matrix_.begin(), matrix_.end(), 0.0);
    for (std::size_t j = 0; j < n_; ++j)
      for (auto k = static_cast<std::size_t>(pattern.column_start[j]);
           k < static_cast<std::size_t>(pattern.column_start[j + 1]); ++k)
        matrix_[j * n_ + static_cast<std::size_t>(pattern.row[k])] = values_[k];
  }
  for (std::size_t j = 0; j < n_; ++j) diagonal_[j] = matrix_[j * (n_ + 1)];
  return diagonal_;
}

bool DenseSystem::solve(const Evaluation&, std::span<const double> shift, std::span<const double> g,
                        double, std::span<double> d) {
  std::copy(matrix_.begin(), matrix_.end(), factor_.begin());
  for (std::size_t j = 0; j < n_; ++j) {
    factor_[j * (n_ + 1)] += shift[j];
    d[j] = -g[j];
  }
  for (const std::uint32_t pin : pins_) factor_[pin * (n_ + 1)] += diagonal_[pin];
  if (!factor_cholesky(factor_, n_)) return false;
  solve_cholesky(factor_, n_, d);
  return true;
}

}  // namespace tripus::solver::detail
