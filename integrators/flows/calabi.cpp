#include <vector>

#include "integrators/flow.hpp"

// dx/dt = -H g = -grad |g|^2 / 2. Fourth order where the curvature flow is of second order, and as
// stiff as that squared; it stands still where H vanishes.

namespace tripus::integrators::registered_flows {
namespace {

using solver::Evaluation;
using solver::Order;

class Calabi final : public Field {
 public:
  bool evaluate(solver::Run& run, std::span<const double> x, std::span<double> velocity,
                std::span<double> gradient, double& max_gradient) override {
    if (!run.evaluate(x, Order::kSecond, at_, gradient, max_gradient)) return false;
    at_->hessian_times(gradient, velocity);
    for (double& v : velocity) v = -v;
    return true;
  }

  Jacobian jacobian(std::span<const double>, const Evaluation& at) const override {
    return [&at, product = std::vector<double>(at.gradient().size())](
               std::span<const double> v, std::span<double> Jv) mutable {
      at.hessian_times(v, product);
      at.hessian_times(product, Jv);
    };
  }

 private:
  std::unique_ptr<Evaluation> at_;
};

std::unique_ptr<Field> make(const solver::Problem&) { return std::make_unique<Calabi>(); }

}  // namespace

std::span<const Flow> calabi() {
  static constexpr Flow kRows[] = {{"calabi", "dx/dt = -H g: gradient flow of |g|^2 / 2", make, 3}};
  return kRows;
}

}  // namespace tripus::integrators::registered_flows
