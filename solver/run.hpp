#pragma once

#include <chrono>
#include <memory>
#include <span>
#include <string>

#include "solver/method.hpp"

namespace tripus::solver {

/// max|v_i| of v [n]; infinity if an entry is not finite, 0 if n = 0.
double max_abs(std::span<const double> v);

/// An iterate farther out than this, in units of 1 + max|x at the start|, runs away: a dozen orders
/// of magnitude remain below it for every sensible minimiser, and a dozen extensions by 4 reach it.
inline constexpr double kRunaway = 1e8;

/// Bookkeeping of one run, for those who write a method or a flow: clock, limits, counts, observer.
///
/// It keeps no point: that is the method's affair, which knows where its iterates lie.
class Run {
 public:
  /// Validates options and the length of x (InvalidInput); keeps references to problem and options.
  Run(const Problem& problem, std::span<const double> x, const Options& options,
      int default_max_iterations);

  /// Problem::evaluate, counted; copies the gradient [n] and sets max_gradient = max|gradient|.
  /// Returns false where f is not defined and where the gradient is not finite.
  bool evaluate(std::span<const double> x, Order order, std::unique_ptr<Evaluation>& into,
                std::span<double> gradient, double& max_gradient);

  /// Passes x to the observer as iterate number `iterations`. Returns false, and keeps the reason
  /// in `termination`, when the run has to end: asked to stop, out of time, out of iterations.
  bool observe(std::span<const double> x, double max_gradient, double time = 0);

  /// Whether the time limit has passed; keeps the reason in `termination`.
  bool out_of_time();

  /// The summary of a run that ends with max|gradient| as given.
  Summary finish(Termination why, double max_gradient, std::string message = {}) const;

  double seconds() const;
  double tolerance() const { return options_.tolerance; }
  int max_iterations() const { return max_iterations_; }
  const Problem& problem() const { return problem_; }

  int iterations = 0;
  int evaluations = 0;
  long linear_iterations = 0;
  Termination termination = Termination::kNumericalFailure;

 private:
  const Problem& problem_;
  const Options& options_;
  int max_iterations_;
  std::chrono::steady_clock::time_point start_;
};

/// Whether the gradient near x, where max|g| <= tolerance, fades without coming to a minimiser,
/// like that of exp(-x): Newton steps from there stay long and divide max|g| by little. Costs one
/// Newton step where there is a minimiser; counts evaluations in `run`. Methods that do not use
/// second derivatives otherwise ask it before they claim convergence.
bool fades_at_infinity(Run& run, std::span<const double> x);

/// `run.finish(kConverged)`, or kUnbounded where the gradient fades at infinity.
Summary finish_converged(Run& run, std::span<const double> x, double max_gradient);

}  // namespace tripus::solver
