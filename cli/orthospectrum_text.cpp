#include <algorithm>

#include <fmt/format.h>
#include <fmt/ostream.h>
#include <fmt/ranges.h>

#include "cli/describe.hpp"
#include "cli/texts.hpp"

namespace tripus::cli {
namespace {

using orthospectrum::Arc;
using orthospectrum::ArcGroup;
using orthospectrum::Estimate;
using orthospectrum::Identity;
using orthospectrum::SpectrumEnd;

/// The faces crossed, each in its own tetrahedron: "0213", or "-" along an edge.
std::string faces_of(const SpectrumAnswer& answer, const Arc& arc) {
  std::string text;
  for (std::uint32_t n = 0; n < arc.face_count; ++n)
    text.push_back(static_cast<char>('0' + answer.spectrum.faces[arc.first_face + n]));
  return text.empty() ? "-" : text;
}

/// "0.0691 +- 0.0137".
std::string estimate_text(const Estimate& estimate) {
  return fmt::format("{:.4g} +- {:.2g}", estimate.value, estimate.uncertainty);
}

std::string identity_text(const Identity& identity) {
  return fmt::format(
      "{:.8g} of {:.8g} counted{}", identity.counted, identity.exact,
      identity.tail ? ", the longer arcs about " + estimate_text(*identity.tail) : std::string());
}

/// How far the number as it is printed may be from all members.
std::string error_bound(const std::string& printed, const structure::Interval& interval) {
  const double shown = std::stod(printed);
  const double error = std::max(shown - interval.lower, interval.upper - shown);
  constexpr double kUp = 1.06;  // more than the rounding to two digits
  return fmt::format("{:.1e}", kUp * error);
}

std::string group_line(const SpectrumAnswer& answer, const ArcGroup& group) {
  std::string marks;
  const auto edges = answer.edges_in(group);
  if (!edges.empty())
    marks = fmt::format("{} {}", edges.size() == 1 ? "edge" : "edges", fmt::join(edges, ", "));
  if (answer.canonical_edges) {
    if (const std::size_t count = answer.canonical_edges_as_long(group.length); count > 0) {
      marks += fmt::format("{}{} of the canonical decomposition", marks.empty() ? "" : "; ",
                           counted(count, "edge", "edges"));
    }
  }
  const std::string length = fmt::format("{:.15g}", group.length);
  if (answer.proved) {
    const auto hull = answer.proved->of(answer.grouping, group);
    marks += (marks.empty() ? "" : "; ") +
             (hull ? "proved to within " + error_bound(length, *hull) : std::string("not proved"));
  }
  std::string line = fmt::format("  {:<20}{:<8}{:<11}{}", length, group.multiplicity,
                                 fmt::format("{}-{}", group.ends[0], group.ends[1]), marks);
  line.erase(line.find_last_not_of(' ') + 1);
  line += '\n';
  if (!answer.words) return line;
  for (const std::size_t n : answer.members(group)) {
    const Arc& arc = answer.spectrum.arcs[n];
    line += fmt::format("      {}.{} {} {}.{}\n", arc.start.tile.tetrahedron, arc.start.tile.vertex,
                        faces_of(answer, arc), arc.end.tile.tetrahedron, arc.end.tile.vertex);
  }
  return line;
}

}  // namespace

std::string spectrum_as_text(const SpectrumAnswer& answer) {
  constexpr std::size_t kMostLines = 24;
  const orthospectrum::Spectrum& spectrum = answer.spectrum;
  const auto& groups = answer.grouping.groups;
  std::string text = fmt::format("{}: {}\n", printable(answer.subject.input),
                                 one_line(answer.subject.triangulation));
  const auto line = [&text](std::string_view label, const std::string& value) {
    text += fmt::format("  {:<20}{}\n", label, value);
  };
  if (spectrum.end != SpectrumEnd::kComplete) {
    line(spectrum.end == SpectrumEnd::kTimeLimit ? "time is over" : "interrupted",
         fmt::format("all arcs up to length {:.6g} are there", spectrum.length));
  }
  if (!groups.empty()) text += "  length              arcs    between\n";
  for (std::size_t n = 0; n < std::min(groups.size(), kMostLines); ++n)
    text += group_line(answer, groups[n]);
  if (groups.size() > kMostLines) {
    text += fmt::format("  ... and {} more; --json and --tsv have them all\n",
                        counted(groups.size() - kMostLines, "length", "lengths"));
  }
  line("arcs", fmt::format("{} up to length {:.10g}", spectrum.arc_count, spectrum.length));
  if (answer.proved)
    line("proof",
         answer.proved->proved
             ? "the metric, and the length of each of these arcs; not that there are no others"
             : answer.proved->reason);
  if (const auto shortest = spectrum.sums.shortest())
    line("shortest return", fmt::format("{:.15g}", *shortest));
  const orthospectrum::Identities& identities = answer.identities;
  line("boundary area", identity_text(identities.area));
  line("volume", identity_text(identities.volume));
  if (identities.volume_from_area)
    line("volume by arcs",
         fmt::format("{:.8g} +- {:.2g}, from the arcs and the boundary's genus",
                     identities.volume_from_area->value, identities.volume_from_area->uncertainty));
  if (identities.dimension)
    line("limit set", "dimension about " + estimate_text(*identities.dimension));
  if (identities.return_time[0])
    line("return time", fmt::format("of the normal flow, in the mean {}",
                                    estimate_text(*identities.return_time[0])));
  return text;
}

void write_arc_table(std::ostream& out, const SpectrumAnswer& answer) {
  out << "length\tends\tedge\tstart\tstart_x\tstart_y\tend\tend_x\tend_y\tdisc_radius\tfaces";
  out << (answer.proved ? "\tproved_from\tproved_to\n" : "\n");
  for (const ArcGroup& group : answer.grouping.groups) {
    for (const std::size_t n : answer.members(group)) {
      const Arc& arc = answer.spectrum.arcs[n];
      const std::string edge = arc.edge == orthospectrum::kNoEdge ? "-" : std::to_string(arc.edge);
      fmt::print(out, "{}\t{}-{}\t{}\t{}.{}\t{}\t{}\t{}.{}\t{}\t{}\t{}\t{}", arc.length,
                 group.ends[0], group.ends[1], edge, arc.start.tile.tetrahedron,
                 arc.start.tile.vertex, arc.start.x, arc.start.y, arc.end.tile.tetrahedron,
                 arc.end.tile.vertex, arc.end.x, arc.end.y, orthospectrum::disc_radius(arc.length),
                 faces_of(answer, arc));
      if (answer.proved && n < answer.proved->arcs.size() && answer.proved->arcs[n]) {
        fmt::print(out, "\t{}\t{}", answer.proved->arcs[n]->lower, answer.proved->arcs[n]->upper);
      } else if (answer.proved) {
        out << "\t-\t-";
      }
      out << '\n';
    }
  }
}

}  // namespace tripus::cli
