#include <algorithm>
#include <exception>
#include <limits>
#include <utility>
#include <vector>

#include <ceres/gradient_problem.h>
#include <ceres/gradient_problem_solver.h>

#include "solver/detail/ceres_methods.hpp"
#include "solver/detail/ceres_silence.hpp"
#include "solver/run.hpp"

// Ceres' line-search minimisers, to the full accuracy of the gradient.
//
// Their line searches compare values of f. Near a minimiser f - min f is quadratic in the distance,
// and rounding of f stops them at max|g| of about 1e-8. So when Ceres stops before the tolerance,
// it is started again from the best point c so far, with f(x) - f(c) computed by the trapezoidal
// rule
//     1/2 (g(x) + g(c)) . (x - c),
// whose error is of third order in x - c, while its rounding is relative to the difference itself.
// (With it the condition of sufficient decrease becomes the "approximate Wolfe" condition of Hager
// and Zhang, SIAM J. Optim. 16 (2005), eq. (4.1).) It is fit for short displacements only: the
// first run uses f. Each restart gains several digits of the gradient; when one gains nothing, the
// run has stalled.
//
// The variables that Ceres sees are y = (x - c) / s with s = max|g(c)|, and its function is
// (f(x) - f(c)) / s^2: the Hessian is unchanged, the gradient starts at 1. Without that its quasi-
// Newton methods discard every update with dx . dg below 1e-14, a bound that is not relative, and
// crawl like steepest descent once max|g| is 1e-7; and it measures max|g| as |(y - g) - y|, which
// has no digits left where |y| is large. For the same reasons a run is cut and restarted when the
// gradient has fallen by kRescale, and convergence is judged here and not by Ceres.

namespace tripus::solver::detail {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kProgress = 0.9;           // a restart must leave at most this much of max|g|
constexpr double kRescale = 1e-5;           // a run that has come so far continues in a new scale
constexpr int kIdleSteps = 1000;            // so many steps without such progress: stalled
constexpr std::size_t kLargestBfgs = 1000;  // its matrix is dense: 8 MB
constexpr int kMaxIterations = 20000;
constexpr int kMaxSteepestDescent = 1000000;

/// What the cost function, the callback and the driver share.
class Session {
 public:
  Session(Run& run, std::span<double> x)
      : run_(run),
        n_(x.size()),
        result_(x),
        trial_(n_),
        gradient_(n_),
        centre_gradient_(n_),
        best_x_(n_),
        best_gradient_(n_),
        y_(n_) {
    runaway_ = kRunaway * (1 + max_abs(x));
  }

  Summary minimise(ceres::LineSearchDirectionType direction);
  bool evaluate(const double* y, double* cost, double* gradient);
  ceres::CallbackReturnType callback();

 private:
  void solve(ceres::LineSearchDirectionType direction);
  bool recentre();
  void keep_best();
  bool idle();
  void copy_gradient(double* gradient) const;

  Run& run_;
  std::size_t n_;
  std::unique_ptr<Evaluation> at_;                          // where Ceres asked last
  std::span<double> result_;                                // the centre c while Ceres runs
  std::vector<double> trial_, gradient_, centre_gradient_;  // the latest x and its g; g(c)
  std::vector<double> best_x_, best_gradient_;
  std::vector<double> y_;         // Ceres' variables
  double trial_max_ = kInfinity;  // max|g| of the latest evaluation
  double best_ = kInfinity;
  double centre_value_ = 0;
  std::vector<double> base_y_, base_gradient_;  // the latest iterate x_k, and
  double base_cost_ = 0, cost_ = 0;             // its cost; that of the latest evaluation
  double scale_ = 1;                            // s
  double observed_ = kInfinity;                 // max|g| of the latest iterate shown
  double runaway_ = kInfinity;
  double reference_ = kInfinity;  // best_ when progress was last seen, and
  int idle_ = 0;                  // steps since then
  bool use_values_ = true;        // else the trapezoidal rule
  bool first_callback_ = true;
  bool stopped_ = false;  // run_.termination says why
  std::exception_ptr exception_;
};

class Function final : public ceres::FirstOrderFunction {
 public:
  Function(Session& session, std::size_t n) : session_(session), n_(static_cast<int>(n)) {}
  bool Evaluate(const double* y, double* cost, double* gradient) const override {
    return session_.evaluate(y, cost, gradient);
  }
  int NumParameters() const override { return n_; }

