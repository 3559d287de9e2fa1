#include "integrators/flow.hpp"

// dx_i/dt = -g_i x_i on x > 0: the curvature flow in the metric sum dx_i^2 / x_i. It keeps x
// positive; f decreases along it, |g| need not.

namespace tripus::integrators::registered_flows {
namespace {

class Scaled final : public Field {
 public:
  explicit Scaled(solver::Problem& problem) : problem_(problem) {}

  bool evaluate(solver::Run& run, std::span<const double> x, std::span<double> velocity,
                std::span<double> gradient, double& max_gradient) override {
    for (const double value : x) {
      if (!(value > 0)) return false;
    }
    if (!run.evaluate(x, gradient, {}, max_gradient)) return false;
    for (std::size_t i = 0; i < x.size(); ++i) velocity[i] = -gradient[i] * x[i];
    return true;
  }

  void jacobian_times(std::span<const double> x, std::span<const double> g,
                      std::span<const double> v, std::span<double> Jv) override {
    problem_.hessian_times(v, Jv);
    for (std::size_t i = 0; i < x.size(); ++i) Jv[i] = x[i] * Jv[i] + g[i] * v[i];
  }

  bool contractive() const override { return false; }

 private:
  solver::Problem& problem_;
};

std::unique_ptr<Field> make(solver::Problem& problem) { return std::make_unique<Scaled>(problem); }

}  // namespace

std::span<const Flow> scaled() {
  static constexpr Flow kRows[] = {
      {"scaled", "dx/dt = -g x, component by component: keeps x positive", make, 1}};
  return kRows;
}

}  // namespace tripus::integrators::registered_flows
