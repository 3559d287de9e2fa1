#pragma once

#include <span>

#include "solver/method.hpp"
#include "solver/run.hpp"

namespace tripus::solver::detail {

/// The linear algebra of one Newton step. Its problem outlives it.
class NewtonSystem {
 public:
  virtual ~NewtonSystem() = default;

  /// Reads the Hessian H of an evaluation of second order. Returns its diagonal [n], valid until
  /// the next load.
  virtual std::span<const double> load(const Evaluation& at) = 0;

  /// Solves (H + diag(shift)) d = -g with the H of `at`, which has been loaded. All [n]; shift >=
  /// 0. `forcing` in (0, 1) is the relative residual that is good enough; direct solvers ignore it.
  /// Returns false where the matrix is not numerically positive definite; d is then unspecified.
  virtual bool solve(const Evaluation& at, std::span<const double> shift, std::span<const double> g,
                     double forcing, std::span<double> d) = 0;

  /// Conjugate-gradient iterations so far.
  virtual long linear_iterations() const { return 0; }
};

/// Damped, regularised Newton iteration for a convex C1 function; the essay in newton_loop.cpp says
/// how and why it converges. `run` has been made for this x.
Summary newton_loop(Run& run, NewtonSystem& system, std::span<double> x);

}  // namespace tripus::solver::detail
