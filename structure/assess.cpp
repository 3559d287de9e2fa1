#include "structure/assess.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <fmt/format.h>

#include "base/tolerances.hpp"
#include "geometry/curvature.hpp"
#include "geometry/truncated_tetrahedron.hpp"
#include "solver/extreme_eigenvalues.hpp"
#include "solver/newton_direction.hpp"
#include "structure/horospheres.hpp"

namespace tripus::structure {
namespace {

using topology::VertexKind;

/// Link data and areas of the vertex classes.
std::vector<VertexReport> report_vertices(const topology::Triangulation& triangulation,
                                          const energies::CoVolumeAt& at,
                                          const std::vector<std::array<double, 6>>& angles) {
  const energies::CoVolume& energy = at.energy();
  std::vector<VertexReport> vertices(triangulation.vertex_count());
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const topology::VertexLink& link = triangulation.link(v);
    vertices[v].link_euler_characteristic = link.euler_characteristic;
    vertices[v].orientable = link.orientable;
    vertices[v].genus = link.orientable ? link.genus() : 0;
    vertices[v].kind = energy.links()[v].kind;
    vertices[v].cone_points = energy.links()[v].cone_points;
    vertices[v].orbifold_euler_characteristic = energy.links()[v].euler_characteristic;
  }
  for (std::size_t t = 0; t < angles.size(); ++t) {
    for (int v = 0; v < 4; ++v) {
      const auto& edges = geometry::kEdgesAtVertex[static_cast<std::size_t>(v)];
      const auto angle = [&](std::size_t k) {
        return angles[t][static_cast<std::size_t>(edges[k])];
      };
      vertices[triangulation.vertex_class(t, v)].area +=
          geometry::truncation_area(angle(0), angle(1), angle(2));
    }
  }
  if (energy.is_hyperideal()) return vertices;
  const std::vector<double> areas = horosphere_areas(triangulation, at);
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    if (vertices[v].kind == VertexKind::kFinite) vertices[v].area = -vertices[v].area;
    if (vertices[v].kind == VertexKind::kIdeal)
      vertices[v].area = std::isfinite(areas[v]) ? areas[v] : 0;
  }
  return vertices;
}

/// The first tetrahedron that is flat as far as rounding can tell, or the tetrahedron count.
std::size_t first_nearly_flat(const std::vector<std::array<double, 6>>& angles) {
  const auto found = std::find_if(angles.begin(), angles.end(), [](const auto& theta) {
    return *std::max_element(theta.begin(), theta.end()) >
           std::numbers::pi - tolerance::kFlatAngleMargin;
  });
  return static_cast<std::size_t>(found - angles.begin());
}

/// The edge class of least length among those whose length must be positive: between hyperideal
/// vertices and not parabolic. Edge class 0 if there is none.
std::size_t shortest_edge(const energies::CoVolume& energy, std::span<const double> lengths) {
  std::size_t found = lengths.size();
  for (std::size_t e = 0; e < lengths.size(); ++e) {
    if (!energy.is_hyperideal() && !energy.is_between_hyperideal(e)) continue;
    if (energy.cone_angles()[e] == 0) continue;
    if (found == lengths.size() || lengths[e] < lengths[found]) found = e;
  }
  return found == lengths.size() ? 0 : found;
}

bool has_finite_vertices(const energies::CoVolume& energy) {
  return std::ranges::any_of(energy.links(),
                             [](const auto& link) { return link.kind == VertexKind::kFinite; });
}

/// Up to so many variables matrices are dense, and on the stack.
constexpr int kFewVariables = 8;
using FewByFew =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kFewVariables, kFewVariables>;

/// An upper bound of the length of the Newton step for g that moves no horosphere, for few
/// variables: the step that is 0 at the pins differs from it by such moves, and it is the shortest.
/// Infinity for many variables, and where the matrix is not positive definite.
double small_distance_bound(const energies::CoVolumeAt& at, std::span<const double> g) {
  constexpr double kUnknown = std::numeric_limits<double>::infinity();
  const auto n = static_cast<Eigen::Index>(g.size());
  if (n > kFewVariables) return kUnknown;
  FewByFew H(n, n);
  at.dense_hessian(std::span(H.data(), g.size() * g.size()));
  Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kFewVariables, 1> step(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    step(i) = g[static_cast<std::size_t>(i)];
    if (H(i, i) > 0) continue;
    if (step(i) != 0) return kUnknown;
    H(i, i) = 1;
  }
  for (const std::uint32_t pin : at.energy().pins()) H(pin, pin) *= 2;
  const Eigen::LLT<FewByFew> factor(H);
  if (factor.info() != Eigen::Success) return kUnknown;
  factor.solveInPlace(step);
  const double length = step.norm();
  return std::isfinite(length) ? length : kUnknown;
}

