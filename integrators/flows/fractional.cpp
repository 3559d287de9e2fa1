#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include "base/error.hpp"
#include "integrators/flow.hpp"
#include "integrators/limited_velocity.hpp"

// dx/dt = -H^s g: the curvature flow for s = 0, the Calabi flow for s = 1, Newton's for s = -1, and
// what lies between. g decays like e^(-t l^(1+s)) for an eigenvalue l of H. It takes all
// eigenvectors of H at every point.

namespace tripus::integrators::registered_flows {
namespace {

using solver::Evaluation;
using solver::Order;

constexpr std::size_t kMostUnknowns = 500;

/// Eigenvalues below this part of the largest count as 0, and nothing moves along them: rounding,
/// and the directions in which horospheres move. For s < 0 those below kSmallEigenvalue of the
/// largest count as that; where all of H vanishes the flow is the curvature flow.
constexpr double kNullEigenvalue = 1e-12, kSmallEigenvalue = 1e-6;

class Fractional final : public Field {
 public:
  Fractional(const solver::Problem& problem, double power) : power_(power) {
    if (problem.dimension() > kMostUnknowns)
      throw Unsupported(
          "a fractional flow takes all eigenvectors of the Hessian and is for up to " +
          std::to_string(kMostUnknowns) + " unknowns; here are " +
          std::to_string(problem.dimension()) + ": use the flow curvature, calabi or newton-flow");
  }

  bool evaluate(solver::Run& run, std::span<const double> x, std::span<double> velocity,
                std::span<double> gradient, double& max_gradient) override {
    if (!run.evaluate(x, Order::kSecond, at_, gradient, max_gradient)) return false;
    const std::optional<Power> power = power_of(*at_);
    if (!power) return false;
    power->apply(gradient, velocity);
    for (double& v : velocity) v = -v;
    if (power_ < 0) limit_velocity(x, velocity);
    return true;
  }

  Jacobian jacobian(std::span<const double>, const Evaluation& at) const override {
    return [&at, power = power_of(at), product = std::vector<double>(at.gradient().size())](
               std::span<const double> v, std::span<double> Jv) mutable {
      at.hessian_times(v, product);
      if (power)
        power->apply(product, Jv);
      else
        std::ranges::fill(Jv, 0.0);
    };
  }

 private:
  /// H^s.
  struct Power {
    Eigen::MatrixXd vectors;
    Eigen::VectorXd powers;

    void apply(std::span<const double> v, std::span<double> out) const {
      const auto n = static_cast<Eigen::Index>(v.size());
      const Eigen::Map<const Eigen::VectorXd> in(v.data(), n);
      Eigen::Map<Eigen::VectorXd>(out.data(), n) =
          vectors * powers.cwiseProduct(vectors.transpose() * in);
    }
  };

  /// Nothing where H is not finite.
  std::optional<Power> power_of(const Evaluation& at) const {
    const std::size_t size = at.gradient().size();
    const auto n = static_cast<Eigen::Index>(size);
    Eigen::MatrixXd H(n, n);
    std::vector<double> unit(size);
    for (std::size_t i = 0; i < size; ++i) {
      unit[i] = 1;
      at.hessian_times(unit, {H.col(static_cast<Eigen::Index>(i)).data(), size});
      unit[i] = 0;
    }
    if (!H.allFinite()) return std::nullopt;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver((H + H.transpose()) / 2);
    if (solver.info() != Eigen::Success) return std::nullopt;
    Power result{solver.eigenvectors(), solver.eigenvalues()};
    const double largest = result.powers.cwiseAbs().maxCoeff();
    for (double& value : result.powers) value = powered(value, largest);
    return result;
  }

  /// An eigenvalue to the power s.
  double powered(double value, double largest) const {
    if (power_ > 0) return value > kNullEigenvalue * largest ? std::pow(value, power_) : 0;
    return largest > 0 ? std::pow(std::max(value, kSmallEigenvalue * largest), power_) : 1;
  }

  double power_;
  std::unique_ptr<Evaluation> at_;
};

template <int kTwiceS>
std::unique_ptr<Field> make(const solver::Problem& problem) {
  return std::make_unique<Fractional>(problem, kTwiceS / 2.0);
}

}  // namespace

std::span<const Flow> fractional() {
  static constexpr Flow kRows[] = {
      {"fractional-0.5", "dx/dt = -H^(1/2) g, for up to 500 unknowns", make<1>, 7},
      {"fractional-minus-0.5", "dx/dt = -H^(-1/2) g, for up to 500 unknowns", make<-1>, 8}};
  return kRows;
}

}  // namespace tripus::integrators::registered_flows
