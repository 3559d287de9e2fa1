#include <algorithm>
#include <vector>

#include "integrators/flow.hpp"
#include "integrators/limited_velocity.hpp"

// dx/dt = -D^-1 g with D = diag(H): the curvature flow in units in which every direction is equally
// steep. By docs/theory.md (40) the condition of D^-1 H does not grow with the triangulation.

namespace tripus::integrators::registered_flows {
namespace {

using solver::Evaluation;
using solver::Order;

/// An entry of D below this part of the largest, as beside flat tetrahedra, counts as this.
constexpr double kSmallestEntry = 1e-3;

class Diagonal final : public Field {
 public:
  explicit Diagonal(const solver::Problem& problem) : diagonal_(problem.dimension()) {}

  bool evaluate(solver::Run& run, std::span<const double> x, std::span<double> velocity,
                std::span<double> gradient, double& max_gradient) override {
    if (!run.evaluate(x, Order::kSecond, at_, gradient, max_gradient)) return false;
    read_diagonal(*at_, diagonal_);
    for (std::size_t i = 0; i < x.size(); ++i) velocity[i] = -gradient[i] / diagonal_[i];
    limit_velocity(x, velocity);
    return true;
  }

  Jacobian jacobian(std::span<const double>, const Evaluation& at) const override {
    std::vector<double> diagonal(at.gradient().size());
    read_diagonal(at, diagonal);
    return [&at, diagonal = std::move(diagonal)](std::span<const double> v, std::span<double> Jv) {
      at.hessian_times(v, Jv);
      for (std::size_t i = 0; i < v.size(); ++i) Jv[i] /= diagonal[i];
    };
  }

  /// f falls, and not |g|.
  bool contractive() const override { return false; }

 private:
  static void read_diagonal(const Evaluation& at, std::span<double> diagonal) {
    at.hessian_diagonal_blocks(1, diagonal);
    const double largest = *std::max_element(diagonal.begin(), diagonal.end());
    // Where all of H vanishes this is the curvature flow.
    for (double& d : diagonal) d = largest > 0 ? std::max(d, kSmallestEntry * largest) : 1;
  }

  std::unique_ptr<Evaluation> at_;
  std::vector<double> diagonal_;
};

std::unique_ptr<Field> make(const solver::Problem& problem) {
  return std::make_unique<Diagonal>(problem);
}

}  // namespace

std::span<const Flow> diagonal() {
  static constexpr Flow kRows[] = {
      {"diagonal", "dx/dt = -D^-1 g with D the diagonal of H", make, 9}};
  return kRows;
}

}  // namespace tripus::integrators::registered_flows
