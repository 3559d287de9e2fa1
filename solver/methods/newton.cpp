#include <limits>

#include "solver/detail/direct_systems.hpp"
#include "solver/detail/newton_loop.hpp"
#include "solver/method.hpp"

namespace tripus::solver::registered_methods {
namespace {

using namespace detail;

constexpr int kMaxIterations = 500;
constexpr double kUnknown = std::numeric_limits<double>::infinity();

Summary minimise(const Problem& problem, std::span<double> x, const Options& options) {
  Run run(problem, x, options, kMaxIterations);
  if (x.size() <= kDenseDimension) {
    DenseSystem system(problem);
    return newton_loop(run, system, x);
  }
  const char* too_large = "the Cholesky factor does not fit into memory; use newton-cg";
  if (problem.hessian_pattern().row.size() >= SparseSystem::kMaxEntries) {
    return run.finish(Termination::kNumericalFailure, kUnknown, too_large);
  }
  SparseSystem system(problem);
  if (system.out_of_memory()) {
    return run.finish(Termination::kNumericalFailure, kUnknown, too_large);
  }
  return newton_loop(run, system, x);
}

}  // namespace

std::span<const Method> newton() {
  static constexpr Method kRows[] = {
      {"newton", "Newton's method, dense or sparse (CHOLMOD) Cholesky factorisation", true,
       minimise, 0}};
  return kRows;
}

}  // namespace tripus::solver::registered_methods
