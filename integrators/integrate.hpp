#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "integrators/flow.hpp"
#include "integrators/stepper.hpp"
#include "solver/method.hpp"

namespace tripus::integrators {

struct FlowOptions {
  /// Length of a step in flow time, >= 0; 0: chosen by the stability limit or the error estimate. A
  /// length that is given is kept, except for steps that would leave the domain.
  double step = 0;
  /// Adaptive steppers: largest local error of a step, in units of the distance it covers, > 0.
  double relative_error = 1e-3;
};

/// Throws InvalidInput, naming the option and its value.
void validate(const FlowOptions& options);

/// Follows the flow from x [n], in place, until max|g| <= tolerance. Mathematical outcomes are
/// returned, never thrown; Summary::iterations counts accepted steps, Iterate::time is the flow
/// time. Throws InvalidInput for bad options or a length of x other than n.
solver::Summary integrate(const solver::Problem& problem, const Flow& flow, const Stepper& stepper,
                          std::span<double> x, const solver::Options& options,
                          const FlowOptions& flow_options = {});

/// "flow:NAME/STEPPER" or "flow:NAME" (dopri5). Nothing if the prefix or a name is unknown.
std::optional<std::pair<const Flow*, const Stepper*>> parse_flow_method(std::string_view text);

}  // namespace tripus::integrators
