#include "structure/starting_lengths.hpp"

#include <algorithm>
#include <array>
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

/// What a triangulation has of each kind, by the number of ideal vertices.
struct Kinds {
  std::array<double, 5> tetrahedra = {};
  std::array<double, 3> edges = {};
  std::array<double, 3> cone_angles = {};  ///< their sums
  std::vector<int> ideal_ends;             ///< [edge classes]
};

Kinds kinds_of(const topology::Triangulation& triangulation, const SolveOptions& options) {
  const auto links = topology::orbifold_links(triangulation, options.cone_angles);
  const auto is_ideal = [&](std::size_t t, int v) {
    return links[triangulation.vertex_class(t, v)].kind == topology::VertexKind::kIdeal;
  };
  Kinds kinds;
  for (std::size_t t = 0; t < triangulation.tetrahedron_count(); ++t) {
    int ideal = 0;
    for (int v = 0; v < 4; ++v) ideal += is_ideal(t, v);
    ++kinds.tetrahedra[std::size_t(ideal)];
  }
  for (std::size_t e = 0; e < triangulation.edge_count(); ++e) {
    const auto corner = triangulation.corners(e)[0];
    int ends = 0;
    for (const int v : topology::kEdgeEnds[std::size_t(corner.edge())])
      ends += is_ideal(corner.tetrahedron(), v);
    kinds.ideal_ends.push_back(ends);
    ++kinds.edges[std::size_t(ends)];
    kinds.cone_angles[std::size_t(ends)] +=
        options.cone_angles.empty() ? 2 * std::numbers::pi : options.cone_angles[e].radians();
  }
  return kinds;
}

/// The dihedral angle between hyperideal vertices of the symmetric tetrahedron with so many ideal
/// vertices and the Gram entries of the regular one of angle theta (docs/theory.md (117)).
double symmetric_angle(int ideal, double theta) {
  const double c = std::cos(theta);
  if (ideal == 0) return theta;
  return std::acos(std::min(1.0, ideal == 1 ? std::sqrt((3 * c - 1) / 2) : (3 - 1 / c) / 2));
}

/// The angle theta of regular tetrahedra, such that the symmetric ones with their Gram entries have
/// the sum of angles that the edges between hyperideal vertices ask for. The sum is nearly linear
/// in theta, which secants use.
double regular_angle(const Kinds& kinds) {
  constexpr int kMostSecants = 20;
  constexpr double kRounding = 1e-15;
  constexpr std::array<double, 3> kCorners = {6, 3, 1};
  const auto sum_at = [&](double theta) {
    double sum = 0;
    for (int ideal = 0; ideal < 3; ++ideal)
      sum += kinds.tetrahedra[std::size_t(ideal)] * kCorners[std::size_t(ideal)] *
             symmetric_angle(ideal, theta);
    return sum;
  };
  const double corners = 6 * kinds.tetrahedra[0] + 3 * kinds.tetrahedra[1] + kinds.tetrahedra[2];
  const double wanted = kinds.cone_angles[0];
  double theta = wanted / corners;
  if (kinds.tetrahedra[1] + kinds.tetrahedra[2] == 0) return theta;
  double before = 0, sum_before = 0;  // all are flat
  for (int secant = 0; secant < kMostSecants && theta > 0 && theta < std::numbers::pi / 3;
       ++secant) {
    const double sum = sum_at(theta);
    if (std::fabs(sum - wanted) <= kRounding * wanted || sum == sum_before) break;
    const double next = theta + (wanted - sum) * (theta - before) / (sum - sum_before);
    before = theta;
    sum_before = sum;
    theta = next;
  }
  return theta;
}

/// What all entries of the Gram matrices beside their diagonals begin with, but for their sign,
/// with diagonals 1 and 0: the edges between hyperideal vertices, or where there are none those
/// with one ideal end, get the sum of angles that their cone angles ask for. Where that is out of
/// reach, the entry of length 1.
double default_entry(const Kinds& kinds) {
  const bool from_ideal = kinds.edges[0] == 0 && kinds.tetrahedra[3] > 0;
  const double theta =
      from_ideal ? kinds.cone_angles[1] / (3 * kinds.tetrahedra[3]) : regular_angle(kinds);
  const double c = std::cos(theta);
  if (!(theta > 0 && 2 * c - 1 > 1e-3)) return std::cosh(1.0);
  return (from_ideal ? 1 - c : c) / (2 * c - 1);
}

}  // namespace

double regular_edge_length(double theta) {
  return std::acosh(std::cos(theta) / (2 * std::cos(theta) - 1));
}

std::vector<double> starting_lengths(const topology::Triangulation& triangulation,
                                     const SolveOptions& options) {
  const std::size_t edges = triangulation.edge_count();
  const Kinds kinds = kinds_of(triangulation, options);
  const auto is_parabolic = [&](std::size_t e) {
    return !options.cone_angles.empty() && options.cone_angles[e].is_parabolic();
  };
  if (options.initial_lengths.empty()) {
    if (options.initial_length != 0) require_length(options.initial_length, "the initial length");
    // Of edges between hyperideal vertices; at an ideal one the horosphere is that at which it is
    // the limit of hyperideal ones.
    double length = options.initial_length;
    double log_entry = length + std::log1p(std::exp(-2 * length)) - std::numbers::ln2;  // log cosh
    if (length == 0) {
      const double entry = default_entry(kinds);
      length = std::acosh(std::max(1.0, entry));
      log_entry = std::log(entry);
    }
    const std::array<double, 3> by_ideal_ends = {length, log_entry / 2, -std::numbers::ln2};
    std::vector<double> lengths(edges);
    for (std::size_t e = 0; e < edges; ++e)
      lengths[e] = is_parabolic(e) ? 0 : by_ideal_ends[std::size_t(kinds.ideal_ends[e])];
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
    } else if (kinds.ideal_ends[e] > 0) {
      if (!std::isfinite(length))
        throw InvalidInput(fmt::format("{} is {}; lengths at cusps are finite", name, length));
    } else {
      require_length(length, name);
    }
  }
  return options.initial_lengths;
}

}  // namespace tripus::structure
