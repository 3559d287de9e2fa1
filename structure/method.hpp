#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "energies/energies.hpp"
#include "integrators/flow.hpp"
#include "integrators/stepper.hpp"
#include "solver/method.hpp"

namespace tripus::structure {

/// A way to solve, as named after --method:
///     newton, ceres-lbfgs, ...       minimise the co-volume in lengths
///     angles:ceres-lbfgs, ...        maximise the volume in angles, and so on for each energy
///     flow:curvature/dopri5, ...     integrate a flow of the lengths
struct SolveMethod {
  std::string name;
  const energies::Energy* energy = nullptr;       ///< what is minimised, or whose gradient flows
  const solver::Method* minimiser = nullptr;      ///< or else
  const integrators::Flow* flow = nullptr;        ///< a flow, with
  const integrators::Stepper* stepper = nullptr;  ///< its steps
};

/// Parses a name; "auto" chooses by the number of edge classes.
/// Throws InvalidInput with the list of what there is.
SolveMethod find_solve_method(std::string_view name, std::size_t edge_count);

/// Runs the method, a flow or a minimiser, on a functional from x [n], in place.
solver::Summary run(const SolveMethod& method, energies::Functional& functional,
                    std::span<double> x, const solver::Options& options);

/// Every name that find_solve_method takes.
std::vector<std::string> solve_method_names();

}  // namespace tripus::structure
