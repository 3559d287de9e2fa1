#include "solver/detail/newton_loop.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "solver/detail/conjugate_gradients.hpp"
#include "solver/detail/regularised.hpp"
#include "solver/detail/vectors.hpp"

// Newton's method for a convex function of class C1, globalised by its gradient alone.
//
// Values of f are not used. They cost more than gradients, and near the minimum f - min f is the
// square of the distance, so that they stop telling points apart at half the digits. Gradients do
// not: max|g| is meaningful down to rounding.
//
// A step. Let d solve (H + mu D + Z) d = -g and phi(t) = f(x + t d). phi is convex, so phi' is
// monotone; phi'(t) = g(x + t d).d costs one gradient. A trial t is accepted
//   (A) when max|g(x + t d)| <= 1/2 (the least max|g| so far), or
//   (B) when 0.9 phi'(0) <= phi'(t) <= 0.
// t = 1 is tried first. While phi' < 0.9 phi'(0) the step is too short and is extended; once phi' >
// 0 somewhere, the two ends bracket the acceptable interval and are closed in on by secant steps
// mixed with bisection. phi' is continuous, so the interval (B) is met unless phi' never rises, and
// then f has no minimiser in that direction.
//
// Convergence. Let f have a bounded set of minimisers. Then its level sets are bounded.
// If (A) happens infinitely often, max|g| falls below any tolerance. Otherwise, from some iterate
// on all steps are (B). As phi' <= 0 on [0,t], f does not increase, and the iterates stay in a
// bounded level set, on which g is uniformly continuous. As phi' has risen by 0.1 |phi'(0)|, the
// step t|d| has a length that is bounded below in terms of |phi'(0)|/|d|, and up to where phi' =
// 0.9 phi'(0) the function falls by at least 0.9 |phi'(0)|/|d| times that length (for a Lipschitz
// gradient with constant L: by 0.09 (phi'(0)/|d|)^2 / L). f is bounded below, so phi'(0)/|d| -> 0;
// the cosine of the angle between d and -g is kept above kMinCosine, so |g| -> 0. Since the number
// of (A) steps needed from any start is finite, the loop ends in either case. Close to a minimiser
// with positive definite Hessian full steps satisfy (A), which is insensitive to rounding: the last
// phase is plain Newton, quadratically convergent. Minimisers with singular Hessian, like that of
// x^p, have full steps which divide the gradient by (1 - 1/(p-1))^(1-p) > 2: also (A).
//
// Regularisation. D = max(diag H, mean of diag H); mu = 0 unless the factorisation fails, d is not
// a good descent direction, or steps come out short. Z is the mean diagonal where a row of H
// vanishes (all that a variable touches is flat or saturated): there the step is that of gradient
// descent. A saturated gradient with a small but positive Hessian asks for absurd steps. They are
// limited to kStepGrowth (1 + max|x|) by choosing mu so that |g| / (mu D) has that size: all the
// saturated variables then move alike, instead of the worst one alone.
//
// Saturated starts. Far out f may be piecewise linear but for narrow bends: there a Hessian that
// vanishes says nothing, and descent zigzags from bend to bend. If at the start the Newton step of
// some variable would exceed the limit above and f falls towards the origin, the first step goes
// along that ray to where f stops falling (to kRayRatio, by bisection of log s in s x). f does not
// rise on it, and it is one step, so that the argument above stands.
//
// No minimiser. If the iterate is kRunaway away from the start, it runs away (in a dozen extensions
// of one step, where f falls linearly). If f falls like exp(-x) the gradient does reach the
// tolerance, at no minimiser. It betrays itself in the polishing steps: near a minimiser a step is
// tiny or divides the gradient by much; here steps stay long and divide the gradient only by e.