 private:
  Session& session_;
  int n_;
};

class Callback final : public ceres::IterationCallback {
 public:
  explicit Callback(Session& session) : session_(session) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
    return session_.callback();
  }

 private:
  Session& session_;
};

void Session::keep_best() {
  if (!(trial_max_ < best_)) return;
  best_ = trial_max_;
  best_x_ = trial_;
  best_gradient_ = gradient_;
}

bool Session::evaluate(const double* y, double* cost, double* gradient) {
  if (stopped_) return false;
  const bool at_centre = std::all_of(y, y + n_, [](double v) { return v == 0; });
  if (at_centre) {
    std::copy(result_.begin(), result_.end(), trial_.begin());
    gradient_ = centre_gradient_;
    trial_max_ = max_abs(gradient_);
    *cost = cost_ = 0;
    copy_gradient(gradient);
    return true;
  }
  if (run_.out_of_time()) {
    stopped_ = true;
    return false;
  }
  for (std::size_t i = 0; i < n_; ++i) trial_[i] = result_[i] + scale_ * y[i];
  // Far beyond what can still be called an iterate: as if outside the domain.
  if (!(max_abs(trial_) < 1e4 * runaway_)) return false;
  double value = 0;
  try {
    if (!run_.evaluate(trial_, Order::kFirst, at_, gradient_, trial_max_)) return false;
    if (use_values_) value = at_->value();
  } catch (...) {
    exception_ = std::current_exception();
    stopped_ = true;
    return false;
  }
  keep_best();
  if (use_values_) {
    *cost = (value - centre_value_) / scale_ / scale_;
  } else {
    double sum = 0;
    for (std::size_t i = 0; i < n_; ++i) {
      sum += (gradient_[i] + base_gradient_[i]) * (y[i] - base_y_[i]);
    }
    *cost = base_cost_ + 0.5 * sum / scale_;
  }
  cost_ = *cost;
  copy_gradient(gradient);
  return cost_ - cost_ == 0;
}

void Session::copy_gradient(double* gradient) const {
  if (gradient == nullptr) return;
  for (std::size_t i = 0; i < n_; ++i) gradient[i] = gradient_[i] / scale_;
}

/// Whether the iteration wanders about in the rounding errors of the gradient.
bool Session::idle() {
  if (best_ <= kProgress * reference_) {
    reference_ = best_;
    idle_ = 0;
    return false;
  }
  return !use_values_ && ++idle_ > kIdleSteps;
}

/// After each step of Ceres, at x = c + s y.
ceres::CallbackReturnType Session::callback() {
  if (stopped_) return ceres::SOLVER_ABORT;
  if (std::exchange(first_callback_, false)) return ceres::SOLVER_CONTINUE;
  try {
    bool same = true;
    for (std::size_t i = 0; i < n_; ++i) same &= trial_[i] == result_[i] + scale_ * y_[i];
    if (!same && !evaluate(y_.data(), &cost_, nullptr)) return ceres::SOLVER_ABORT;
    if (idle()) return ceres::SOLVER_ABORT;
    base_y_ = y_;
    base_gradient_ = gradient_;
    base_cost_ = cost_;
    ++run_.iterations;
    observed_ = trial_max_;
    stopped_ = !run_.observe(trial_, trial_max_);
    if (!stopped_ && max_abs(trial_) > runaway_) {
      run_.termination = Termination::kUnbounded;
      stopped_ = true;
    }
  } catch (...) {
    exception_ = std::current_exception();
    stopped_ = true;
  }
  const bool enough = trial_max_ <= std::max(run_.tolerance(), kRescale * scale_);
  return stopped_ || enough ? ceres::SOLVER_ABORT : ceres::SOLVER_CONTINUE;
}

