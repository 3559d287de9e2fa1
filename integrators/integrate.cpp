#include "integrators/integrate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "base/error.hpp"

// Steps of a flow towards its zero.
//
// Only the end of the trajectory is wanted exactly, and it is a zero of g, at which every explicit
// step stands still: no error of the integration is left in the answer. What a step must not do is
// leave the stability region. With a(x) the largest eigenvalue of -dF/dx, steps below stability / a
// contract every mode. Steppers without error estimate take kFraction of that; a is found by power
// iteration, from the previous eigenvector, every kRefresh steps. Where the Jacobian vanishes a
// step covers at most 1 + max|x|, and is halved if the gradient then points against it: it has
// jumped over the valley.
//
// The adaptive stepper keeps its local error at a fixed part of the distance that the step covers,
// and not below a fixed bound. So the error shrinks with the residual, the step length tends to a
// constant, set by accuracy or by stability, and max|g| decreases geometrically down to rounding.
//
// Steps may be far shorter than the rounding of x. So what odeint sees is the displacement from the
// latest x, which starts at what rounding has left over of the previous step.
//
// What a fixed step may do beyond its stability limit, where the power iteration has underestimated
// that, is caught by two signs, up to what rounding of x does to g. The flows all go downhill: a
// step at whose end the slope along it is nearly as steep the other way has crossed a valley. And
// where the exact flow has decreasing |g| (Field::contractive), so has a stable step. The adaptive
// stepper has its error estimate, and only a coarser form of the second test.

