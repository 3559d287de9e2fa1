#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "geometry/curvature.hpp"
#include "geometry/edge_frames.hpp"
#include "geometry/truncated_tetrahedron.hpp"
#include "structure/detail/other_ways.hpp"
#include "structure/proof/detail/arb_number.hpp"
#include "structure/proof/detail/precise_tetrahedron.hpp"
#include "structure/proof/digits.hpp"
#include "topology/requirements.hpp"

// Newton's method for the extended co-volume, which is convex and C1: flat tetrahedra have constant
// angles. Where some become flat or cease to be, the derivative has the root of a distance in it,
// so that steps are cut until the slope along them falls; once all keep their kinds it is
// quadratic.

namespace tripus::structure::detail {
namespace {

using geometry::TetrahedronKind;
using topology::Triangulation;

constexpr long kBits = 256;
constexpr int kMostSteps = 400;
constexpr int kMostCuts = 60;
/// max|K| where Newton's method has converged: far below what any double can tell.
constexpr double kConverged = 1e-40;
/// Of the least entry of the diagonal: so small that it costs no step.
constexpr double kShift = 1e-24;

struct Point {
  std::vector<Arb> x;                      // [E] exact
  std::vector<std::array<Arb, 6>> angles;  // [T]
  std::vector<bool> flat;                  // [T]
  std::vector<Arb> curvature;              // [E]
  double max_curvature = 0;
};

class PreciseRun {
 public:
  PreciseRun(const Triangulation& triangulation, const SolveOptions& options, const Report& report)
      : triangulation_(triangulation), options_(options) {
    for (const double l : report.edge_lengths) here_.x.emplace_back(l);
  }

  bool run() {
    if (!evaluate(here_)) return false;
    while (here_.max_curvature > kConverged) {
      if (++steps_ > kMostSteps || stopped() || !step()) return false;
    }
    return true;
  }
  const Point& at() const { return here_; }
  int steps() const { return steps_; }
  /// The sum of the volumes of true tetrahedra, rounded; nothing if that cannot be enclosed.
  std::optional<double> volume() const {
    Arb sum;
    for (std::size_t t = 0; t < here_.angles.size(); ++t) {
      if (here_.flat[t]) continue;
      const auto found = precise_tetrahedron(lengths_of(here_, t), true);
      if (!found) return std::nullopt;
      sum = sum + found->volume;
    }
    return sum.mid();
  }

 private:
  bool stopped() const { return options_.stop.requested(); }
  std::array<Arb, 6> lengths_of(const Point& p, std::size_t t) const {
    std::array<Arb, 6> l;
    for (std::size_t e = 0; e < 6; ++e)
      l[e] = p.x[triangulation_.edge_class(t, static_cast<int>(e))];
    return l;
  }

  /// Sets all but x; false if a length is not positive, or the precision is not enough.
  bool evaluate(Point& p) const {
    const Arb pi = number_pi(Arb());
    p.angles.assign(triangulation_.tetrahedron_count(), {});
    p.flat.assign(triangulation_.tetrahedron_count(), false);
    p.curvature.assign(p.x.size(), 2.0 * pi);
    for (const Arb& length : p.x)
      if (!length.positive()) return false;
    for (std::size_t t = 0; t < p.angles.size(); ++t) {
      const std::array<Arb, 6> l = lengths_of(p, t);
      if (auto found = precise_tetrahedron(l, false)) {
        p.angles[t] = std::move(found->angles);
      } else if (const auto kind = proved_flat(l)) {
        const auto straight =
            static_cast<std::size_t>(*kind) - static_cast<std::size_t>(TetrahedronKind::kFlat01_23);
        p.flat[t] = true;
        p.angles[t][straight] = p.angles[t][5 - straight] = pi;
      } else {
        return false;
      }
      for (std::size_t i = 0; i < 6; ++i) {
        Arb& sum = p.curvature[triangulation_.edge_class(t, static_cast<int>(i))];
        sum = (sum - p.angles[t][i]).midpoint();
      }
    }
    p.max_curvature = 0;
    for (const Arb& K : p.curvature)
      p.max_curvature = std::max(p.max_curvature, std::fabs(K.mid()));
    return true;
  }

  /// The Newton step: (J + shift) step = K, where J adds up what lengths do to angles.
  bool solve(std::vector<Arb>& step) const {
    const std::size_t n = here_.x.size();
    ArbMatrix hessian(n, n), right(n, 1), solution(n, 1);
    for (std::size_t t = 0; t < here_.angles.size(); ++t) {
      if (here_.flat[t]) continue;
      const auto jacobian = precise_jacobian(lengths_of(here_, t));
      if (!jacobian) return false;
      for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) {
          const auto q =
              static_cast<std::size_t>(geometry::packed_index(std::min(i, j), std::max(i, j)));
          arb_ptr entry =
              hessian.at(triangulation_.edge_class(t, i), triangulation_.edge_class(t, j));
          arb_add(entry, entry, (*jacobian)[q].get(), Precision::bits());
        }
    }
    double scale = 1;
    for (std::size_t e = 0; e < n; ++e)
      scale = std::max(scale, std::fabs(arf_get_d(arb_midref(hessian.at(e, e)), ARF_RND_NEAR)));
    const Arb shift(kShift * (scale < 1e6 ? scale : 1e6));
    for (std::size_t e = 0; e < n; ++e) {
      arb_add(hessian.at(e, e), hessian.at(e, e), shift.get(), Precision::bits());
      arb_set(right.at(e, 0), here_.curvature[e].get());
    }
    if (arb_mat_approx_solve(solution.get(), hessian.get(), right.get(), Precision::bits()) == 0)
      return false;
    step.resize(n);
    for (std::size_t e = 0; e < n; ++e) {
      arb_set(step[e].get(), solution.at(e, 0));
      step[e] = step[e].midpoint();
    }
    return true;
  }

