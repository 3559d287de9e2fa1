#include <algorithm>

#include "solver/detail/dense_cholesky.hpp"
#include "solver/detail/direct_systems.hpp"

namespace tripus::solver::detail {

DenseSystem::DenseSystem(const Problem& problem)
    : pattern_(problem.hessian_pattern()),
      pins_(problem.pins()),
      n_(problem.dimension()),
      memory_(pattern_.row.size() + n_ + n_ * n_) {
  double* at = memory_.data();
  values_ = {at, pattern_.row.size()};
  diagonal_ = {at + values_.size(), n_};
  factor_ = {at + values_.size() + n_, n_ * n_};
}

std::span<const double> DenseSystem::load(const Evaluation& at) {
  at.hessian_values(values_);
  for (std::size_t j = 0; j < n_; ++j) {
    diagonal_[j] = values_[static_cast<std::size_t>(pattern_.column_start[j])];
  }
  return diagonal_;
}

bool DenseSystem::solve(const Evaluation&, std::span<const double> shift, std::span<const double> g,
                        double, std::span<double> d) {
  std::fill(factor_.begin(), factor_.end(), 0.0);
  for (std::size_t j = 0; j < n_; ++j) {
    const auto begin = static_cast<std::size_t>(pattern_.column_start[j]);
    const auto end = static_cast<std::size_t>(pattern_.column_start[j + 1]);
    double* column = factor_.data() + j * n_;
    for (std::size_t k = begin; k < end; ++k) {
      column[static_cast<std::size_t>(pattern_.row[k])] = values_[k];
    }
    column[j] += shift[j];
    d[j] = -g[j];
  }
  for (const std::uint32_t pin : pins_) factor_[pin * (n_ + 1)] += diagonal_[pin];
  if (!factor_cholesky(factor_, n_)) return false;
  solve_cholesky(factor_, n_, d);
  return true;
}

}  // namespace tripus::solver::detail
