#include "solver/detail/conjugate_gradients.hpp"
#include "solver/detail/methods.hpp"

namespace tripus::solver::detail {
namespace {

constexpr int kMaxIterations = 500;
constexpr std::size_t kBlock = 8;

Summary minimise(Problem& problem, std::span<double> x, const Options& options,
                 std::size_t block_size) {
  Run run(problem, x, options, kMaxIterations);
  ConjugateGradients system(problem, block_size);
  return newton_loop(run, system, x);
}

}  // namespace

Summary newton_cg(Problem& problem, std::span<double> x, const Options& options) {
  return minimise(problem, x, options, 1);
}

Summary newton_cg_block(Problem& problem, std::span<double> x, const Options& options) {
  return minimise(problem, x, options, kBlock);
}

}  // namespace tripus::solver::detail
