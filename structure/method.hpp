#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "integrators/flow.hpp"
#include "integrators/stepper.hpp"
#include "solver/method.hpp"

namespace tripus::structure {

/// A way to solve, as named after --method:
///     newton, ceres-lbfgs, ...       minimise the co-volume in lengths
///     angles:ceres-lbfgs, ...        maximise the volume in angles, from an interior angle
///     flow:curvature/dopri5, ...     integrate a flow of the lengths
struct SolveMethod {
  enum class Form { kLengths, kAngles, kFlow };
  std::string name;
  Form form = Form::kLengths;
  const solver::Method* minimiser = nullptr;      // lengths and angles
  const integrators::Flow* flow = nullptr;        // flow
  const integrators::Stepper* stepper = nullptr;  // flow
};

/// Parses a name; "auto" chooses by the number of edge classes.
/// Throws InvalidInput with the list of what there is.
SolveMethod find_solve_method(std::string_view name, std::size_t edge_count);

/// Every name that find_solve_method takes.
std::vector<std::string> solve_method_names();

}  // namespace tripus::structure
