#include <boost/numeric/odeint/stepper/euler.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

#include "integrators/stepper.hpp"

// Boost.odeint's explicit Runge-Kutta steps on plain vectors. Its controlled steppers are not used:
// they hold the error to a fixed tolerance, and so hover about the fixed point at that distance.

namespace tripus::integrators::registered_steppers {
namespace {

namespace runge_kutta = boost::numeric::odeint;

/// A method without an error estimate.
template <class Odeint>
class Plain final : public StepMethod {
 public:
  explicit Plain(std::size_t) {}
  void step(const Rhs& rhs, const State& x, const State& velocity, double dt, State& new_x,
            State& new_velocity, State&) override {
    const auto system = [&rhs](const State& at, State& v, double) { rhs(at, v); };
    method_.do_step(system, x, velocity, 0.0, new_x, dt);
    rhs(new_x, new_velocity);
  }

 private:
  Odeint method_;
};

/// Dormand and Prince's 5(4): its seventh stage is the velocity at the new point.
class Dopri5 final : public StepMethod {
 public:
  explicit Dopri5(std::size_t) {}
  void step(const Rhs& rhs, const State& x, const State& velocity, double dt, State& new_x,
            State& new_velocity, State& error) override {
    const auto system = [&rhs](const State& at, State& v, double) { rhs(at, v); };
    method_.do_step(system, x, velocity, 0.0, new_x, new_velocity, dt, error);
  }

 private:
  runge_kutta::runge_kutta_dopri5<State> method_;
};

template <class Method>
std::unique_ptr<StepMethod> make(std::size_t n) {
  return std::make_unique<Method>(n);
}

}  // namespace

std::span<const Stepper> odeint() {
  // Stability limits: the real ends of the stability regions, |1 + z| = 1, |sum_0^4 z^k / k!| = 1,
  // and that of Dormand-Prince's fifth-order formula; rounded down.
  static constexpr Stepper kRows[] = {
      {"euler", "explicit Euler, order 1", 1, false, 2.0, make<Plain<runge_kutta::euler<State>>>,
       0},
      {"rk4", "classical Runge-Kutta, order 4", 4, false, 2.785,
       make<Plain<runge_kutta::runge_kutta4<State>>>, 1},
      {"dopri5", "Dormand-Prince 5(4), order 5, steps chosen by the error estimate", 5, true, 3.3,
       make<Dopri5>, 2},
  };
  return kRows;
}

}  // namespace tripus::integrators::registered_steppers
