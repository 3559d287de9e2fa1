#include "solver/newton_direction.hpp"

#include <algorithm>

#include "solver/detail/direct_systems.hpp"
#include "solver/detail/regularised.hpp"
#include "solver/run.hpp"

namespace tripus::solver {

struct NewtonDirection::Implementation {
  explicit Implementation(Problem& of)
      : problem(of), system(detail::make_direct_system(of)), regularised(*system, of.dimension()) {}
  Problem& problem;
  std::unique_ptr<detail::NewtonSystem> system;
  detail::RegularisedSystem regularised;
};

NewtonDirection::NewtonDirection(Problem& problem)
    : implementation_(std::make_unique<Implementation>(problem)) {}

NewtonDirection::~NewtonDirection() = default;

void NewtonDirection::compute(std::span<const double> x, std::span<const double> g,
                              std::span<double> d) {
  const double max_gradient = max_abs(g);
  if (max_gradient == 0) {
    std::fill(d.begin(), d.end(), 0.0);
    return;
  }
  Implementation& i = *implementation_;
  i.regularised.adapt(true, 1);
  const double longest = detail::kStepGrowth * (1 + max_abs(x));
  i.regularised.compute(i.problem, g, max_gradient, longest, 1, d);
}

}  // namespace tripus::solver
