#pragma once

#include <optional>
#include <span>
#include <vector>

#include "solver/problem.hpp"

namespace tripus::solver {

/// The smallest Problem: two functions. For few variables, as its Hessian is a full matrix.
class DenseProblem : public Problem {
 public:
  explicit DenseProblem(std::size_t dimension);

  std::size_t dimension() const final { return n_; }
  bool evaluate(std::span<const double> x, std::span<double> gradient,
                const Request& request) final;
  const SparsityPattern& hessian_pattern() final { return pattern_; }
  void hessian_values(std::span<double> values) const final;
  void hessian_times(std::span<const double> v, std::span<double> Hv) const final;
  void hessian_diagonal_blocks(std::size_t block_size, std::span<double> blocks) const final;

 protected:
  /// f(x), and its gradient [n]; nothing outside the domain.
  virtual std::optional<double> value(std::span<const double> x, std::span<double> gradient) = 0;
  /// The symmetric matrix of second derivatives at x [n x n], where `value` has just been asked.
  virtual void hessian(std::span<const double> x, std::span<double> H) = 0;

 private:
  std::size_t n_;
  SparsityPattern pattern_;
  std::vector<double> H_;  // [n x n]
};

}  // namespace tripus::solver
