#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/tolerances.hpp"
#include "energies/co_volume.hpp"
#include "geometry/mixed_tetrahedron.hpp"
#include "geometry/truncated_tetrahedron.hpp"
#include "structure/assess.hpp"
#include "structure/detail/other_ways.hpp"
#include "structure/method.hpp"

// Two kinds of minimiser at which Newton's method stalls.
//
// The four vertices of a tetrahedron lie in a plane of the manifold's own metric. Lengths within
// rounding of the minimiser then make it now flat, now a true one with angles off by 1e-8.
//
// An edge class has corners in flat tetrahedra only. H does not depend on its length as long as
// these stay flat, and the iteration comes to rest where one of them is just about to be a true
// one.
//
// With these tetrahedra held flat (the second constructor of CoVolume) the functional is smooth,
// and Newton's method is quick. Then the lengths of the second kind are moved to where all of them
// are truly flat. A minimiser of the functional with tetrahedra held where they are flat is one of
// H: theory (55).

namespace tripus::structure::detail {
namespace {

using topology::Triangulation;

constexpr int kNewtonSteps = 100;
constexpr double kLongestMove = 20;  // of a free length

/// The edge with the largest angle: in a nearly flat tetrahedron it and its opposite edge have pi.
std::size_t straight_edge(const std::array<double, 6>& theta) {
  return static_cast<std::size_t>(std::ranges::max_element(theta) - theta.begin());
}

std::vector<std::size_t> nearly_flat(const Triangulation& triangulation, const Report& report) {
  std::vector<std::size_t> found;
  for (std::size_t t = 0; t < triangulation.tetrahedron_count(); ++t)
    if (report.dihedral_angles[t][straight_edge(report.dihedral_angles[t])] >
        std::numbers::pi - tolerance::kNearlyFlat)
      found.push_back(t);
  return found;
}

/// Lengths [E] and the tetrahedra that are held flat.
struct Held {
  const Triangulation& triangulation;
  const Report& before;
  std::vector<std::size_t> tetrahedra;
  std::vector<double> x;
  /// Only to ask of which kind the vertices are.
  const energies::CoVolume* energy = nullptr;

  std::array<double, 6> angles_of(std::size_t t) const {
    std::array<double, 6> l, theta;
    for (std::size_t i = 0; i < 6; ++i) l[i] = x[triangulation.edge_class(t, static_cast<int>(i))];
    if (energy->is_hyperideal()) {
      geometry::extended_dihedral_angles(l, theta);
      return theta;
    }
    std::array<double, 4> diagonal;
    for (std::size_t v = 0; v < 4; ++v) {
      const auto& link = energy->links()[triangulation.vertex_class(t, static_cast<int>(v))];
      diagonal[v] = link.kind == topology::VertexKind::kIdeal ? 0 : 1;
    }
    geometry::mixed_dihedral_angles(l, diagonal, theta);
    return theta;
  }

  /// Whether all of them are flat in the way they were before, as far as rounding can tell.
  bool are_flat() const {
    return std::ranges::all_of(tetrahedra, [&](std::size_t t) {
      const std::array<double, 6> theta = angles_of(t);
      return theta[straight_edge(before.dihedral_angles[t])] >=
             std::numbers::pi - tolerance::kFlatAngleMargin;
    });
  }

  /// Edge classes with corners in these tetrahedra only.
  std::vector<std::size_t> free_edges() const {
    std::vector<std::size_t> corners(triangulation.edge_count()), found;
    for (const std::size_t t : tetrahedra)
      for (int i = 0; i < 6; ++i) ++corners[triangulation.edge_class(t, i)];
    for (std::size_t e = 0; e < corners.size(); ++e)
      if (corners[e] == triangulation.valence(e)) found.push_back(e);
    return found;
  }

  /// Derivative by the length of a free edge class e of the sum of cov(l) - <alpha, l> over these
  /// tetrahedra, alpha being what their angles are held at. It never decreases, and it is 0 where
  /// they are flat.
  double excess_angle(std::size_t e) const {
    double sum = 0;
    for (const std::size_t t : tetrahedra) {
      const std::array<double, 6> theta = angles_of(t);
      const std::size_t straight = straight_edge(before.dihedral_angles[t]);
      for (std::size_t i = 0; i < 6; ++i) {
        if (triangulation.edge_class(t, static_cast<int>(i)) != e) continue;
        sum += i == straight || i == 5 - straight ? theta[i] - std::numbers::pi : theta[i];
      }
    }
    return sum;
  }

  /// Up to where, between 0 and kLongestMove beyond its length, the excess angle of a free edge
  /// class is as `below` says.
  double crossing(std::size_t e, bool (*below)(double excess)) {
    const bool bounded = energy->is_hyperideal() || energy->is_between_hyperideal(e);
    double lower = bounded ? 0 : x[e] - kLongestMove, upper = x[e] + kLongestMove;
    for (;;) {
      x[e] = lower + (upper - lower) / 2;
      if (!(x[e] > lower && x[e] < upper)) return x[e];
      (below(excess_angle(e)) ? lower : upper) = x[e];
    }
  }

  /// Moves the length of a free edge class into the middle of where the tetrahedra at it are flat.
  void centre(std::size_t e) {
    const double here = x[e];
    const double first = crossing(e, [](double excess) { return excess < 0; });
    x[e] = here;
    const double last = crossing(e, [](double excess) { return excess <= 0; });
    x[e] = first + (last - first) / 2;
  }
};

}  // namespace

std::optional<Report> flat_minimiser(const Triangulation& triangulation,
                                     const SolveOptions& options, const Report& report) {
  Held held{triangulation, report, nearly_flat(triangulation, report), report.edge_lengths};
  if (held.tetrahedra.empty()) return std::nullopt;
  const energies::CoVolume plain(triangulation, options.cone_angles);
  const energies::CoVolume energy(plain.at(held.x), held.tetrahedra);
  held.energy = &energy;
  solver::Options inner;
  inner.tolerance = options.tolerance;
  inner.max_iterations = kNewtonSteps;
  const auto* newton = find_solve_method("auto", held.x.size()).minimiser;
  solver::Summary summary = newton->minimise(energy, held.x, inner);
  if (!held.are_flat())
    for (const std::size_t e : held.free_edges()) held.centre(e);
  if (!held.are_flat()) return std::nullopt;
  summary.iterations += report.iterations;
  summary.evaluations += report.evaluations;
  summary.linear_iterations += report.linear_iterations;
  Report found = assess(triangulation, energy, held.x, options.tolerance, summary);
  if (found.outcome != Outcome::kDegenerate) return std::nullopt;
  found.method = report.method;
  found.advice = report.advice;
  return found;
}

}  // namespace tripus::structure::detail
