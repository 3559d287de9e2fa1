#include <algorithm>
#include <exception>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include <ceres/ceres.h>

#include "solver/detail/ceres_methods.hpp"
#include "solver/detail/ceres_silence.hpp"
#include "solver/run.hpp"

// gradient(x) = 0 as a sparse nonlinear least-squares problem: residual e is g_e, its parameter
// blocks (of one variable each) are the variables in row e of the Hessian. One evaluation of the
// Problem a point serves all residuals; the cost functions only copy.
//
// The objective |g|^2 / 2 is not convex, and where the Hessian vanishes so does its gradient H g: a
// start at which everything is flat stays there, and is reported as stalled.

namespace tripus::solver::detail {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kMaxIterations = 1000;
constexpr std::size_t kDense = 64;  // up to here a dense QR factorisation of the Jacobian is faster

/// The point at which Ceres evaluates, the gradient and the Hessian there.
class Shared final : public ceres::EvaluationCallback {
 public:
  Shared(Run& run, std::span<double> x)
      : run_(run), variables(x), at_(x.size()), gradient(x.size()), best_x(x.begin(), x.end()) {
    hessian.resize(run.problem().hessian_pattern().row.size());
    runaway_ = kRunaway * (1 + max_abs(x));
  }

  void PrepareForEvaluation(bool jacobians, bool) override { prepare(jacobians); }

  /// Evaluates at `variables`, unless that was done already.
  void prepare(bool jacobians);

  /// After an accepted step. Returns false to stop.
  bool accept();

 private:
  Run& run_;

 public:
  std::span<double> variables;  // [n], the memory that Ceres writes
 private:
  std::vector<double> at_;
  std::unique_ptr<Evaluation> evaluation_;
  double runaway_;
  bool evaluated_ = false, hessian_read_ = false;

 public:
  std::vector<double> gradient, hessian;  // [n], [nnz]
  std::vector<double> best_x;
  double max_gradient = kInfinity, best = kInfinity;
  bool valid = false, stopped = false;
  std::exception_ptr exception;
};

void Shared::prepare(bool jacobians) {
  if (stopped) {
    valid = false;
    return;
  }
  try {
    if (!evaluated_ || !std::equal(at_.begin(), at_.end(), variables.begin())) {
      std::copy(variables.begin(), variables.end(), at_.begin());
      evaluated_ = true;
      hessian_read_ = false;
      valid = max_abs(at_) < kInfinity &&
              run_.evaluate(at_, Order::kSecond, evaluation_, gradient, max_gradient);
      if (run_.out_of_time()) stopped = true;
    }
    if (jacobians && valid && !hessian_read_) {
      evaluation_->hessian_values(hessian);
      hessian_read_ = true;
    }
  } catch (...) {
    exception = std::current_exception();
    stopped = true;
    valid = false;
  }
}

bool Shared::accept() {
  prepare(false);
  if (!valid || stopped) return false;
  if (max_gradient < best) {
    best = max_gradient;
    best_x = at_;
  }
  try {
    stopped = !run_.observe(at_, max_gradient);
  } catch (...) {
    exception = std::current_exception();
    stopped = true;
  }
  if (!stopped && max_abs(at_) > runaway_) {
    run_.termination = Termination::kUnbounded;
    stopped = true;
  }
  return !stopped && max_gradient > run_.tolerance();
}

/// Residual e and its derivatives, copied from Shared.
class Residual final : public ceres::CostFunction {
 public:
  Residual(const Shared& shared, std::size_t row, std::vector<std::size_t> entries)
      : shared_(shared), row_(row), entries_(std::move(entries)) {
    set_num_residuals(1);
    mutable_parameter_block_sizes()->assign(entries_.size(), 1);
  }

  bool Evaluate(double const* const*, double* residual, double** jacobians) const override {
    if (!shared_.valid) return false;
    *residual = shared_.gradient[row_];
    if (jacobians != nullptr) {
      for (std::size_t k = 0; k < entries_.size(); ++k) {
        if (jacobians[k] != nullptr) *jacobians[k] = shared_.hessian[entries_[k]];
      }
    }
    return true;
  }

