#include <algorithm>
#include <vector>

#include "integrators/flow.hpp"
#include "integrators/limited_velocity.hpp"

// dx/dt = -D^-1 g with D = diag(H): the curvature flow in units in which every direction is equally
// steep. By docs/theory.md (40) the condition of D^-1 H does not grow with the triangulation.

namespace tripus::integrators::registered_flows {
namespace {

/// An entry of D below this part of the largest, as beside flat tetrahedra, counts as this.
constexpr double kSmallestEntry = 1e-3;

class Diagonal final : public Field {
 public:
  explicit Diagonal(solver::Problem& problem) : problem_(problem), diagonal_(problem.dimension()) {}

  bool evaluate(solver::Run& run, std::span<const double> x, std::span<double> velocity,
                std::span<double> gradient, double& max_gradient) override {
    if (!run.evaluate(x, gradient, {.value = nullptr, .second_derivatives = true}, max_gradient)) {
      return false;
    }
    set_diagonal();
    for (std::size_t i = 0; i < x.size(); ++i) velocity[i] = -gradient[i] / diagonal_[i];
    limit_velocity(x, velocity);
    return true;
  }

  void jacobian_times(std::span<const double>, std::span<const double>, std::span<const double> v,
                      std::span<double> Jv) override {
    set_diagonal();
    problem_.hessian_times(v, Jv);
    for (std::size_t i = 0; i < v.size(); ++i) Jv[i] /= diagonal_[i];
  }

  /// f falls, and not |g|.
  bool contractive() const override { return false; }

 private:
  void set_diagonal() {
    problem_.hessian_diagonal_blocks(1, diagonal_);
    const double largest = *std::max_element(diagonal_.begin(), diagonal_.end());
    // Where all of H vanishes this is the curvature flow.
    for (double& d : diagonal_) d = largest > 0 ? std::max(d, kSmallestEntry * largest) : 1;
  }

  solver::Problem& problem_;
  std::vector<double> diagonal_;
};

std::unique_ptr<Field> make(solver::Problem& problem) {
  return std::make_unique<Diagonal>(problem);
}

}  // namespace

std::span<const Flow> diagonal() {
  static constexpr Flow kRows[] = {
      {"diagonal", "dx/dt = -D^-1 g with D the diagonal of H", make, 9}};
  return kRows;
}

}  // namespace tripus::integrators::registered_flows
