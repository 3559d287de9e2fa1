// Minimises f(x) = e^x - 2x, whose minimiser is log 2, by Newton's method and along its gradient
// flow.
#include <cmath>
#include <cstdio>

#include "integrators/integrate.hpp"
#include "solver/dense_problem.hpp"
#include "solver/method.hpp"

namespace {

class Example : public tripus::solver::DenseProblem {
 public:
  Example() : DenseProblem(1) {}

 private:
  std::optional<double> value(std::span<const double> x,
                              std::span<double> gradient) const override {
    gradient[0] = std::exp(x[0]) - 2;
    return std::exp(x[0]) - 2 * x[0];
  }
  void hessian(std::span<const double> x, std::span<double> H) const override {
    H[0] = std::exp(x[0]);
  }
};

bool report(const char* how, const tripus::solver::Summary& s, double x) {
  std::printf("%s: %s, x = %.16g, %d iterations\n", how, to_string(s.termination).data(), x,
              s.iterations);
  return s.termination == tripus::solver::Termination::kConverged &&
         std::abs(x - std::log(2)) < 1e-12;
}

}  // namespace

int main() {
  Example problem;
  const tripus::solver::Method* newton = tripus::solver::find_method("newton");
  double x = 0;
  tripus::solver::Summary summary = newton->minimise(problem, {&x, 1}, {});
  const bool minimised = report("newton", summary, x);

  const auto flow = tripus::integrators::parse_flow_method("flow:curvature/dopri5");
  x = 0;
  summary = tripus::integrators::integrate(problem, *flow->first, *flow->second, {&x, 1}, {});
  return minimised && report("flow", summary, x) ? 0 : 1;
}
