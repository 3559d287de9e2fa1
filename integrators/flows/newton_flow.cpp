#include <algorithm>

#include "integrators/flow.hpp"
#include "solver/newton_direction.hpp"

// dx/dt = -H^-1 g, regularised: dg/dt = -g, so g decays like e^-t whatever the condition of H.

namespace tripus::integrators::registered_flows {
namespace {

using solver::Evaluation;
using solver::Order;

class NewtonFlow final : public Field {
 public:
  explicit NewtonFlow(const solver::Problem& problem) : direction_(problem) {}

  bool evaluate(solver::Run& run, std::span<const double> x, std::span<double> velocity,
                std::span<double> gradient, double& max_gradient) override {
    if (!run.evaluate(x, Order::kSecond, at_, gradient, max_gradient)) return false;
    direction_.compute(x, *at_, velocity);
    return true;
  }

  Jacobian jacobian(std::span<const double>, const Evaluation&) const override {
    return
        [](std::span<const double> v, std::span<double> Jv) { std::ranges::copy(v, Jv.begin()); };
  }

  /// An Euler step of 1 is a step of Newton's method.
  double longest_step() const override { return 1; }

 private:
  solver::NewtonDirection direction_;
  std::unique_ptr<Evaluation> at_;
};

std::unique_ptr<Field> make(const solver::Problem& problem) {
  return std::make_unique<NewtonFlow>(problem);
}

}  // namespace

std::span<const Flow> newton_flow() {
  static constexpr Flow kRows[] = {
      {"newton-flow", "dx/dt = -H^-1 g: the gradient decays like e^-t", make, 2}};
  return kRows;
}

}  // namespace tripus::integrators::registered_flows
