#include "structure/starting_lengths.hpp"

#include <cmath>
#include <numbers>
#include <numeric>
#include <string>

#include <fmt/format.h>

#include "base/error.hpp"

namespace tripus::structure {
namespace {

void require_length(double length, const std::string& name) {
  if (!std::isfinite(length) || length <= 0) {
    throw InvalidInput(
        fmt::format("{} is {}; lengths are finite and greater than 0", name, length));
  }
}

/// The uniform length whose regular tetrahedra have the mean dihedral angle that the cone angles
/// ask for; 1 where that angle is out of reach.
double default_length(const topology::Triangulation& triangulation, const SolveOptions& options) {
  const auto edges = static_cast<double>(triangulation.edge_count());
  const double total =
      options.cone_angles.empty()
          ? 2 * std::numbers::pi * edges
          : std::accumulate(options.cone_angles.begin(), options.cone_angles.end(), 0.0);
  const double theta = total / static_cast<double>(6 * triangulation.tetrahedron_count());
  const bool reachable = theta > 0 && 2 * std::cos(theta) - 1 > 1e-3;
  return reachable ? regular_edge_length(theta) : 1.0;
}

}  // namespace

double regular_edge_length(double theta) {
  return std::acosh(std::cos(theta) / (2 * std::cos(theta) - 1));
}

std::vector<double> starting_lengths(const topology::Triangulation& triangulation,
                                     const SolveOptions& options) {
  const std::size_t edges = triangulation.edge_count();
  if (options.initial_lengths.empty()) {
    if (options.initial_length == 0)
      return std::vector<double>(edges, default_length(triangulation, options));
    require_length(options.initial_length, "the initial length");
    return std::vector<double>(edges, options.initial_length);
  }
  if (options.initial_lengths.size() != edges) {
    throw InvalidInput("there are " + std::to_string(options.initial_lengths.size()) +
                       " initial lengths for " + std::to_string(edges) +
                       " edge classes; give one for each, in the order of `tripus info`");
  }
  for (std::size_t e = 0; e < edges; ++e)
    require_length(options.initial_lengths[e], "initial length " + std::to_string(e));
  return options.initial_lengths;
}

}  // namespace tripus::structure
