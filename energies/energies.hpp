#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "solver/problem.hpp"
#include "topology/triangulation.hpp"

namespace tripus::energies {

/// One line of the table of energies.
struct Energy {
  std::string_view name;
  std::string_view description;  ///< one line for `tripus methods`
  std::string_view variables;    ///< what x is

  /// The functional on a triangulation that has the given lengths [E], and the point x in its own
  /// variables that they correspond to (appended to `x`). The lengths must make every tetrahedron
  /// a true one. The contract tests sample every energy through this.
  std::unique_ptr<solver::Problem> (*at_lengths)(const topology::Triangulation& triangulation,
                                                 std::span<const double> lengths,
                                                 std::vector<double>& x);
};

/// Every energy, in the order in which `tripus methods` prints them.
std::span<const Energy> energies();

}  // namespace tripus::energies
