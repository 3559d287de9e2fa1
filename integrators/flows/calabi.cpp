#include <vector>

#include "integrators/flow.hpp"

// dx/dt = -H g = -grad |g|^2 / 2. Fourth order where the curvature flow is of second order, and as
// stiff as that squared; it stands still where H vanishes.

namespace tripus::integrators::registered_flows {
namespace {

class Calabi final : public Field {
 public:
  explicit Calabi(solver::Problem& problem) : problem_(problem), product_(problem.dimension()) {}

  bool evaluate(solver::Run& run, std::span<const double> x, std::span<double> velocity,
                std::span<double> gradient, double& max_gradient) override {
    if (!run.evaluate(x, gradient, {.value = nullptr, .second_derivatives = true}, max_gradient)) {
      return false;
    }
    problem_.hessian_times(gradient, velocity);
    for (double& v : velocity) v = -v;
    return true;
  }

  void jacobian_times(std::span<const double>, std::span<const double>, std::span<const double> v,
                      std::span<double> Jv) override {
    problem_.hessian_times(v, product_);
    problem_.hessian_times(product_, Jv);
  }

 private:
  solver::Problem& problem_;
  std::vector<double> product_;
};

std::unique_ptr<Field> make(solver::Problem& problem) { return std::make_unique<Calabi>(problem); }

}  // namespace

std::span<const Flow> calabi() {
  static constexpr Flow kRows[] = {{"calabi", "dx/dt = -H g: gradient flow of |g|^2 / 2", make, 3}};
  return kRows;
}

}  // namespace tripus::integrators::registered_flows
