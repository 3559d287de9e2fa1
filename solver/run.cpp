#include "solver/run.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/error.hpp"

namespace tripus::solver {

double max_abs(std::span<const double> v) {
  double largest = 0;
  bool finite = true;
  for (const double value : v) {
    const double a = std::abs(value);
    largest = a > largest ? a : largest;
    finite &= a <= std::numeric_limits<double>::max();
  }
  return finite ? largest : std::numeric_limits<double>::infinity();
}

Run::Run(const Problem& problem, std::span<const double> x, const Options& options,
         int default_max_iterations)
    : problem_(problem),
      options_(options),
      max_iterations_(options.max_iterations > 0 ? options.max_iterations : default_max_iterations),
      start_(std::chrono::steady_clock::now()) {
  validate(options);
  if (x.size() != problem.dimension()) {
    throw InvalidInput("the start has " + std::to_string(x.size()) +
                       " entries, but the problem has " + std::to_string(problem.dimension()) +
                       " variables");
  }
}

bool Run::evaluate(std::span<const double> x, Order order, std::unique_ptr<Evaluation>& into,
                   std::span<double> gradient, double& max_gradient) {
  ++evaluations;
  const bool defined = problem_.evaluate(x, order, into);
  if (defined) std::ranges::copy(into->gradient(), gradient.begin());
  max_gradient = defined ? max_abs(gradient) : std::numeric_limits<double>::infinity();
  return max_gradient <= std::numeric_limits<double>::max();
}

bool Run::observe(std::span<const double> x, double max_gradient, double time) {
  if (options_.observer) {
    const Iterate iterate{iterations, evaluations, seconds(), max_gradient, time, x};
    if (!options_.observer(iterate)) {
      const bool converged = max_gradient <= options_.tolerance;
      termination = converged ? Termination::kConverged : Termination::kInterrupted;
      return false;
    }
  }
  if (max_gradient > options_.tolerance && iterations >= max_iterations_) {
    termination = Termination::kIterationLimit;
    return false;
  }
  return max_gradient <= options_.tolerance || !out_of_time();
}

bool Run::out_of_time() {
  if (options_.time_limit == std::numeric_limits<double>::infinity() ||
      seconds() < options_.time_limit) {
    return false;
  }
  termination = Termination::kTimeLimit;
  return true;
}

Summary Run::finish(Termination why, double max_gradient, std::string message) const {
  return Summary{why,       std::move(message), iterations, evaluations, linear_iterations,
                 seconds(), max_gradient};
}

double Run::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

}  // namespace tripus::solver
