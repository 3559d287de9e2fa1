#include "structure/assess.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "base/tolerances.hpp"
#include "geometry/curvature.hpp"
#include "geometry/truncated_tetrahedron.hpp"
#include "solver/extreme_eigenvalues.hpp"

namespace tripus::structure {
namespace {

/// Link data and areas of the vertex classes.
std::vector<VertexReport> report_vertices(const topology::Triangulation& triangulation,
                                          const std::vector<std::array<double, 6>>& angles) {
  std::vector<VertexReport> vertices(triangulation.vertex_count());
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    vertices[v].link_euler_characteristic = triangulation.link(v).euler_characteristic;
    vertices[v].genus = triangulation.link(v).genus();
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

/// Why the lengths are not those of a critical point of the energy, or empty if they are.
std::string not_critical(const energies::CoVolume& energy, const Report& report, double tolerance,
                         double norm_of_curvature) {
  if (!(report.max_curvature <= tolerance)) {
    return fmt::format("the largest edge curvature {:.3g} is above the tolerance {:.3g}",
                       report.max_curvature, tolerance);
  }
  const auto [shortest, longest] =
      std::minmax_element(report.edge_lengths.begin(), report.edge_lengths.end());
  const double scale = *shortest > 0 ? std::min(1.0, *shortest) : 1.0;
  // Saturated angles do add up to 2 pi in floating point: a computed K = 0 is one within rounding.
  const double curvature = std::max(norm_of_curvature, tolerance::kCurvatureRounding);
  const double enough = curvature / (tolerance::kMaxDistanceToMetric * scale);
  // The bound takes the flattest tetrahedron for all; the true least eigenvalue costs more.
  if (!(energy.convexity_bound() >= enough) &&
      !(solver::extreme_eigenvalues(energy).smallest >= enough)) {
    return fmt::format(
        "the curvature is small but so is the convexity of the energy (the longest edge has length "
        "{:.3g}), as when lengths run off to infinity",
        *longest);
  }
  return {};
}

/// Why a critical point is not a metric, though no tetrahedron is flat; or empty if it is one.
std::string not_a_metric(const topology::Triangulation& triangulation, const Report& report) {
  const auto shortest = std::min_element(report.edge_lengths.begin(), report.edge_lengths.end());
  if (!(*shortest > 0)) {
    return fmt::format("the length of edge class {} is {:.3g}, not positive",
                       shortest - report.edge_lengths.begin(), *shortest);
  }
  const std::size_t nearly = first_nearly_flat(report.dihedral_angles);
  if (nearly < triangulation.tetrahedron_count())
    return fmt::format("tetrahedron {} is flat within rounding", nearly);
  return {};
}

/// The outcome of what has been computed, and the sentence that goes with it.
void judge(const topology::Triangulation& triangulation, const energies::CoVolume& energy,
           double tolerance, double norm_of_curvature, const solver::Summary& summary,
           Report& report) {
  std::string why_not = not_critical(energy, report, tolerance, norm_of_curvature);
  if (why_not.empty() && !report.flat_tetrahedra.empty()) {
    report.outcome = Outcome::kDegenerate;
    report.message = fmt::format(
        "The co-volume is least where {} of the {} tetrahedra {} flat, so this triangulation "
        "carries no metric; its manifold may.",
        report.flat_tetrahedra.size(), triangulation.tetrahedron_count(),
        report.flat_tetrahedra.size() == 1 ? "is" : "are");
    return;
  }
  if (why_not.empty()) why_not = not_a_metric(triangulation, report);
  if (why_not.empty()) {
    report.outcome = Outcome::kGeometric;
    const bool smooth = std::ranges::all_of(energy.cone_angles(),
                                            [](double k) { return k == 2 * std::numbers::pi; });
    report.message = fmt::format(
        "This triangulation carries the hyperbolic {} with geodesic boundary{}; its volume is "
        "{:.12g}.",
        smooth ? "metric" : "cone metric", smooth ? "" : " and these cone angles", report.volume);
    return;
  }
  report.outcome = Outcome::kUnresolved;
  report.message = fmt::format(
      "No metric was found on this triangulation: the method {}{}{}, and {}. Nothing follows about "
      "the manifold.",
      to_string(summary.termination), summary.message.empty() ? "" : ": ", summary.message,
      why_not);
}

}  // namespace

Report assess(const topology::Triangulation& triangulation, energies::CoVolume& energy,
              std::span<const double> x, double tolerance, const solver::Summary& summary) {
  Report report;
  report.termination = summary.termination;
  report.iterations = summary.iterations;
  report.evaluations = summary.evaluations;
  report.linear_iterations = summary.linear_iterations;
  report.seconds = summary.seconds;
  report.edge_lengths.assign(x.begin(), x.end());

  std::vector<double> curvature(x.size());
  energy.evaluate(x, curvature, {.second_derivatives = true});
  double squares = 0;
  for (const double k : curvature) {
    report.max_curvature = std::max(report.max_curvature, std::fabs(k));
    squares += k * k;
  }
  report.flat_tetrahedra = energy.flat_tetrahedra();
  report.dihedral_angles.reserve(triangulation.tetrahedron_count());
  for (std::size_t t = 0; t < triangulation.tetrahedron_count(); ++t)
    report.dihedral_angles.push_back(energy.dihedral_angles(t));
  report.volume = energy.volume();
  report.vertices = report_vertices(triangulation, report.dihedral_angles);

  judge(triangulation, energy, tolerance, std::sqrt(squares), summary, report);
  return report;
}

}  // namespace tripus::structure
