#include "solver/detail/methods.hpp"

#include <cmath>
#include <string>

#include "base/error.hpp"

namespace tripus::solver {
namespace {

constexpr Method kMethods[] = {
    {"newton", "Newton's method, dense or sparse (CHOLMOD) Cholesky factorisation", true,
     detail::newton},
    {"newton-cg", "Newton's method, matrix-free conjugate gradients, Jacobi preconditioner", true,
     detail::newton_cg},
    {"newton-cg-block", "the same with a block-Jacobi preconditioner, 8 variables a block", true,
     detail::newton_cg_block},
    {"ceres-lbfgs", "limited-memory BFGS (Ceres)", false, detail::ceres_lbfgs},
    {"ceres-bfgs", "BFGS with a dense matrix, up to 1000 variables (Ceres)", false,
     detail::ceres_bfgs},
    {"ceres-cg", "nonlinear conjugate gradients, Polak-Ribiere (Ceres)", false, detail::ceres_cg},
    {"ceres-steepest-descent", "steepest descent with a Wolfe line search (Ceres)", false,
     detail::ceres_steepest_descent},
    {"ceres-lm", "Levenberg-Marquardt on gradient = 0 (Ceres)", true, detail::ceres_lm},
};

}  // namespace

std::span<const Method> methods() { return kMethods; }

const Method* find_method(std::string_view name) {
  for (const Method& method : kMethods) {
    if (method.name == name) return &method;
  }
  return nullptr;
}

std::string_view to_string(Termination termination) {
  switch (termination) {
    case Termination::kConverged:
      return "converged";
    case Termination::kIterationLimit:
      return "reached the iteration limit";
    case Termination::kTimeLimit:
      return "reached the time limit";
    case Termination::kStalled:
      return "stalled";
    case Termination::kUnbounded:
      return "ran away";
    case Termination::kNumericalFailure:
      return "failed numerically";
    case Termination::kInterrupted:
      return "was interrupted";
  }
  return "ended for an unknown reason";
}

void validate(const Options& options) {
  if (!(options.tolerance > 0) || !std::isfinite(options.tolerance)) {
    throw InvalidInput("tolerance is " + std::to_string(options.tolerance) +
                       "; it must be finite and greater than 0");
  }
  if (options.max_iterations < 0) {
    throw InvalidInput("max_iterations is " + std::to_string(options.max_iterations) +
                       "; it must be at least 0 (0 is the method's default)");
  }
  if (!(options.time_limit > 0)) {
    throw InvalidInput("time_limit is " + std::to_string(options.time_limit) +
                       " seconds; it must be greater than 0");
  }
}

}  // namespace tripus::solver
