#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "base/registry.hpp"

namespace tripus::integrators {

using State = std::vector<double>;

/// velocity = F(x).
using Rhs = std::function<void(const State& x, State& velocity)>;

/// One step of an explicit Runge-Kutta method, with its workspace.
class StepMethod {
 public:
  virtual ~StepMethod() = default;

  /// From x with velocity F(x), by dt, to new_x with new_velocity = F(new_x): the last call of rhs
  /// is at new_x. error: estimated local error of new_x, [n]; written by embedded methods only.
  virtual void step(const Rhs& rhs, const State& x, const State& velocity, double dt, State& new_x,
                    State& new_velocity, State& error) = 0;
};

/// One line of the table of steppers.
struct Stepper {
  std::string_view name;         ///< as typed after flow:NAME/
  std::string_view description;  ///< one line for `tripus methods`
  int order = 0;                 ///< of the global error in the step
  bool adaptive = false;         ///< estimates its error and chooses its steps by it
  double stability = 0;  ///< dx/dt = -a x is integrated stably for steps up to stability / a
  std::unique_ptr<StepMethod> (*make)(std::size_t n) = nullptr;
  int place = kAnyPlace;  ///< in lists, lowest first
};

/// Every stepper; their files are in integrators/steppers.
std::span<const Stepper> steppers();

/// The stepper of that name, or null.
inline const Stepper* find_stepper(std::string_view name) { return find_row(steppers(), name); }

}  // namespace tripus::integrators