 private:
  const Shared& shared_;
  std::size_t row_;
  std::vector<std::size_t> entries_;  // of the Hessian's values
};

class Callback final : public ceres::IterationCallback {
 public:
  Callback(Run& run, Shared& shared) : run_(run), shared_(shared) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override {
    if (shared_.stopped) return ceres::SOLVER_ABORT;
    if (summary.iteration == 0 || !summary.step_is_successful) return ceres::SOLVER_CONTINUE;
    ++run_.iterations;
    return shared_.accept() ? ceres::SOLVER_CONTINUE : ceres::SOLVER_ABORT;
  }

 private:
  Run& run_;
  Shared& shared_;
};

/// One residual a row; the rows of the full symmetric matrix, from its lower triangle.
void add_residuals(ceres::Problem& least_squares, Shared& shared, const SparsityPattern& pattern) {
  const std::size_t n = shared.variables.size();
  std::vector<std::vector<double*>> blocks(n);
  std::vector<std::vector<std::size_t>> entries(n);
  const auto add = [&](std::size_t row, std::size_t column, std::size_t entry) {
    blocks[row].push_back(&shared.variables[column]);
    entries[row].push_back(entry);
  };
  for (std::size_t j = 0; j < n; ++j) {
    const auto end = static_cast<std::size_t>(pattern.column_start[j + 1]);
    for (auto k = static_cast<std::size_t>(pattern.column_start[j]); k < end; ++k) {
      const auto i = static_cast<std::size_t>(pattern.row[k]);
      add(i, j, k);
      if (i != j) add(j, i, k);
    }
  }
  for (std::size_t e = 0; e < n; ++e) {
    least_squares.AddResidualBlock(new Residual(shared, e, std::move(entries[e])), nullptr,
                                   blocks[e]);
  }
}

ceres::Solver::Options solver_options(std::size_t n, int max_iterations) {
  ceres::Solver::Options options;
  options.max_num_iterations = max_iterations;
  options.max_solver_time_in_seconds = 1e18;  // the limit is kept by Shared
  options.num_threads = 1;
  options.function_tolerance = options.parameter_tolerance = options.gradient_tolerance = 0;
  options.logging_type = ceres::SILENT;
  options.update_state_every_iteration = true;
  options.linear_solver_type = n <= kDense ? ceres::DENSE_QR : ceres::SPARSE_NORMAL_CHOLESKY;
  options.sparse_linear_algebra_library_type = ceres::SUITE_SPARSE;
  return options;
}

}  // namespace

Summary ceres_lm(const Problem& problem, std::span<double> x, const Options& options) {
  silence_ceres();
  Run run(problem, x, options, kMaxIterations);
  std::vector<double> variables(x.begin(), x.end());
  Shared shared(run, variables);
  shared.prepare(true);
  if (shared.exception) std::rethrow_exception(shared.exception);
  if (!shared.valid) {
    return run.finish(Termination::kNumericalFailure, kInfinity,
                      "the gradient is not defined at the start");
  }
  if (shared.accept()) {
    ceres::Problem::Options problem_options;
    problem_options.evaluation_callback = &shared;
    ceres::Problem least_squares(problem_options);
    add_residuals(least_squares, shared, problem.hessian_pattern());
    ceres::Solver::Options solver = solver_options(x.size(), 10 * run.max_iterations());
    Callback callback(run, shared);
    solver.callbacks.push_back(&callback);
    ceres::Solver::Summary summary;
    ceres::Solve(solver, &least_squares, &summary);
  }
  if (shared.exception) std::rethrow_exception(shared.exception);
  std::copy(shared.best_x.begin(), shared.best_x.end(), x.begin());
  if (shared.best <= run.tolerance()) return finish_converged(run, x, shared.best);
  if (shared.stopped) return run.finish(run.termination, shared.best);
  return run.finish(Termination::kStalled, shared.best, "no step reduces |gradient|");
}

}  // namespace tripus::solver::detail
