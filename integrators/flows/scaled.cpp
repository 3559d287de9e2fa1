#include "integrators/flow.hpp"

// dx_i/dt = -g_i x_i on x > 0: the curvature flow in the metric sum dx_i^2 / x_i. It keeps x
// positive; f decreases along it, |g| need not.

namespace tripus::integrators::registered_flows {
namespace {

using solver::Evaluation;
using solver::Order;

class Scaled final : public Field {
 public:
  bool evaluate(solver::Run& run, std::span<const double> x, std::span<double> velocity,
                std::span<double> gradient, double& max_gradient) override {
    for (const double value : x) {
      if (!(value > 0)) return false;
    }
    if (!run.evaluate(x, Order::kFirst, at_, gradient, max_gradient)) return false;
    for (std::size_t i = 0; i < x.size(); ++i) velocity[i] = -gradient[i] * x[i];
    return true;
  }

  Jacobian jacobian(std::span<const double> x, const Evaluation& at) const override {
    return [x, &at](std::span<const double> v, std::span<double> Jv) {
      const std::span<const double> g = at.gradient();
      at.hessian_times(v, Jv);
      for (std::size_t i = 0; i < x.size(); ++i) Jv[i] = x[i] * Jv[i] + g[i] * v[i];
    };
  }

  bool contractive() const override { return false; }

 private:
  std::unique_ptr<Evaluation> at_;
};

std::unique_ptr<Field> make(const solver::Problem&) { return std::make_unique<Scaled>(); }

}  // namespace

std::span<const Flow> scaled() {
  static constexpr Flow kRows[] = {
      {"scaled", "dx/dt = -g x, component by component: keeps x positive", make, 1}};
  return kRows;
}

}  // namespace tripus::integrators::registered_flows