  /// No longer than a length of 1 along any edge.
  static double largest(const std::vector<Arb>& step) {
    double size = 0;
    for (const Arb& s : step) size = std::max(size, std::fabs(s.mid()));
    return size;
  }

  /// Minus the slope of the co-volume along a step.
  static Arb descent(const Point& p, const std::vector<Arb>& step) {
    Arb sum;
    for (std::size_t e = 0; e < step.size(); ++e) sum = sum + p.curvature[e] * step[e];
    return sum.midpoint();
  }

  bool step() {
    std::vector<Arb> step;
    if (!solve(step)) return false;
    const double size = largest(step);
    if (!std::isfinite(size)) return false;
    double part = size > 1 ? 1 / size : 1;
    const Arb before = descent(here_, step);
    if (!before.positive()) return false;
    // The slope along the step rises from -before; the step is good where it is near 0, of either
    // sign: a convex function has then fallen.
    for (int cut = 0; cut < kMostCuts; ++cut, part /= 2) {
      Point next;
      for (std::size_t e = 0; e < step.size(); ++e)
        next.x.push_back((here_.x[e] + Arb(part) * step[e]).midpoint());
      if (!evaluate(next)) continue;
      const Arb after = descent(next, step);
      if (!(0.5 * before + after).positive()) continue;
      here_ = std::move(next);
      return true;
    }
    return false;
  }

  const Triangulation& triangulation_;
  const SolveOptions& options_;
  Point here_;
  int steps_ = 0;
};

bool is_hyperideal(const Report& report) {
  return std::ranges::all_of(report.vertices, [](const VertexReport& vertex) {
    return vertex.kind == topology::VertexKind::kHyperideal;
  });
}

/// The numbers of the report at a point.
Report report_at(const Triangulation& triangulation, const PreciseRun& run, double volume,
                 const Report& before) {
  Report report = before;
  const Point& p = run.at();
  report.iterations += run.steps();
  report.evaluations += run.steps();
  report.termination = solver::Termination::kConverged;
  report.max_curvature = p.max_curvature;
  report.volume = volume;
  report.flat_tetrahedra.clear();
  for (std::size_t e = 0; e < p.x.size(); ++e) report.edge_lengths[e] = p.x[e].mid();
  for (VertexReport& vertex : report.vertices) vertex.area = 0;
  for (std::size_t t = 0; t < p.angles.size(); ++t) {
    auto& angles = report.dihedral_angles[t];
    for (std::size_t i = 0; i < 6; ++i) angles[i] = p.angles[t][i].mid();
    if (p.flat[t]) report.flat_tetrahedra.push_back(t);
    for (int v = 0; v < 4; ++v) {
      const auto& edges = geometry::kEdgesAtVertex[static_cast<std::size_t>(v)];
      const auto angle = [&](std::size_t k) { return angles[static_cast<std::size_t>(edges[k])]; };
      report.vertices[triangulation.vertex_class(t, v)].area +=
          geometry::truncation_area(angle(0), angle(1), angle(2));
    }
  }
  return report;
}

}  // namespace

std::optional<Report> precise_minimiser(const Triangulation& triangulation,
                                        const SolveOptions& options, const Report& report) {
  if (!is_hyperideal(report) || !topology::all_full(options.cone_angles) ||
      triangulation.edge_count() > kMostEdgesForDigits)
    return std::nullopt;
  const Precision precision(kBits);
  PreciseRun run(triangulation, options, report);
  if (!run.run()) return std::nullopt;
  const auto volume = run.volume();
  if (!volume) return std::nullopt;
  Report found = report_at(triangulation, run, *volume, report);
  if (found.flat_tetrahedra.empty()) {
    found.outcome = Outcome::kGeometric;
    found.advice = Advice::kNone;
    found.message = fmt::format(
        "This triangulation carries the hyperbolic metric with geodesic boundary; its volume is "
        "{:.12g}. Some tetrahedra are so nearly flat that it was found with {} bits; at the "
        "lengths "
        "rounded to doubles edge curvatures are larger.",
        found.volume, kBits);
  } else {
    found.outcome = Outcome::kDegenerate;
    found.message = fmt::format(
        "The co-volume is least where {} of the {} tetrahedra {} flat, found with {} bits, so this "
        "triangulation carries no metric; its manifold may.",
        found.flat_tetrahedra.size(), triangulation.tetrahedron_count(),
        found.flat_tetrahedra.size() == 1 ? "is" : "are", kBits);
  }
  return found;
}

}  // namespace tripus::structure::detail
