// Minimises f(x) = e^x - 2x, whose minimiser is log 2, by Newton's method and along its gradient
// flow.
#include <cmath>
#include <cstdio>

#include "integrators/integrate.hpp"
#include "solver/method.hpp"

namespace {

class Example : public tripus::solver::Problem {
 public:
  std::size_t dimension() const override { return 1; }
  bool evaluate(std::span<const double> x, std::span<double> gradient,
                const Request& request) override {
    hessian_ = std::exp(x[0]);
    gradient[0] = hessian_ - 2;
    if (request.value != nullptr) *request.value = hessian_ - 2 * x[0];
    return true;
  }
  const tripus::solver::SparsityPattern& hessian_pattern() override { return pattern_; }
  void hessian_values(std::span<double> values) const override { values[0] = hessian_; }
  void hessian_times(std::span<const double> v, std::span<double> Hv) const override {
    Hv[0] = hessian_ * v[0];
  }
  void hessian_diagonal_blocks(std::size_t block_size, std::span<double> blocks) const override {
    for (double& entry : blocks.first(block_size * block_size)) entry = 0;
    blocks[0] = hessian_;
  }

 private:
  tripus::solver::SparsityPattern pattern_{{0, 1}, {0}};
  double hessian_ = 1;
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