namespace tripus::solver::detail {
namespace {

constexpr double kAccept = 0.5;          // (A): factor of decrease of max|g|
constexpr double kCurvature = 0.9;       // (B): phi' must rise to this part of phi'(0)
constexpr double kTarget = 0.3;          // the part of phi'(0) at which secant steps aim
constexpr int kMaxTrials = 60;           // of one line search
constexpr double kTinyStep = 1e-10;      // in units of 1 + max|x|: rounding rules
constexpr int kTinySteps = 3;            // so many without halving max|g|: stalled
constexpr double kForcing = 0.1;         // loosest relative residual of a linear solve
constexpr double kPolishForcing = 1e-3;  // and that of the last step
constexpr double kEscapeStep = 1e-3;     // a polishing step longer than this, in 1 + max|x|,
constexpr double kEscapeFactor = 0.1;    // which leaves this much of max|g|,
constexpr int kEscapeSteps = 3;          // so often in a row: a gradient that fades at infinity

constexpr double kRayRatio = 1.05;       // how well the minimum along a ray is located
constexpr double kShortestRay = 1e-300;  // in units of the start

constexpr char kFadesMessage[] = "the gradient vanishes only at infinity";
constexpr char kRanAwayMessage[] = "the iterates run away";
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// State of one run. Vectors are [n] slices of one allocation.
class Loop {
 public:
  Loop(Run& run, NewtonSystem& system, std::span<double> x)
      : run_(run), system_(system, x.size()), result_(x), n_(x.size()), memory_(6 * n_) {
    double* at = memory_.data();
    for (std::span<double>* v : {&x_, &g_, &trial_x_, &trial_g_, &d_, &best_x_}) {
      *v = {at, n_};
      at += n_;
    }
    std::copy(x.begin(), x.end(), x_.begin());
  }

  Summary minimise();

  /// Polishing steps from x, unseen by the observer. See fades_at_infinity.
  bool escapes();

 private:
  enum class Search { kAccepted, kFailed, kRanAway, kStopped };

  bool is_saturated() const;
  bool shrink();
  bool evaluate_on_ray(double scale, Order order, double& slope);
  bool evaluate_trial(double t, Order order);
  void accept_trial();
  void compute_direction(double forcing);
  Search search();
  bool cross_bend();
  double next_trial(double t, int trial) const;
  bool update(double previous);
  Summary polish();
  Summary finish(Termination why, const char* message = "");
  double size() const { return 1 + max_abs(x_); }

