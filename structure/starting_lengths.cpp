#include "structure/starting_lengths.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>

#include "base/error.hpp"
#include "topology/vertex_kinds.hpp"

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
  double total = 2 * std::numbers::pi * edges;
  for (const topology::ConeAngle& k : options.cone_angles)
    total += k.radians() - 2 * std::numbers::pi;
  const double theta = total / static_cast<double>(6 * triangulation.tetrahedron_count());
  const bool reachable = theta > 0 && 2 * std::cos(theta) - 1 > 1e-3;
  return reachable ? regular_edge_length(theta) : 1.0;
}

/// The length of an edge with one or two ideal ends that goes with `length` between hyperideal
/// vertices: scaled to the same diagonal, all entries of the Gram matrix are then alike.
double at_cusps(double length, int ends) {
  return ends == 2 ? -std::numbers::ln2 : std::log(std::cosh(length)) / 2;
}

}  // namespace

double regular_edge_length(double theta) {
  return std::acosh(std::cos(theta) / (2 * std::cos(theta) - 1));
}

std::vector<double> starting_lengths(const topology::Triangulation& triangulation,
                                     const SolveOptions& options) {
  const std::size_t edges = triangulation.edge_count();
  const auto links = topology::orbifold_links(triangulation, options.cone_angles);
  const auto ideal_ends = [&](std::size_t e) {
    const auto corner = triangulation.corners(e)[0];
    int count = 0;
    for (const int end : topology::kEdgeEnds[static_cast<std::size_t>(corner.edge())])
      count += links[triangulation.vertex_class(corner.tetrahedron(), end)].kind ==
               topology::VertexKind::kIdeal;
    return count;
  };
  const auto is_parabolic = [&](std::size_t e) {
    return !options.cone_angles.empty() && options.cone_angles[e].is_parabolic();
  };
  if (options.initial_lengths.empty()) {
    if (options.initial_length != 0) require_length(options.initial_length, "the initial length");
    const double length = options.initial_length == 0 ? default_length(triangulation, options)
                                                      : options.initial_length;
    std::vector<double> lengths(edges, length);
    for (std::size_t e = 0; e < edges; ++e) {
      if (const int ends = ideal_ends(e); ends > 0) lengths[e] = at_cusps(length, ends);
      if (is_parabolic(e)) lengths[e] = 0;
    }
    return lengths;
  }
  if (options.initial_lengths.size() != edges) {
    throw InvalidInput("there are " + std::to_string(options.initial_lengths.size()) +
                       " initial lengths for " + std::to_string(edges) +
                       " edge classes; give one for each, in the order of `tripus info`");
  }
  for (std::size_t e = 0; e < edges; ++e) {
    const double length = options.initial_lengths[e];
    const std::string name = "initial length " + std::to_string(e);
    if (is_parabolic(e)) {
      if (length != 0)
        throw InvalidInput(
            fmt::format("{} is {}; the edge is parabolic, its length is 0", name, length));
    } else if (ideal_ends(e) > 0) {
      if (!std::isfinite(length))
        throw InvalidInput(fmt::format("{} is {}; lengths at cusps are finite", name, length));
    } else {
      require_length(length, name);
    }
  }
  return options.initial_lengths;
}

}  // namespace tripus::structure
