#include <algorithm>

#include "integrators/flow.hpp"
#include "solver/newton_direction.hpp"

// dx/dt = -H^-1 g, regularised: dg/dt = -g, so g decays like e^-t whatever the condition of H.

namespace tripus::integrators::registered_flows {
namespace {

class NewtonFlow final : public Field {
 public:
  explicit NewtonFlow(solver::Problem& problem) : direction_(problem) {}

  bool evaluate(solver::Run& run, std::span<const double> x, std::span<double> velocity,
                std::span<double> gradient, double& max_gradient) override {
    if (!run.evaluate(x, gradient, {.value = nullptr, .second_derivatives = true}, max_gradient)) {
      return false;
    }
    direction_.compute(x, gradient, velocity);
    return true;
  }

  void jacobian_times(std::span<const double>, std::span<const double>, std::span<const double> v,
                      std::span<double> Jv) override {
    std::copy(v.begin(), v.end(), Jv.begin());
  }

  /// An Euler step of 1 is a step of Newton's method.
  double longest_step() const override { return 1; }

 private:
  solver::NewtonDirection direction_;
};

std::unique_ptr<Field> make(solver::Problem& problem) {
  return std::make_unique<NewtonFlow>(problem);
}

}  // namespace

std::span<const Flow> newton_flow() {
  static constexpr Flow kRows[] = {
      {"newton-flow", "dx/dt = -H^-1 g: the gradient decays like e^-t", make, 2}};
  return kRows;
}

}  // namespace tripus::integrators::registered_flows
