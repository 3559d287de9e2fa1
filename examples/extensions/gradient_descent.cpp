// A method of one's own: steepest descent. This file is all that it takes.
#include <algorithm>
#include <limits>
#include <memory>
#include <numeric>
#include <vector>

#include "solver/method.hpp"
#include "solver/run.hpp"

namespace tripus::solver::registered_methods {
namespace {

constexpr int kMaxIterations = 100000;
constexpr int kPatience = 1000;  // iterations without a smaller gradient: this is rounding

/// An iterate with its gradient.
struct Point {
  std::vector<double> x, gradient;
  double max_gradient = 0;

  explicit Point(std::span<const double> start)
      : x(start.begin(), start.end()), gradient(x.size()) {}
  bool evaluate(Run& run, std::unique_ptr<Evaluation>& at) {
    return run.evaluate(x, Order::kFirst, at, gradient, max_gradient);
  }
};

/// Moves `next` downhill of `here`; false where no step is left. A convex function still falls at
/// `next`, and so has fallen all the way, if the gradients there and here point to the same side.
bool descend(Run& run, const Point& here, Point& next, std::unique_ptr<Evaluation>& at,
             double& step) {
  for (step *= 4; step * here.max_gradient > 1e-16 * (1 + max_abs(here.x)); step /= 2) {
    for (std::size_t i = 0; i < next.x.size(); ++i) next.x[i] = here.x[i] - step * here.gradient[i];
    if (next.evaluate(run, at) && std::inner_product(here.gradient.begin(), here.gradient.end(),
                                                     next.gradient.begin(), 0.0) >= 0)
      return true;
  }
  return false;
}

Summary minimise(const Problem& problem, std::span<double> x, const Options& options) {
  Run run(problem, x, options, kMaxIterations);
  const double farthest = kRunaway * (1 + max_abs(x));
  Point here(x), next(x), best(x);
  std::unique_ptr<Evaluation> at;
  if (!here.evaluate(run, at))
    return run.finish(Termination::kNumericalFailure, std::numeric_limits<double>::infinity(),
                      "the gradient is not defined at the start");
  best = here;
  int best_at = 0;
  for (double step = 1;; ++run.iterations) {
    const bool goes_on = run.observe(here.x, here.max_gradient);
    if (here.max_gradient < best.max_gradient) {
      best = here;
      best_at = run.iterations;
    }
    std::ranges::copy(best.x, x.begin());
    if (best.max_gradient <= run.tolerance()) return finish_converged(run, x, best.max_gradient);
    if (!goes_on) return run.finish(run.termination, best.max_gradient);
    if (max_abs(here.x) > farthest) return run.finish(Termination::kUnbounded, best.max_gradient);
    if (run.iterations - best_at > kPatience || !descend(run, here, next, at, step))
      return run.finish(Termination::kStalled, best.max_gradient, "no step goes down");
    std::swap(here, next);
  }
}

}  // namespace

std::span<const Method> gradient_descent() {
  static constexpr Method kRows[] = {
      {"gradient-descent", "steepest descent, as far as it goes down", false, minimise}};
  return kRows;
}

}  // namespace tripus::solver::registered_methods
