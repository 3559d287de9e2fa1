#include "solver/method.hpp"

#include <cmath>
#include <string>

#include "base/error.hpp"

namespace tripus::solver {

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
