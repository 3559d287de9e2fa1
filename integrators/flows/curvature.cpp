#include "integrators/flow.hpp"

// dx/dt = -g. Gradient descent in continuous time: g(x) is dissipative, d|g|^2/dt = -2 g.Hg <= 0.

namespace tripus::integrators::registered_flows {
namespace {

class Curvature final : public Field {
 public:
  explicit Curvature(solver::Problem& problem) : problem_(problem) {}

  bool evaluate(solver::Run& run, std::span<const double> x, std::span<double> velocity,
                std::span<double> gradient, double& max_gradient) override {
    if (!run.evaluate(x, gradient, {}, max_gradient)) return false;
    for (std::size_t i = 0; i < x.size(); ++i) velocity[i] = -gradient[i];
    return true;
  }

  void jacobian_times(std::span<const double>, std::span<const double>, std::span<const double> v,
                      std::span<double> Jv) override {
    problem_.hessian_times(v, Jv);
  }

 private:
  solver::Problem& problem_;
};

std::unique_ptr<Field> make(solver::Problem& problem) {
  return std::make_unique<Curvature>(problem);
}

}  // namespace

std::span<const Flow> curvature() {
  static constexpr Flow kRows[] = {{"curvature", "dx/dt = -g: gradient flow", make, 0}};
  return kRows;
}

}  // namespace tripus::integrators::registered_flows