/// A lower bound of the least eigenvalue of the Hessian of few variables, the reciprocal of the
/// trace of its inverse; 0 for many variables, or where it is not positive definite.
double small_convexity_bound(const energies::CoVolumeAt& at) {
  const energies::CoVolume& energy = at.energy();
  const auto n = static_cast<Eigen::Index>(energy.dimension());
  if (n > kFewVariables) return 0;
  FewByFew H(n, n);
  at.dense_hessian(std::span(H.data(), static_cast<std::size_t>(n * n)));
  const Eigen::LLT<FewByFew> factor(H);
  if (factor.info() != Eigen::Success) return 0;
  FewByFew inverse = FewByFew::Identity(n, n);
  factor.matrixL().solveInPlace(inverse);
  const double trace = inverse.squaredNorm();
  return std::isfinite(trace) ? 1 / trace : 0;
}

/// Where some vertex is ideal or some edge parabolic, no bound of the convexity comes from single
/// tetrahedra: they do not see the horospheres move, nor the edge. The Newton step itself then says
/// how far the minimiser is.
std::string distance_objection(const topology::Triangulation& triangulation,
                               const energies::CoVolumeAt& at, double longest, double scale) {
  constexpr double kNothing = 1e-5 * tolerance::kCurvatureRounding;
  const energies::CoVolume& energy = at.energy();
  std::vector<double> gradient(at.gradient().begin(), at.gradient().end());
  for (std::size_t e = 0; e < gradient.size(); ++e) {
    if (energy.cone_angles()[e] == 0) gradient[e] = 0;
    if (gradient[e] != 0 && std::fabs(gradient[e]) < tolerance::kCurvatureRounding)
      gradient[e] = std::copysign(tolerance::kCurvatureRounding, gradient[e]);
  }
  // Without the flat tetrahedra the rest may come apart, into more cusps than there were, whose
  // horospheres move one by one.
  constexpr double kLeastCurvature = 1e-9;
  const bool flat = at.flat_count() > 0;
  if (!flat) remove_horosphere_shifts(triangulation, energy, gradient);
  for (double& g : gradient)
    if (std::fabs(g) < kNothing) g = 0;
  if (!flat && small_distance_bound(at, gradient) <= tolerance::kMaxDistanceToMetric * scale)
    return {};
  const double distance = solver::newton_distance(at, gradient, flat ? kLeastCurvature : 0);
  if (distance <= tolerance::kMaxDistanceToMetric * scale) return {};
  return fmt::format(
      "the curvature is small but a metric is not near (the longest edge has length {:.3g}), as "
      "when "
      "lengths run off to infinity",
      longest);
}

/// Why the lengths are not those of a critical point of the energy, or empty if they are.
std::string not_critical(const topology::Triangulation& triangulation,
                         const energies::CoVolumeAt& at, const Report& report, double tolerance) {
  const energies::CoVolume& energy = at.energy();
  if (!(report.max_curvature <= tolerance)) {
    return fmt::format("the largest edge curvature {:.3g} is above the tolerance {:.3g}",
                       report.max_curvature, tolerance);
  }
  const double longest = *std::ranges::max_element(report.edge_lengths);
  const double shortest = report.edge_lengths[shortest_edge(energy, report.edge_lengths)];
  const double scale = shortest > 0 ? std::min(1.0, shortest) : 1.0;
  if (has_finite_vertices(energy)) {
    if (longest < tolerance::kLongestFiniteEdge) return {};
    return fmt::format("an edge has length {:.3g}, as when finite vertices run off to infinity",
                       longest);
  }
  const bool parabolic = std::ranges::any_of(energy.cone_angles(), [](double k) { return k == 0; });
  if (!energy.is_hyperideal() || parabolic)
    return distance_objection(triangulation, at, longest, scale);
  // Saturated angles do add up to 2 pi in floating point: a computed K = 0 is one within rounding.
  double squares = 0;
  for (const double k : at.gradient()) squares += k * k;
  const double curvature = std::max(std::sqrt(squares), tolerance::kCurvatureRounding);
  const double enough = curvature / (tolerance::kMaxDistanceToMetric * scale);
  // The cheapest bound first. The second takes the flattest tetrahedron for all; the true least
  // eigenvalue costs more.
  if (!(small_convexity_bound(at) >= enough) && !(at.convexity_bound() >= enough) &&
      !(solver::extreme_eigenvalues(at).smallest >= enough)) {
    return fmt::format(
        "the curvature is small but so is the convexity of the energy (the longest edge has length "
        "{:.3g}), as when lengths run off to infinity",
        longest);
  }
  return {};
}

