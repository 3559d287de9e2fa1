#include <numbers>

#include <fmt/format.h>

#include "cli/remedies.hpp"
#include "cli/texts.hpp"
#include "structure/valence_theorem.hpp"

namespace tripus::cli {
namespace {

using structure::Report;
using structure::VertexReport;

/// The first rows of a long table, and a line that says how many there are.
constexpr std::size_t kRowsShown = 20;

void append_edge_table(std::string& text, const Subject& subject, const Report& report) {
  text += "  edge class  valence  length\n";
  for (std::size_t e = 0; e < report.edge_lengths.size(); ++e) {
    if (e == kRowsShown) {
      text +=
          fmt::format("  ... ({} in all; --json prints every one)\n", report.edge_lengths.size());
      return;
    }
    text += fmt::format("  {:>10}  {:>7}  {}\n", e, subject.triangulation.valence(e),
                        report.edge_lengths[e]);
  }
}

void append_angle_table(std::string& text, const Report& report) {
  text += "  tetrahedron  dihedral angles at 01 02 03 12 13 23, in units of pi\n";
  for (std::size_t t = 0; t < report.dihedral_angles.size(); ++t) {
    if (t == kRowsShown) {
      text += fmt::format("  ... ({} in all; --json prints every one, in radians)\n",
                          report.dihedral_angles.size());
      return;
    }
    text += fmt::format("  {:>11} ", t);
    for (const double angle : report.dihedral_angles[t])
      text += fmt::format(" {:.10f}", angle / std::numbers::pi);
    text += '\n';
  }
}

/// The certificate in the words of a person; --json prints it for `tripus check`.
void append_certificate(std::string& text, const structure::Certificate& certificate) {
  std::vector<std::string> edges;
  for (const auto& u : certificate.edge) edges.push_back(to_decimal(u));
  text += fmt::format(
      "  certificate     kind \"{}\"; edge multipliers {} (--json has them all, for tripus "
      "check)\n",
      structure::to_string(certificate.kind), shortened(edges));
}

/// An exact strict angle structure: integers over one denominator.
void append_strict_angles(std::string& text, const structure::StrictAngles& angles) {
  text += fmt::format(
      "  tetrahedron  strict angle structure at 01 02 03 12 13 23, exact, in units of pi/{}\n",
      to_decimal(angles.denominator));
  for (std::size_t t = 0; t < angles.numerator.size(); ++t) {
    if (t == kRowsShown) {
      text += fmt::format("  ... ({} in all; --json prints every one)\n", angles.numerator.size());
      return;
    }
    text += fmt::format("  {:>11} ", t);
    for (const auto& angle : angles.numerator[t]) text += " " + to_decimal(angle);
    text += '\n';
  }
}

/// The moves of a search, for people.
void append_path(std::string& text, const structure::Retriangulation& found) {
  text += fmt::format("  retriangulated  from {}: {} tried\n", found.start,
                      counted(found.tried, "triangulation", "triangulations"));
  if (!found.simplified.empty())
    text += fmt::format("                  simplified to {}\n", found.simplified);
  for (const topology::Move& move : found.path)
    text += fmt::format("                  {}\n", topology::to_string(move));
  for (const structure::OtherVolume& other : found.volumes) {
    text += fmt::format("  volume again    {} on {}{}\n", other.volume, other.isosig,
                        other.outcome == structure::Outcome::kDegenerate
                            ? ", at a minimiser with flat tetrahedra"
                            : "");
  }
}

/// "  boundary        geodesic surface of genus 2, area 12.56...".
std::string vertex_line(const VertexReport& vertex) {
  const topology::VertexLink link{vertex.link_euler_characteristic, vertex.orientable, 0};
  std::string surface = topology::surface_name(link);
  if (vertex.cone_points > 0)
    surface += fmt::format(" with {}", counted(vertex.cone_points, "cone point", "cone points"));
  switch (vertex.kind) {
    case topology::VertexKind::kHyperideal:
      if (link.orientable && vertex.cone_points == 0)
        return fmt::format("  boundary        geodesic surface of genus {}, area {}\n",
                           vertex.genus, vertex.area);
      return fmt::format("  boundary        geodesic, {}, area {}\n", surface, vertex.area);
    case topology::VertexKind::kIdeal:
      return fmt::format("  cusp            {}; lengths from a horosphere of area {}\n", surface,
                         vertex.area);
    case topology::VertexKind::kFinite:
      break;
  }
  return fmt::format("  finite vertex   {}, solid angle {}\n", surface, vertex.area);
}

/// Volume, boundary, curvature, flat tetrahedra.
void append_numbers_found(std::string& text, const Report& report) {
  text += fmt::format("  volume          {}\n", report.volume);
  for (const VertexReport& vertex : report.vertices) {
    text += vertex_line(vertex);
  }
  text += fmt::format("  largest |K|     {:.3g}\n", report.max_curvature);
  for (const std::size_t t : report.flat_tetrahedra) {
    const auto& angles = report.dihedral_angles[t];
    constexpr const char* kPairs[3] = {"01 and 23", "02 and 13", "03 and 12"};
    const int pair = angles[0] > 3 ? 0 : angles[1] > 3 ? 1 : 2;
    text +=
        fmt::format("  flat            tetrahedron {}: angle pi at its edges {}, 0 at the others\n",
                    t, kPairs[pair]);
  }
}

}  // namespace

std::string certificate_as_text(const Report& report) {
  std::string text;
  if (report.certificate) append_certificate(text, *report.certificate);
  return text;
}

std::string report_as_text(const Subject& subject, const Report& report,
                           const structure::Retriangulation* retriangulation,
                           const structure::ProofText* proof) {
  std::string text = fmt::format("{}: {}\n  {}\n", printable(subject.input),
                                 structure::to_string(report.outcome), report.message);
  if (report.advice != structure::Advice::kNone)
    text += fmt::format("  {}\n", advice_text(report.advice));
  const auto line = [&](std::string_view label, const std::string& value) {
    text += fmt::format("  {:<16}{}\n", label, value);
  };
  line("triangulation", one_line(subject.triangulation));
  if (retriangulation != nullptr) append_path(text, *retriangulation);
  if (proof != nullptr) line("proof", structure::proof_message(*proof));
  if (report.certificate) append_certificate(text, *report.certificate);
  if (const auto theorem = structure::valence_theorem(subject.triangulation, subject.cone_angles))
    line("theorem", structure::message(*theorem));
  if (report.closed_bigon && !report.closed_bigon->decides())
    line("manifold", structure::message(*report.closed_bigon));
  const bool meaningful = report.outcome != structure::Outcome::kInfeasible && !report.certificate;
  if (meaningful || report.outcome == structure::Outcome::kDegenerate)
    append_numbers_found(text, report);
  line("method", fmt::format("{}: {}, {}, {:.3g} s", report.method,
                             counted(std::size_t(report.iterations), "iteration", "iterations"),
                             counted(std::size_t(report.evaluations), "evaluation", "evaluations"),
                             report.seconds));
  if (meaningful || report.outcome == structure::Outcome::kDegenerate) {
    append_edge_table(text, subject, report);
    append_angle_table(text, report);
  }
  if (report.strict_angles) append_strict_angles(text, *report.strict_angles);
  return text;
}

}  // namespace tripus::cli
