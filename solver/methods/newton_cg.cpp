#include "solver/detail/conjugate_gradients.hpp"
#include "solver/detail/newton_loop.hpp"
#include "solver/method.hpp"

namespace tripus::solver::registered_methods {
namespace {

constexpr int kMaxIterations = 500;
constexpr std::size_t kBlock = 8;

template <std::size_t BlockSize>
Summary minimise(const Problem& problem, std::span<double> x, const Options& options) {
  Run run(problem, x, options, kMaxIterations);
  detail::ConjugateGradients system(problem.dimension(), BlockSize);
  return detail::newton_loop(run, system, x);
}

}  // namespace

std::span<const Method> newton_cg() {
  static constexpr Method kRows[] = {
      {"newton-cg", "Newton's method, matrix-free conjugate gradients, Jacobi preconditioner", true,
       minimise<1>, 1},
      {"newton-cg-block", "the same with a block-Jacobi preconditioner, 8 variables a block", true,
       minimise<kBlock>, 2},
  };
  return kRows;
}

}  // namespace tripus::solver::registered_methods
