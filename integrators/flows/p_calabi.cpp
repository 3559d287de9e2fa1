#include <algorithm>
#include <cmath>
#include <vector>

#include "integrators/flow.hpp"

// dx/dt = -H W g with W = diag((|g_i| / |g|)^(p-2)): the p-Calabi flow -H |g|^(p-2) g, component by
// component, which is the gradient flow of sum |g_i|^p / p, in a time that makes it homogeneous: by
// itself it needs infinitely long near the zero for p > 2 and chatters there for p < 2. Its
// trajectories are the same. For p < 2 the weights of small components are bounded.

namespace tripus::integrators::registered_flows {
namespace {

using solver::Evaluation;
using solver::Order;

/// |g_i| / |g| below this counts as this, smoothly, where the exponent p - 2 is negative.
constexpr double kSmallestShare = 0.01;

class PCalabi final : public Field {
 public:
  PCalabi(const solver::Problem& problem, double p)
      : p_(p), weights_(problem.dimension()), product_(problem.dimension()) {}

  bool evaluate(solver::Run& run, std::span<const double> x, std::span<double> velocity,
                std::span<double> gradient, double& max_gradient) override {
    if (!run.evaluate(x, Order::kSecond, at_, gradient, max_gradient)) return false;
    set_weights(gradient, max_gradient, weights_);
    for (std::size_t i = 0; i < x.size(); ++i) product_[i] = weights_[i] * gradient[i];
    at_->hessian_times(product_, velocity);
    for (double& v : velocity) v = -v;
    return true;
  }

  Jacobian jacobian(std::span<const double>, const Evaluation& at) const override {
    const std::span<const double> g = at.gradient();
    std::vector<double> weights(g.size());
    set_weights(g, solver::max_abs(g), weights);
    return [&at, weights = std::move(weights), factor = std::max(1.0, p_ - 1),
            product = std::vector<double>(g.size())](std::span<const double> v,
                                                     std::span<double> Jv) mutable {
      at.hessian_times(v, product);
      for (std::size_t i = 0; i < v.size(); ++i) product[i] *= factor * weights[i];
      at.hessian_times(product, Jv);
    };
  }

  /// sum |g_i|^p falls, and not |g|.
  bool contractive() const override { return false; }

 private:
  void set_weights(std::span<const double> g, double largest, std::span<double> weights) const {
    if (!(largest > 0)) {
      std::fill(weights.begin(), weights.end(), 1.0);
      return;
    }
    double square = 0;  // of |g| / largest, which neither overflows nor vanishes
    for (const double value : g) square += value / largest * (value / largest);
    const double floor = p_ < 2 ? kSmallestShare * kSmallestShare : 0;
    for (std::size_t i = 0; i < g.size(); ++i) {
      const double share = g[i] / largest * (g[i] / largest) / square;
      weights[i] = std::pow(share + floor, (p_ - 2) / 2);
    }
  }

  std::unique_ptr<Evaluation> at_;
  double p_;
  std::vector<double> weights_, product_;
};

template <int kTwiceP>
std::unique_ptr<Field> make(const solver::Problem& problem) {
  return std::make_unique<PCalabi>(problem, kTwiceP / 2.0);
}

}  // namespace

std::span<const Flow> p_calabi() {
  static constexpr Flow kRows[] = {
      {"calabi-1.5", "p-Calabi dx/dt = -H |g|^(p-2) g, p = 1.5, in homogeneous time", make<3>, 4},
      {"calabi-3", "the same with p = 3", make<6>, 5},
      {"calabi-4", "the same with p = 4", make<8>, 6}};
  return kRows;
}

}  // namespace tripus::integrators::registered_flows
