#include "solver/detail/regularised.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/detail/vectors.hpp"

namespace tripus::solver::detail {
namespace {

constexpr double kMinCosine = 1e-8;  // between d and -g
constexpr double kFirstMu = 1e-12;   // enough where H is singular by rounding only
constexpr double kMuGrowth = 100;    // on failure
constexpr double kLargestMu = 1e4;   // beyond it, the scaled gradient
constexpr double kShortStep = 0.1;   // an accepted t below this raises mu
constexpr double kShortMu = 1e-3;    // to this at least
constexpr double kZeroRow = 1e-13;   // of the mean diagonal: a row that vanishes

}  // namespace

double RegularisedSystem::compute(const Evaluation& at, std::span<const double> g,
                                  double max_gradient, double longest, double forcing,
                                  std::span<double> d) {
  diagonal_ = system_.load(at);
  double sum = 0;
  std::size_t count = 0;
  for (const double h : diagonal_) {
    if (h > 0) {
      sum += h;
      ++count;
    }
  }
  // Flat everywhere: a step of the longest length allowed.
  mean_ = sum > 0 ? sum / static_cast<double>(count) : max_gradient / longest;
  while (!solve(at, g, forcing, d)) {
    if (mu_ > kLargestMu) {
      for (std::size_t i = 0; i < d.size(); ++i) d[i] = -g[i] / std::max(diagonal_[i], mean_);
      slope_ = dot(g.data(), d.data(), d.size());
      break;
    }
    mu_ = std::max(kFirstMu, kMuGrowth * mu_);
  }
  double length = max_abs(d);
  if (length > longest) {
    const double kept = mu_;
    mu_ = std::max(mu_, max_gradient / (longest * mean_));
    if (mu_ > kept && solve(at, g, forcing, d)) length = max_abs(d);
  }
  if (length > longest) {
    const double factor = longest / length;
    for (double& value : d) value *= factor;
    slope_ *= factor;
  }
  return slope_;
}

bool RegularisedSystem::solve(const Evaluation& at, std::span<const double> g, double forcing,
                              std::span<double> d) {
  const double zero_row = kZeroRow * mean_;
  for (std::size_t i = 0; i < d.size(); ++i) {
    const double h = diagonal_[i];
    shift_[i] = mu_ * std::max(h, mean_) + (h > zero_row ? 0 : mean_);
  }
  if (!system_.solve(at, shift_, g, forcing, d)) return false;
  slope_ = dot(g.data(), d.data(), d.size());
  const double norms =
      std::sqrt(dot(g.data(), g.data(), g.size())) * std::sqrt(dot(d.data(), d.data(), d.size()));
  return norms < std::numeric_limits<double>::infinity() && slope_ < 0 &&
         -slope_ >= kMinCosine * norms;
}

void RegularisedSystem::adapt(bool good, double step) {
  if (good) {
    mu_ = std::min(mu_, kFirstMu);
  } else if (step >= 1) {
    mu_ = mu_ > kFirstMu ? 0.1 * mu_ : mu_;
  } else if (step < kShortStep) {
    mu_ = std::max(4 * mu_, kShortMu);
  }
}

}  // namespace tripus::solver::detail
