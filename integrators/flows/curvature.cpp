#include "integrators/flow.hpp"

// dx/dt = -g. Gradient descent in continuous time: g(x) is dissipative, d|g|^2/dt = -2 g.Hg <= 0.

namespace tripus::integrators::registered_flows {
namespace {

using solver::Evaluation;
using solver::Order;

class Curvature final : public Field {
 public:
  bool evaluate(solver::Run& run, std::span<const double> x, std::span<double> velocity,
                std::span<double> gradient, double& max_gradient) override {
    if (!run.evaluate(x, Order::kFirst, at_, gradient, max_gradient)) return false;
    for (std::size_t i = 0; i < x.size(); ++i) velocity[i] = -gradient[i];
    return true;
  }

  Jacobian jacobian(std::span<const double>, const Evaluation& at) const override {
    return [&at](std::span<const double> v, std::span<double> Jv) { at.hessian_times(v, Jv); };
  }

 private:
  std::unique_ptr<Evaluation> at_;
};

std::unique_ptr<Field> make(const solver::Problem&) { return std::make_unique<Curvature>(); }

}  // namespace

std::span<const Flow> curvature() {
  static constexpr Flow kRows[] = {{"curvature", "dx/dt = -g: gradient flow", make, 0}};
  return kRows;
}

}  // namespace tripus::integrators::registered_flows
