#include <algorithm>
#include <cmath>
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

constexpr std::size_t kMostUnknowns = 500;

/// Eigenvalues below this part of the largest count as 0, and nothing moves along them: rounding,
/// and the directions in which horospheres move. For s < 0 those below kSmallEigenvalue of the
/// largest count as that; where all of H vanishes the flow is the curvature flow.
constexpr double kNullEigenvalue = 1e-12, kSmallEigenvalue = 1e-6;

class Fractional final : public Field {
 public:
  Fractional(solver::Problem& problem, double power) : problem_(problem), power_(power) {
    if (problem.dimension() > kMostUnknowns)
      throw Unsupported(
          "a fractional flow takes all eigenvectors of the Hessian and is for up to " +
          std::to_string(kMostUnknowns) + " unknowns; here are " +
          std::to_string(problem.dimension()) + ": use the flow curvature, calabi or newton-flow");
  }

  bool evaluate(solver::Run& run, std::span<const double> x, std::span<double> velocity,
                std::span<double> gradient, double& max_gradient) override {
    if (!run.evaluate(x, gradient, {.value = nullptr, .second_derivatives = true}, max_gradient)) {
      return false;
    }
    const auto n = static_cast<Eigen::Index>(x.size());
    Eigen::MatrixXd H(n, n);
    std::vector<double> unit(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
      unit[i] = 1;
      problem_.hessian_times(unit, {H.col(static_cast<Eigen::Index>(i)).data(), x.size()});
      unit[i] = 0;
    }
    if (!H.allFinite()) return false;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver((H + H.transpose()) / 2);
    if (solver.info() != Eigen::Success) return false;
    vectors_ = solver.eigenvectors();
    powers_ = solver.eigenvalues();
    const double largest = powers_.cwiseAbs().maxCoeff();
    for (double& value : powers_) value = powered(value, largest);
    apply(gradient, velocity);
    for (double& v : velocity) v = -v;
    if (power_ < 0) limit_velocity(x, velocity);
    return true;
  }

  void jacobian_times(std::span<const double>, std::span<const double>, std::span<const double> v,
                      std::span<double> Jv) override {
    std::vector<double> product(v.size());
    problem_.hessian_times(v, product);
    apply(product, Jv);
  }

 private:
  /// An eigenvalue to the power s.
  double powered(double value, double largest) const {
    if (power_ > 0) return value > kNullEigenvalue * largest ? std::pow(value, power_) : 0;
    return largest > 0 ? std::pow(std::max(value, kSmallEigenvalue * largest), power_) : 1;
  }

  /// H^s of the latest evaluation, times v.
  void apply(std::span<const double> v, std::span<double> out) const {
    const auto n = static_cast<Eigen::Index>(v.size());
    const Eigen::Map<const Eigen::VectorXd> in(v.data(), n);
    Eigen::Map<Eigen::VectorXd>(out.data(), n) =
        vectors_ * powers_.cwiseProduct(vectors_.transpose() * in);
  }

  solver::Problem& problem_;
  double power_;
  Eigen::MatrixXd vectors_;
  Eigen::VectorXd powers_;
};

template <int kTwiceS>
std::unique_ptr<Field> make(solver::Problem& problem) {
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
