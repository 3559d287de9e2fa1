#pragma once

#include <memory>
#include <span>

#include "solver/problem.hpp"

namespace tripus::solver {

/// The regularised Newton direction -H^-1 g as a vector field, by dense or sparse factorisation.
/// Where H is singular or nearly so it bends towards the gradient; it is limited to a few times
/// 1 + max|x|. See the essay in solver/detail/newton_loop.cpp.
class NewtonDirection {
 public:
  explicit NewtonDirection(const Problem& problem);
  ~NewtonDirection();

  /// At x [n], with the evaluation of second order there. Writes d [n]; d = 0 where the gradient
  /// is.
  void compute(std::span<const double> x, const Evaluation& at, std::span<double> d);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// max|d| of the Newton step H d = -g to 3 digits, by conjugate gradients: an estimate of how far
/// the minimiser is. `at` is of second order. g must be orthogonal to the constant directions of
/// `Problem::pins`. The step is 0 at variables that neither g nor H
/// sees, and infinite where H does not bend along g.
///   least_curvature  added to the diagonal of H: where the function may be constant along more
///                    directions than those of the pins, and g is rounding along them
double newton_distance(const Evaluation& at, std::span<const double> g, double least_curvature = 0);

}  // namespace tripus::solver
