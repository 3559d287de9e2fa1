#include "solver/newton_direction.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "solver/detail/conjugate_gradients.hpp"
#include "solver/detail/direct_systems.hpp"
#include "solver/detail/regularised.hpp"
#include "solver/run.hpp"

namespace tripus::solver {

struct NewtonDirection::Implementation {
  explicit Implementation(const Problem& of)
      : system(detail::make_direct_system(of)), regularised(*system, of.dimension()) {}
  std::unique_ptr<detail::NewtonSystem> system;
  detail::RegularisedSystem regularised;
};

NewtonDirection::NewtonDirection(const Problem& problem)
    : implementation_(std::make_unique<Implementation>(problem)) {}

NewtonDirection::~NewtonDirection() = default;

void NewtonDirection::compute(std::span<const double> x, const Evaluation& at,
                              std::span<double> d) {
  const std::span<const double> g = at.gradient();
  const double max_gradient = max_abs(g);
  if (max_gradient == 0) {
    std::fill(d.begin(), d.end(), 0.0);
    return;
  }
  Implementation& i = *implementation_;
  i.regularised.adapt(true, 1);
  const double longest = detail::kStepGrowth * (1 + max_abs(x));
  i.regularised.compute(at, g, max_gradient, longest, 1, d);
}

double newton_distance(const Evaluation& at, std::span<const double> g, double least_curvature) {
  constexpr double kDigits = 1e-3;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  detail::ConjugateGradients system(g.size(), 1);
  const std::span<const double> diagonal = system.load(at);
  std::vector<double> shift(g.size()), d(g.size());
  for (std::size_t i = 0; i < g.size(); ++i) {
    shift[i] = least_curvature;
    if (diagonal[i] > 0 || least_curvature > 0) continue;
    if (g[i] != 0) return kInfinity;
    shift[i] = 1;
  }
  if (max_abs(g) == 0) return 0;
  return system.solve(at, shift, g, kDigits, d) ? max_abs(d) : kInfinity;
}

}  // namespace tripus::solver