/// Why a critical point is not a metric, though no tetrahedron is flat; or empty if it is one.
std::string not_a_metric(const topology::Triangulation& triangulation,
                         const energies::CoVolume& energy, const Report& report) {
  const std::size_t shortest = shortest_edge(energy, report.edge_lengths);
  const bool counts = energy.is_hyperideal() || energy.is_between_hyperideal(shortest);
  if (counts && energy.cone_angles()[shortest] > 0 && !(report.edge_lengths[shortest] > 0)) {
    return fmt::format("the length of edge class {} is {:.3g}, not positive", shortest,
                       report.edge_lengths[shortest]);
  }
  const std::size_t nearly = first_nearly_flat(report.dihedral_angles);
  if (nearly < triangulation.tetrahedron_count())
    return fmt::format("tetrahedron {} is flat within rounding", nearly);
  return {};
}

bool has_cusps(const energies::CoVolume& energy) {
  return std::ranges::any_of(energy.links(),
                             [](const auto& link) { return link.kind == VertexKind::kIdeal; }) ||
         std::ranges::any_of(energy.cone_angles(), [](double k) { return k == 0; });
}

/// " with geodesic boundary and cusps", or what there is of it.
std::string ends_of(const energies::CoVolume& energy) {
  const bool boundary = std::ranges::any_of(
      energy.links(), [](const auto& link) { return link.kind == VertexKind::kHyperideal; });
  if (!has_cusps(energy)) return boundary ? " with geodesic boundary" : "";
  return boundary ? " with geodesic boundary and cusps" : " with cusps";
}

/// The outcome of what has been computed, and the sentence that goes with it.
void judge(const topology::Triangulation& triangulation, const energies::CoVolumeAt& at,
           double tolerance, const solver::Summary& summary, Report& report) {
  const energies::CoVolume& energy = at.energy();
  std::string why_not = not_critical(triangulation, at, report, tolerance);
  if (why_not.empty() && !report.flat_tetrahedra.empty()) {
    report.outcome = Outcome::kDegenerate;
    report.message = fmt::format(
        "The co-volume is least where {} of the {} tetrahedra {} flat, so this triangulation "
        "carries no metric; its manifold may.",
        report.flat_tetrahedra.size(), triangulation.tetrahedron_count(),
        report.flat_tetrahedra.size() == 1 ? "is" : "are");
    return;
  }
  if (why_not.empty()) why_not = not_a_metric(triangulation, energy, report);
  if (why_not.empty()) {
    report.outcome = Outcome::kGeometric;
    const bool smooth = std::ranges::all_of(energy.cone_angles(),
                                            [](double k) { return k == 2 * std::numbers::pi; });
    report.message =
        fmt::format("This triangulation carries the {}hyperbolic {}{}{}; its volume is {:.12g}.",
                    has_cusps(energy) ? "complete " : "", smooth ? "metric" : "cone metric",
                    ends_of(energy), smooth ? "" : " and these cone angles", report.volume);
    return;
  }
  report.outcome = Outcome::kUnresolved;
  report.message = fmt::format(
      "No metric was found on this triangulation: the method {}{}{}, and {}. Nothing follows about "
      "the manifold.",
      to_string(summary.termination), summary.message.empty() ? "" : ": ", summary.message,
      why_not);
}

/// What the functional at the lengths of the report gives.
void fill_geometry(const topology::Triangulation& triangulation, const energies::CoVolumeAt& at,
                   Report& report) {
  for (const double k : at.gradient())
    report.max_curvature = std::max(report.max_curvature, std::fabs(k));
  report.flat_tetrahedra = at.flat_tetrahedra();
  report.dihedral_angles.reserve(triangulation.tetrahedron_count());
  for (std::size_t t = 0; t < triangulation.tetrahedron_count(); ++t)
    report.dihedral_angles.push_back(at.dihedral_angles(t));
  report.volume = at.volume();
  report.vertices = report_vertices(triangulation, at, report.dihedral_angles);
}

}  // namespace

Report report_at(const topology::Triangulation& triangulation, const energies::CoVolume& energy,
                 std::span<const double> x) {
  Report report;
  report.edge_lengths.assign(x.begin(), x.end());
  report.evaluations = 1;
  fill_geometry(triangulation, energy.at(x), report);
  return report;
}

Report assess(const topology::Triangulation& triangulation, const energies::CoVolume& energy,
              std::span<const double> x, double tolerance, const solver::Summary& summary) {
  Report report;
  report.termination = summary.termination;
  report.iterations = summary.iterations;
  report.evaluations = summary.evaluations;
  report.linear_iterations = summary.linear_iterations;
  report.seconds = summary.seconds;
  report.edge_lengths.assign(x.begin(), x.end());
  if (!energy.is_hyperideal())
    if (const auto at = energy.at(x); at.is_defined())
      set_horospheres(triangulation, at, report.edge_lengths);
  const auto at = energy.at(report.edge_lengths, solver::Order::kSecond);
  fill_geometry(triangulation, at, report);
  judge(triangulation, at, tolerance, summary, report);
  return report;
}

}  // namespace tripus::structure