void Session::solve(ceres::LineSearchDirectionType direction) {
  ceres::GradientProblemSolver::Options options;
  options.line_search_direction_type = direction;
  options.max_num_iterations = run_.max_iterations() - run_.iterations + 1;
  options.max_num_line_search_step_size_iterations = 40;
  options.min_line_search_step_size = 1e-20;
  options.function_tolerance = options.parameter_tolerance = options.gradient_tolerance = 0;
  options.max_solver_time_in_seconds = 1e18;  // the limit is kept by evaluate()
  options.logging_type = ceres::SILENT;
  options.update_state_every_iteration = true;
  Callback callback(*this);
  options.callbacks.push_back(&callback);
  ceres::GradientProblem problem(new Function(*this, n_));
  ceres::GradientProblemSolver::Summary summary;
  std::fill(y_.begin(), y_.end(), 0.0);
  base_y_ = y_;
  base_gradient_ = centre_gradient_;
  base_cost_ = 0;
  scale_ = best_;
  first_callback_ = true;
  ceres::Solve(options, problem, y_.data(), &summary);
}

/// Moves the centre to the best point evaluated; shows it unless it was the latest shown. Returns
/// false if the run has to end.
bool Session::recentre() {
  const bool moved = !std::equal(best_x_.begin(), best_x_.end(), result_.begin());
  std::copy(best_x_.begin(), best_x_.end(), result_.begin());
  centre_gradient_ = best_gradient_;
  if (!moved || best_ == observed_) return true;
  ++run_.iterations;
  observed_ = best_;
  return run_.observe(result_, best_);
}

Summary Session::minimise(ceres::LineSearchDirectionType direction) {
  std::copy(result_.begin(), result_.end(), trial_.begin());
  const bool defined = max_abs(trial_) < kInfinity &&
                       run_.evaluate(trial_, Order::kFirst, at_, gradient_, trial_max_);
  if (defined) centre_value_ = at_->value();
  if (!defined || !(centre_value_ - centre_value_ == 0)) {
    return run_.finish(Termination::kNumericalFailure, kInfinity,
                       "the function is not defined at the start");
  }
  keep_best();
  centre_gradient_ = gradient_;
  observed_ = best_;
  if (!run_.observe(result_, best_)) return run_.finish(run_.termination, best_);
  while (best_ > run_.tolerance()) {
    const double before = best_;
    solve(direction);
    if (exception_) std::rethrow_exception(exception_);
    if (stopped_) {
      std::copy(best_x_.begin(), best_x_.end(), result_.begin());
      if (best_ > run_.tolerance()) return run_.finish(run_.termination, best_);
      break;
    }
    if (!recentre() && best_ > run_.tolerance()) return run_.finish(run_.termination, best_);
    if (!use_values_ && !(best_ <= kProgress * before) && best_ > run_.tolerance()) {
      return run_.finish(Termination::kStalled, best_, "the line search finds no decrease");
    }
    use_values_ = false;
  }
  return finish_converged(run_, result_, best_);
}

Summary minimise(const Problem& problem, std::span<double> x, const Options& options,
                 ceres::LineSearchDirectionType direction, int max_iterations) {
  silence_ceres();
  Run run(problem, x, options, max_iterations);
  return Session(run, x).minimise(direction);
}

}  // namespace

Summary ceres_lbfgs(const Problem& problem, std::span<double> x, const Options& options) {
  return minimise(problem, x, options, ceres::LBFGS, kMaxIterations);
}

Summary ceres_bfgs(const Problem& problem, std::span<double> x, const Options& options) {
  if (x.size() > kLargestBfgs) {
    return Run(problem, x, options, kMaxIterations)
        .finish(Termination::kNumericalFailure, kInfinity,
                "ceres-bfgs keeps a dense matrix and takes at most 1000 variables; "
                "use ceres-lbfgs");
  }
  return minimise(problem, x, options, ceres::BFGS, kMaxIterations);
}

Summary ceres_cg(const Problem& problem, std::span<double> x, const Options& options) {
  return minimise(problem, x, options, ceres::NONLINEAR_CONJUGATE_GRADIENT, kMaxIterations);
}

Summary ceres_steepest_descent(const Problem& problem, std::span<double> x,
                               const Options& options) {
  return minimise(problem, x, options, ceres::STEEPEST_DESCENT, kMaxSteepestDescent);
}

}  // namespace tripus::solver::detail
