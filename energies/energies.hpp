#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "base/registry.hpp"
#include "solver/problem.hpp"
#include "topology/cone_angle.hpp"
#include "topology/triangulation.hpp"

namespace tripus::energies {

/// Dihedral angles [T x 6] to start from, all > 0, vertex sums < pi, edge sums the cone angles;
/// nothing where there are none. Called by those energies only that live there.
using InteriorAngles = std::function<std::optional<std::vector<double>>()>;

/// A functional in its own variables x [n], whose critical point is the metric, and the way back to
/// edge lengths.
class Functional {
 public:
  virtual ~Functional() = default;
  virtual const solver::Problem& problem() const = 0;
  /// Turns a point x [n] into edge lengths [E], in place; where x leaves them open, into their
  /// means over the corners of an edge.
  virtual void to_lengths(std::vector<double>& x) = 0;
};

/// One line of the table of energies.
struct Energy {
  std::string_view name;
  std::string_view description;  ///< one line for `tripus methods`
  std::string_view variables;    ///< what x is
  std::string_view prefix;       ///< as typed before a minimiser's name: "" or "angles:"
  /// Whether it is defined for geodesic boundary only: no cusps, finite vertices, parabolic edges.
  bool hyperideal_only = false;
  /// max|gradient| at which max|K| is within the tolerance, in units of it.
  double tolerance = 1;
  /// The functional; x, edge lengths [E] to start from, becomes the point in its variables that
  /// they stand for. Null where `angles` has nothing. Keeps references to the triangulation and the
  /// cone angles [E] (empty for 2 pi), which must outlive it.
  std::unique_ptr<Functional> (*begin)(const topology::Triangulation& triangulation,
                                       std::span<const topology::ConeAngle> cone_angles,
                                       const InteriorAngles& angles,
                                       std::vector<double>& x) = nullptr;
  int place = kAnyPlace;  ///< in lists, lowest first
};

/// Every energy, one file in energies/functionals each, in the order in which `tripus methods`
/// prints them. Whatever stands here can be solved (`--method PREFIX:MINIMISER`).
std::span<const Energy> energies();

/// The one whose variables are the lengths, without a prefix: what flows follow.
inline const Energy* energy_in_lengths() { return find_row(energies(), "co-volume"); }

}  // namespace tripus::energies
