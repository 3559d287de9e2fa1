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
  bool evaluate(std::span<const double> x, Order order,
                std::unique_ptr<Evaluation>& into) const final;
  const SparsityPattern& hessian_pattern() const final { return pattern_; }

 protected:
  /// f(x), and its gradient [n]; nothing outside the domain.
  virtual std::optional<double> value(std::span<const double> x,
                                      std::span<double> gradient) const = 0;
  /// The symmetric matrix of second derivatives at x [n x n], a point of the domain.
  virtual void hessian(std::span<const double> x, std::span<double> H) const = 0;

 private:
  std::size_t n_;
  SparsityPattern pattern_;
};

}  // namespace tripus::solver