  Run& run_;
  RegularisedSystem system_;
  std::span<double> result_;
  std::size_t n_;
  /// The latest evaluation: at x_ between steps, in a search at a trial.
  std::unique_ptr<Evaluation> at_;
  std::vector<double> memory_;
  std::span<double> x_, g_, trial_x_, trial_g_, d_, best_x_;
  double gradient_ = 0, trial_gradient_ = 0;                    // max|g| at x_ and at trial_x_
  double best_ = kInfinity;                                     // least max|g| of an accepted point
  bool x_is_best_ = true;                                       // else best_x_ holds it
  double slope_ = 0;                                            // phi'(0)
  double step_ = 1;                                             // the accepted t
  double low_ = 0, low_slope_ = 0, high_ = 0, high_slope_ = 0;  // bracket of the line search
  double runaway_ = 0;
  int tiny_steps_ = 0;
  bool observed_ = true;
};

Summary Loop::minimise() {
  const double start_size = max_abs(x_);
  if (!(start_size < kInfinity)) {
    return run_.finish(Termination::kNumericalFailure, kInfinity, "the start is not finite");
  }
  runaway_ = kRunaway * (1 + start_size);
  if (!run_.evaluate(x_, Order::kSecond, at_, g_, gradient_)) {
    return run_.finish(Termination::kNumericalFailure, kInfinity,
                       "the gradient is not defined at the start");
  }
  best_ = gradient_;
  double forcing = kForcing;
  if (!run_.observe(x_, gradient_)) return finish(run_.termination);
  if (gradient_ > run_.tolerance() && is_saturated() && shrink() && !run_.observe(x_, gradient_)) {
    return finish(run_.termination);
  }
  while (gradient_ > run_.tolerance()) {
    const double previous = gradient_;
    compute_direction(forcing);
    switch (search()) {
      case Search::kAccepted:
        break;
      case Search::kFailed:
        if (!cross_bend()) {
          return finish(Termination::kStalled, "no acceptable step in floating point");
        }
        break;
      case Search::kRanAway:
        run_.observe(x_, gradient_);
        return finish(Termination::kUnbounded, kRanAwayMessage);
      case Search::kStopped:
        return finish(run_.termination);
    }
    const bool progress = update(previous);
    if (!run_.observe(x_, gradient_)) return finish(run_.termination);
    if (!progress && gradient_ > run_.tolerance())
      return finish(Termination::kStalled, "steps are down to rounding");
    if (max_abs(x_) > runaway_) return finish(Termination::kUnbounded, kRanAwayMessage);
    // Eisenstat and Walker, SIAM J. Sci. Comput. 17 (1996), choice 2; never tighter than needed to
    // bring the gradient to a hundredth of the tolerance.
    const double ratio = gradient_ / previous;
    forcing = std::clamp(0.9 * ratio * ratio,
                         std::min(kForcing, 0.01 * run_.tolerance() / gradient_), kForcing);
  }
  return polish();
}

/// Whether f bends too little for some variable's Newton step to mean anything.
bool Loop::is_saturated() const {
  at_->hessian_diagonal_blocks(1, d_);
  const double longest = kStepGrowth * size();
  for (std::size_t i = 0; i < n_; ++i)
    if (d_[i] * longest < std::fabs(g_[i])) return true;
  return false;
}

/// Evaluates at scale * x; slope is the derivative by scale.
bool Loop::evaluate_on_ray(double scale, Order order, double& slope) {
  for (std::size_t i = 0; i < n_; ++i) trial_x_[i] = scale * x_[i];
  const bool defined = run_.evaluate(trial_x_, order, at_, trial_g_, trial_gradient_);
  slope = dot(trial_g_.data(), x_.data(), n_);
  return defined;
}

/// Along the ray to the origin to where f stops falling. Returns false if it does not fall that
/// way; then at_ is again at x.
bool Loop::shrink() {
  if (!(dot(g_.data(), x_.data(), n_) > 0)) return false;
  double outer = 1, inner = 0.25, slope = 0;
  while (inner > kShortestRay && evaluate_on_ray(inner, Order::kFirst, slope) && slope > 0) {
    outer = inner;
    inner *= inner;
  }
  while (outer > kRayRatio * inner) {
    const double middle = std::sqrt(outer) * std::sqrt(inner);
    if (!evaluate_on_ray(middle, Order::kFirst, slope)) break;
    (slope > 0 ? outer : inner) = middle;
  }
  const bool moved = evaluate_on_ray(outer, Order::kSecond, slope) && outer < 1;
  if (moved) accept_trial();
  return moved;
}

bool Loop::evaluate_trial(double t, Order order) {
  for (std::size_t i = 0; i < n_; ++i) trial_x_[i] = x_[i] + t * d_[i];
  return run_.evaluate(trial_x_, order, at_, trial_g_, trial_gradient_);
}

void Loop::accept_trial() {
  const bool improves = trial_gradient_ < best_;
  if (!improves && x_is_best_) std::copy(x_.begin(), x_.end(), best_x_.begin());
  x_is_best_ = improves;
  if (improves) best_ = trial_gradient_;
  std::swap(x_, trial_x_);
  std::swap(g_, trial_g_);
  gradient_ = trial_gradient_;
  ++run_.iterations;
}

void Loop::compute_direction(double forcing) {
  slope_ = system_.compute(*at_, g_, gradient_, kStepGrowth * size(), forcing, d_);
  run_.linear_iterations = system_.linear_iterations();
}

Loop::Search Loop::search() {
  low_ = 0;
  low_slope_ = slope_;
  high_ = kInfinity;
  const double shortest = std::numeric_limits<double>::epsilon() * size() / max_abs(d_);
  double t = 1;
  for (int trial = 1; trial <= kMaxTrials; ++trial) {
    const bool defined = evaluate_trial(t, Order::kSecond);
    if (run_.out_of_time()) return Search::kStopped;
    step_ = t;
    if (defined && trial_gradient_ <= kAccept * best_) {
      accept_trial();
      return Search::kAccepted;
    }
    const double slope = defined ? dot(trial_g_.data(), d_.data(), n_) : kInfinity;
    if (slope <= 0 && slope >= kCurvature * slope_) {
      accept_trial();
      return Search::kAccepted;
    }
    if (slope > 0 || std::isnan(slope)) {
      high_ = t;
      high_slope_ = slope;
    } else {
      low_ = t;
      low_slope_ = slope;
      if (high_ == kInfinity && max_abs(trial_x_) > runaway_) {
        accept_trial();
        return Search::kRanAway;
      }
    }
    t = next_trial(t, trial);
    if (!(t > low_ && t < high_ && high_ - low_ > shortest)) return Search::kFailed;
  }
  return Search::kFailed;
}

/// After a search that closed in on a bend narrower than rounding: to the far side of it, and if f
/// is saturated there, on along the ray to the origin. Returns false if the bend is where x is.
bool Loop::cross_bend() {
  if (!(low_ > 0) || !(high_slope_ < kInfinity)) return false;
  if (low_ * max_abs(d_) <= kTinyStep * size()) return false;
  step_ = high_;
  if (!evaluate_trial(high_, Order::kSecond)) return false;
  accept_trial();
  if (is_saturated()) shrink();
  return true;
}

double Loop::next_trial(double t, int trial) const {
  constexpr double kExtend = 4;
  constexpr double kIntoDomain = 0.25;
  if (high_ == kInfinity) return kExtend * t;
  const double width = high_ - low_;
  if (!(high_slope_ < kInfinity)) return low_ + kIntoDomain * width;
  if (trial % 3 == 0) return low_ + 0.5 * width;
  const double part = (kTarget * slope_ - low_slope_) / (high_slope_ - low_slope_);
  return low_ + std::clamp(part, 0.05, 0.95) * width;
}

/// After an accepted step. Returns false when rounding rules.
bool Loop::update(double previous) {
  const bool good = gradient_ <= kAccept * previous;
  system_.adapt(good, step_);
  const bool tiny = step_ * max_abs(d_) <= kTinyStep * size();
  tiny_steps_ = tiny && !good ? tiny_steps_ + 1 : 0;
  return tiny_steps_ < kTinySteps;
}

Summary Loop::polish() {
  for (int escapes = 0; gradient_ > 0 && run_.iterations < run_.max_iterations();) {
    if (run_.out_of_time()) break;
    const double allowed = kEscapeStep * size();
    compute_direction(kPolishForcing);
    const bool long_step = max_abs(d_) > allowed;
    if (!evaluate_trial(1, long_step ? Order::kSecond : Order::kFirst) ||
        !(trial_gradient_ < gradient_))
      break;
    const double previous = gradient_;
    accept_trial();
    if (observed_ && !run_.observe(x_, gradient_)) return finish(run_.termination);
    if (!long_step || gradient_ <= kEscapeFactor * previous) break;
    if (++escapes == kEscapeSteps) {
      return finish(Termination::kUnbounded, kFadesMessage);
    }
  }
  return finish(Termination::kConverged);
}

bool Loop::escapes() {
  const int iterations = run_.iterations;
  const long linear_iterations = run_.linear_iterations;
  bool fades = false;
  if (run_.evaluate(x_, Order::kSecond, at_, g_, gradient_)) {
    observed_ = false;
    fades = polish().termination == Termination::kUnbounded;
  }
  run_.iterations = iterations;
  run_.linear_iterations = linear_iterations;
  return fades;
}

Summary Loop::finish(Termination why, const char* message) {
  const std::span<const double> best = x_is_best_ ? x_ : best_x_;
  std::copy(best.begin(), best.end(), result_.begin());
  return run_.finish(why, best_, message);
}

}  // namespace

Summary newton_loop(Run& run, NewtonSystem& system, std::span<double> x) {
  return Loop(run, system, x).minimise();
}

}  // namespace tripus::solver::detail

namespace tripus::solver {

bool fades_at_infinity(Run& run, std::span<const double> x) {
  detail::ConjugateGradients system(run.problem().dimension(), 1);
  std::vector<double> copy(x.begin(), x.end());
  return detail::Loop(run, system, copy).escapes();
}

Summary finish_converged(Run& run, std::span<const double> x, double max_gradient) {
  return max_gradient > 0 && fades_at_infinity(run, x)
             ? run.finish(Termination::kUnbounded, max_gradient, detail::kFadesMessage)
             : run.finish(Termination::kConverged, max_gradient);
}

}  // namespace tripus::solver
