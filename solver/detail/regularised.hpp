#pragma once

#include <span>
#include <vector>

#include "solver/detail/newton_loop.hpp"

namespace tripus::solver::detail {

/// The regularised Newton direction (H + mu D + Z) d = -g of the essay in newton_loop.cpp: always a
/// descent direction, never longer than asked.
class RegularisedSystem {
 public:
  RegularisedSystem(NewtonSystem& system, std::size_t n) : system_(system), shift_(n) {}

  /// Direction d [n] at an evaluation of second order whose gradient is g [n], not zero, and
  /// max_gradient = max|g|. max|d| <= longest, which is > 0.
  /// Returns the slope g . d < 0.
  double compute(const Evaluation& at, std::span<const double> g, double max_gradient,
                 double longest, double forcing, std::span<double> d);

  /// After a step: a good one forgets mu, a full one lowers it, a short one raises it.
  void adapt(bool good, double step);

  long linear_iterations() const { return system_.linear_iterations(); }

 private:
  bool solve(const Evaluation& at, std::span<const double> g, double forcing, std::span<double> d);

  NewtonSystem& system_;
  std::vector<double> shift_;
  std::span<const double> diagonal_;
  double mean_ = 1;  // of the diagonal of H, > 0
  double mu_ = 0;
  double slope_ = 0;
};

/// max|d| of a step, in units of 1 + max|x|, that Newton's method is trusted with.
inline constexpr double kStepGrowth = 4;

}  // namespace tripus::solver::detail
