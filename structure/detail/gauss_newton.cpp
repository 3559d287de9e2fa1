#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <random>

#include <Eigen/Dense>

#include "base/error.hpp"
#include "structure/detail/other_ways.hpp"

namespace tripus::structure::detail {
namespace {

using Vector = Eigen::VectorXd;
using Clock = std::chrono::steady_clock;

/// The dense eigenvalue problem of each step: some 0.1 s at this size.
constexpr std::size_t kMostEdges = 500;
constexpr int kStarts = 24;
constexpr int kSteps = 100;
constexpr int kHalvings = 12;
constexpr double kEqualStarts[] = {0.5, 1.0, 0.3, 1.5};
constexpr double kLongestStep = 0.5;  // of one length
constexpr double kShortestEdge = 1e-3;
/// Of the largest eigenvalue: below, a direction in which finite vertices move freely.
constexpr double kFreeDirection = 1e-9;
constexpr double kNever = std::numeric_limits<double>::infinity();

/// One solve, over all starts.
class Search {
 public:
  Search(const topology::Triangulation& triangulation, const energies::CoVolume& energy,
         const SolveOptions& options)
      : energy_(energy),
        options_(options),
        n_(static_cast<Eigen::Index>(triangulation.edge_count())),
        gradient_(n_),
        values_(energy.hessian_pattern().row.size()) {}

  solver::Summary run(std::vector<double>& x) {
    std::mt19937_64 random(1);
    best_ = Vector::Constant(n_, kEqualStarts[0]);
    for (int start = 0; start < kStarts && least_ > options_.tolerance && !stopped(); ++start) {
      descend(start_point(start, random));
      if (!options_.initial_lengths.empty() || options_.initial_length > 0) break;
    }
    x.assign(best_.begin(), best_.end());
    solver::Summary summary;
    summary.iterations = iterations_;
    summary.evaluations = evaluations_;
    summary.max_gradient = least_;
    summary.seconds = seconds();
    summary.termination = least_ <= options_.tolerance ? solver::Termination::kConverged : why_;
    return summary;
  }

 private:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - began_).count(); }

  bool stopped() {
    if (options_.stop.requested()) {
      why_ = solver::Termination::kInterrupted;
    } else if (seconds() > options_.time_limit) {
      why_ = solver::Termination::kTimeLimit;
    } else if (options_.max_iterations > 0 && iterations_ >= options_.max_iterations) {
      why_ = solver::Termination::kIterationLimit;
    } else {
      return false;
    }
    return true;
  }

  Vector start_point(int start, std::mt19937_64& random) const {
    Vector x(n_);
    const double equal = options_.initial_length > 0 ? options_.initial_length
                                                     : kEqualStarts[std::size_t(start) % 4];
    for (Eigen::Index e = 0; e < n_; ++e) {
      const auto edge = static_cast<std::size_t>(e);
      const double spread = double(random() >> 11) * 0x1p-53 - 0.5;
      x[e] = options_.initial_lengths.empty() ? equal * (start < 4 ? 1 : std::exp(spread))
                                              : options_.initial_lengths[edge];
      if (energy_.cone_angles()[edge] == 0) x[e] = 0;
    }
    return x;
  }

  /// |K|, and max|K|; infinite where some tetrahedron is not a true one.
  double misfit(const Vector& x) {
    ++evaluations_;
    if (!energy_.evaluate({x.data(), std::size_t(n_)}, solver::Order::kSecond, at_)) return kNever;
    std::ranges::copy(at_->gradient(), gradient_.begin());
    return gradient_.norm();
  }

  /// The least step that makes the linearised K least.
  Vector step() {
    Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(n_, n_);
    at_->hessian_values(values_);
    const solver::SparsityPattern& pattern = energy_.hessian_pattern();
    for (Eigen::Index column = 0; column < n_; ++column)
      for (auto k = pattern.column_start[std::size_t(column)];
           k < pattern.column_start[std::size_t(column) + 1]; ++k)
        hessian(pattern.row[std::size_t(k)], column) = values_[std::size_t(k)];
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(hessian);
    Vector along = eigen.eigenvectors().transpose() * gradient_;
    const double least = kFreeDirection * eigen.eigenvalues().cwiseAbs().maxCoeff();
    for (Eigen::Index i = 0; i < n_; ++i) {
      const double value = eigen.eigenvalues()[i];
      along[i] = std::fabs(value) > least ? -along[i] / value : 0;
    }
    return eigen.eigenvectors() * along;
  }

  void descend(Vector x) {
    double norm = misfit(x);
    for (int k = 0; k < kSteps && norm < kNever && !stopped(); ++k) {
      remember(x);
      if (least_ <= options_.tolerance / 8) return;
      const Vector d = step();
      double t = std::min(1.0, kLongestStep / d.cwiseAbs().maxCoeff());
      bool better = false;
      for (int halving = 0; halving < kHalvings && !better; ++halving, t /= 2) {
        const Vector trial = moved(x, t * d);
        const double found = misfit(trial);
        better = found < norm * (1 - 1e-4 * t);
        if (!better) continue;
        x = trial;
        norm = found;
      }
      if (!better) return;
      ++iterations_;
      if (options_.on_iteration)
        options_.on_iteration(iterations_, gradient_.cwiseAbs().maxCoeff());
    }
    if (norm < kNever) remember(x);
  }

  Vector moved(const Vector& x, const Vector& by) const {
    Vector trial = x + by;
    for (Eigen::Index e = 0; e < n_; ++e)
      trial[e] = energy_.cone_angles()[std::size_t(e)] == 0 ? 0 : std::max(trial[e], kShortestEdge);
    return trial;
  }

  void remember(const Vector& x) {
    const double most = gradient_.cwiseAbs().maxCoeff();
    if (!(most < least_)) return;
    least_ = most;
    best_ = x;
  }

  const energies::CoVolume& energy_;
  const SolveOptions& options_;
  Eigen::Index n_;
  std::unique_ptr<solver::Evaluation> at_;  // where the misfit was asked for last
  Vector gradient_, best_;
  std::vector<double> values_;
  double least_ = kNever;
  int iterations_ = 0, evaluations_ = 0;
  solver::Termination why_ = solver::Termination::kStalled;
  const Clock::time_point began_ = Clock::now();
};

}  // namespace

solver::Summary gauss_newton(const topology::Triangulation& triangulation,
                             const energies::CoVolume& energy, const SolveOptions& options,
                             std::vector<double>& x) {
  if (triangulation.edge_count() > kMostEdges)
    throw Unsupported("with finite vertices a metric is looked for on triangulations of up to " +
                      std::to_string(kMostEdges) + " edge classes, not " +
                      std::to_string(triangulation.edge_count()) +
                      "; simplify first (tripus simplify)");
  return Search(triangulation, energy, options).run(x);
}

}  // namespace tripus::structure::detail
