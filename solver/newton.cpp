#include "base/error.hpp"
#include "solver/detail/direct_systems.hpp"
#include "solver/detail/methods.hpp"

namespace tripus::solver::detail {
namespace {

constexpr int kMaxIterations = 500;

/// Up to here a dense factorisation beats the bookkeeping of a sparse one.
constexpr std::size_t kDense = 64;

}  // namespace

Summary newton(Problem& problem, std::span<double> x, const Options& options) {
  Run run(problem, x, options, kMaxIterations);
  if (x.size() <= kDense) {
    DenseSystem system(problem);
    return newton_loop(run, system, x);
  }
  SparseSystem system(problem);
  Summary summary = newton_loop(run, system, x);
  if (system.out_of_memory() && summary.termination != Termination::kConverged) {
    summary.termination = Termination::kNumericalFailure;
    summary.message = "the Cholesky factor does not fit into memory; use newton-cg";
  }
  return summary;
}

}  // namespace tripus::solver::detail