namespace tripus::integrators {
namespace {

using solver::max_abs;
using solver::Run;
using solver::Summary;
using solver::Termination;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kMaxSteps = 1000000;
constexpr double kFraction = 0.8;           // of the stability limit
constexpr int kRefresh = 50;                // steps between estimates of the Jacobian's norm
constexpr int kFirstPower = 30;             // power iterations at the start,
constexpr int kPower = 5;                   // and at a refresh
constexpr double kContractiveGrowth = 1.5;  // of |g| over its least so far, adaptive steppers
constexpr double kUphill = 0.9;       // slope at the end of a step, in units of that at its start
constexpr double kNoise = 1e-14;      // of x, relative: what it does to g is no increase of |g|
constexpr double kGrowth = 2;         // of |g| in a step, in the others
constexpr double kRounding = 1e-15;   // error of a step in units of 1 + max|x|, not to be bettered
constexpr double kInstability = 1e6;  // of max|g| over its start: a given step was too long
constexpr int kPatience = 5;          // rejections for the error: then there is a kink here
constexpr double kStandstill = 1e-250;  // max|dx/dt| that no step of at most
constexpr double kLongest = 1e250;      // this can make visible
constexpr int kIdleSteps = 20000;       // without max|g| falling by a tenth: stalled
constexpr double kProgress = 0.9;

double norm(const State& v) {
  double sum = 0;
  for (const double value : v) sum += value * value;
  return std::sqrt(sum);
}

double dot(const State& a, const State& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

class Integration {
 public:
  Integration(Run& run, Field& field, const Stepper& stepper, std::span<double> x,
              const FlowOptions& options)
      : run_(run),
        field_(field),
        stepper_(stepper),
        method_(stepper.make(x.size())),
        options_(options),
        result_(x),
        x_(x.begin(), x.end()),
        new_x_(x_),
        v_(x_.size()),
        new_v_(v_),
        g_(v_),
        new_g_(v_),
        error_(v_),
        displacement_(v_),
        remainder_(v_),
        eigenvector_(v_),
        product_(v_) {}

  Summary follow();

 private:
  enum class Verdict { kAccepted, kRejected, kStopped };

  bool start();
  bool advance();
  void refresh(int iterations);
  double choose_step();
  double noise() const;
  double largest_gradient() const;
  bool overshoots() const;
  Verdict judge();
  void accept();
  bool idle();
  Summary finish(Termination why, const char* message = "");
  bool automatic() const { return options_.step == 0; }

  Run& run_;
  Field& field_;
  const Stepper& stepper_;
  std::unique_ptr<StepMethod> method_;
  const FlowOptions& options_;
  std::span<double> result_;
  State x_, new_x_, v_, new_v_, g_, new_g_, error_;  // [n]; the new ones belong to the trial
  State displacement_, remainder_;  // of the trial from x_; of the latest x by rounding
  State eigenvector_, product_;
  std::unique_ptr<solver::Evaluation> at_;                  // for the Jacobian
  double gradient_ = kInfinity, new_gradient_ = kInfinity;  // max|g|
  double stiffness_ = 0;  // estimate of the largest eigenvalue of -dF/dx
  double safety_ = 1;     // further factor of the step, after rejections
  double dt_ = 0, next_dt_ = 0, usual_dt_ = 0, time_ = 0;
  bool limited_ = false;           // dt_ is limited by the distance, not by stability
  bool failed_ = false;            // F was not defined at a stage of the trial
  double least_norm_ = kInfinity;  // of the gradient, Euclidean
  double reference_ = kInfinity, first_ = kInfinity;
  int rejections_ = 0;  // of the current step
  int idle_ = 0, since_refresh_ = 0;
};

bool Integration::start() {
  if (!(max_abs(x_) < kInfinity) || !field_.evaluate(run_, x_, v_, g_, gradient_)) return false;
  first_ = reference_ = gradient_;
  least_norm_ = norm(g_);
  for (std::size_t i = 0; i < x_.size(); ++i) {
    eigenvector_[i] = 1 + 0.5 * std::sin(static_cast<double>(7 * i + 1));
    if (i % 2 == 1) eigenvector_[i] = -eigenvector_[i];
  }
  return true;
}

void Integration::refresh(int iterations) {
  since_refresh_ = 0;
  double unused = 0;
  if (!run_.evaluate(x_, solver::Order::kSecond, at_, product_, unused)) return;
  const Jacobian jacobian = field_.jacobian(x_, *at_);
  double length = norm(eigenvector_);
  for (int k = 0; k < iterations && length > 0; ++k) {
    for (double& value : eigenvector_) value /= length;
    jacobian(eigenvector_, product_);
    const double image = norm(product_);
    stiffness_ = image;
    if (!(image > 0) || !(image < kInfinity)) break;
    // Keep a little of the old vector, so that a zero Jacobian here does not lose it.
    for (std::size_t i = 0; i < x_.size(); ++i) {
      eigenvector_[i] = product_[i] / image + 1e-3 * eigenvector_[i];
    }
    length = norm(eigenvector_);
  }
}

/// Length of the next trial; sets limited_.
double Integration::choose_step() {
  limited_ = false;
  if (!automatic()) return options_.step;
  if (stepper_.adaptive && next_dt_ > 0) return next_dt_;
  if (since_refresh_ >= kRefresh || stiffness_ == 0) {
    refresh(run_.iterations == 0 ? kFirstPower : kPower);
    safety_ = std::min(1.0, 1.25 * safety_);
  }
  const double stable =
      std::min(field_.longest_step(), kFraction * stepper_.stability / stiffness_);
  const double far = (1 + max_abs(x_)) / max_abs(v_);
  limited_ = far < stable;
  return std::min(safety_ * std::min(stable, far), kLongest);
}

/// What rounding of x does to |g|.
double Integration::noise() const { return kNoise * (1 + max_abs(x_)) * stiffness_; }

/// The largest |g| that a trial may end with.
double Integration::largest_gradient() const {
  if (!field_.contractive()) return kGrowth * norm(g_);
  return stepper_.adaptive ? kContractiveGrowth * least_norm_ : norm(g_) + noise();
}

/// Whether the trial has jumped over a valley, or onto a plain where the flow stands still.
bool Integration::overshoots() const {
  if (max_abs(new_v_) < kStandstill && new_gradient_ > run_.tolerance()) return true;
  // Less than half of Euler's step: some stages have jumped over the valley.
  if (limited_ && (dot(new_g_, v_) > 0 || dot(displacement_, v_) < 0.5 * dt_ * dot(v_, v_)))
    return true;
  if (stepper_.adaptive) return false;
  const double slope = std::abs(dot(g_, displacement_));
  return dot(new_g_, displacement_) > kUphill * slope + noise() * norm(displacement_);
}

/// After a trial step of length dt_.
Integration::Verdict Integration::judge() {
  if (run_.out_of_time()) return Verdict::kStopped;
  if (failed_ || !(max_abs(new_x_) < kInfinity)) {
    dt_ *= 0.25;
    return Verdict::kRejected;
  }
  if (!automatic()) return Verdict::kAccepted;
  if (stepper_.adaptive) {
    double distance = 0;
    for (std::size_t i = 0; i < x_.size(); ++i) {
      distance = std::max(distance, std::abs(displacement_[i] - remainder_[i]));
    }
    const double rounding = kRounding * (1 + max_abs(x_));
    const double allowed = options_.relative_error * distance;
    const double part = max_abs(error_) / std::max(allowed, rounding);
    const double factor = std::isfinite(part) ? 0.9 * std::pow(std::max(part, 1e-10), -0.2) : 0.2;
    next_dt_ = std::min(kLongest, dt_ * std::clamp(factor, 0.2, 5.0));
    // Where rounding hides the error, the estimate no longer sees instability.
    if (allowed > rounding) {
      usual_dt_ = std::max(0.99 * usual_dt_, dt_);
    } else {
      next_dt_ = std::min(next_dt_, 0.7 * usual_dt_);
    }
    if (!(part <= 1) && rejections_ < kPatience) {
      dt_ = next_dt_;
      return Verdict::kRejected;
    }
  }
  if (overshoots() || !(norm(new_g_) <= largest_gradient())) {
    safety_ *= 0.5;
    dt_ *= 0.5;
    next_dt_ = dt_;
    return Verdict::kRejected;
  }
  return Verdict::kAccepted;
}

void Integration::accept() {
  for (std::size_t i = 0; i < x_.size(); ++i) {
    remainder_[i] = displacement_[i] - (new_x_[i] - x_[i]);
  }
  std::swap(x_, new_x_);
  std::swap(v_, new_v_);
  std::swap(g_, new_g_);
  gradient_ = new_gradient_;
  least_norm_ = std::min(least_norm_, norm(g_));
  time_ += dt_;
  ++run_.iterations;
  ++since_refresh_;
  // A step limited by distance says nothing about the Jacobian at its end.
  if (limited_) stiffness_ = 0;
}

/// One accepted step. Returns false where there is none; run_.termination says why.
bool Integration::advance() {
  const Rhs rhs = [this](const State& displacement, State& velocity) {
    for (std::size_t i = 0; i < x_.size(); ++i) new_x_[i] = x_[i] + displacement[i];
    if (!failed_ && field_.evaluate(run_, new_x_, velocity, new_g_, new_gradient_)) return;
    failed_ = true;
    std::fill(velocity.begin(), velocity.end(), 0.0);
  };
  dt_ = choose_step();
  for (rejections_ = 0;; ++rejections_) {
    // A step that does not show in the time is none.
    if (!(time_ + dt_ > time_)) {
      run_.termination = Termination::kStalled;
      return false;
    }
    failed_ = false;
    method_->step(rhs, remainder_, v_, dt_, displacement_, new_v_, error_);
    switch (judge()) {
      case Verdict::kAccepted:
        accept();
        return true;
      case Verdict::kStopped:
        return false;
      case Verdict::kRejected:
        break;
    }
    const double shortest = std::numeric_limits<double>::epsilon() * (1 + max_abs(x_));
    if (!(dt_ * max_abs(v_) > shortest)) {
      run_.termination = Termination::kStalled;
      return false;
    }
  }
}

bool Integration::idle() {
  if (gradient_ <= kProgress * reference_) {
    reference_ = gradient_;
    idle_ = 0;
  }
  return automatic() && ++idle_ > kIdleSteps;
}

Summary Integration::follow() {
  if (!start()) {
    return run_.finish(Termination::kNumericalFailure, kInfinity,
                       "the flow is not defined at the start");
  }
  const double runaway = solver::kRunaway * (1 + max_abs(x_));
  if (!run_.observe(x_, gradient_, time_)) return finish(run_.termination);
  while (gradient_ > run_.tolerance()) {
    if (max_abs(v_) < kStandstill) return finish(Termination::kStalled, "the flow stands still");
    if (!advance()) {
      const bool stalled = run_.termination == Termination::kStalled;
      return finish(run_.termination, stalled ? "no step decreases the gradient" : "");
    }
    if (!run_.observe(x_, gradient_, time_)) return finish(run_.termination);
    if (!automatic() && gradient_ > kInstability * first_) {
      return finish(Termination::kNumericalFailure, "unstable: the given step is too long");
    }
    if (max_abs(x_) > runaway) return finish(Termination::kUnbounded, "the flow runs away");
    if (idle())
      return finish(Termination::kStalled,
                    "20,000 steps have not brought max|gradient| down by a tenth");
  }
  std::copy(x_.begin(), x_.end(), result_.begin());
  return finish_converged(run_, x_, gradient_);
}

Summary Integration::finish(Termination why, const char* message) {
  std::copy(x_.begin(), x_.end(), result_.begin());
  return run_.finish(why, gradient_, message);
}

}  // namespace

void validate(const FlowOptions& options) {
  if (!(options.step >= 0) || !std::isfinite(options.step)) {
    throw InvalidInput("step is " + std::to_string(options.step) +
                       "; it must be finite and at least 0 (0: chosen automatically)");
  }
  if (!(options.relative_error > 0) || !std::isfinite(options.relative_error)) {
    throw InvalidInput("relative_error is " + std::to_string(options.relative_error) +
                       "; it must be finite and greater than 0");
  }
}

Summary integrate(const solver::Problem& problem, const Flow& flow, const Stepper& stepper,
                  std::span<double> x, const solver::Options& options,
                  const FlowOptions& flow_options) {
  validate(flow_options);
  Run run(problem, x, options, kMaxSteps);
  const std::unique_ptr<Field> field = flow.make(problem);
  return Integration(run, *field, stepper, x, flow_options).follow();
}

std::optional<std::pair<const Flow*, const Stepper*>> parse_flow_method(std::string_view text) {
  constexpr std::string_view kPrefix = "flow:";
  if (!text.starts_with(kPrefix)) return std::nullopt;
  text.remove_prefix(kPrefix.size());
  const std::size_t slash = text.find('/');
  const Flow* flow = find_flow(text.substr(0, slash));
  const Stepper* stepper =
      find_stepper(slash == std::string_view::npos ? "dopri5" : text.substr(slash + 1));
  if (flow == nullptr || stepper == nullptr) return std::nullopt;
  return std::pair{flow, stepper};
}

}  // namespace tripus::integrators
