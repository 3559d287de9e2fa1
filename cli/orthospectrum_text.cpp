#include "cli/orthospectrum_text.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ostream.h>
#include <fmt/ranges.h>

#include "base/tolerances.hpp"

namespace tripus::cli {
namespace {

using orthospectrum::Arc;
using orthospectrum::ArcEnd;
using orthospectrum::ArcGroup;
using orthospectrum::Estimate;
using orthospectrum::Identity;
using orthospectrum::SpectrumEnd;

std::span<const std::size_t> members(const SpectrumAnswer& answer, const ArcGroup& group) {
  return std::span(answer.grouping.order).subspan(group.first, group.multiplicity);
}

/// The edge classes among the arcs of a group.
std::vector<std::uint32_t> edges_in(const SpectrumAnswer& answer, const ArcGroup& group) {
  std::vector<std::uint32_t> edges;
  for (const std::size_t n : members(answer, group))
    if (const Arc& arc = answer.spectrum.arcs[n]; arc.edge != orthospectrum::kNoEdge)
      edges.push_back(arc.edge);
  std::ranges::sort(edges);
  return edges;
}

/// How many edges of the canonical decomposition have this length.
std::size_t canonical_edges_as_long(const SpectrumAnswer& answer, double length) {
  return static_cast<std::size_t>(std::ranges::count_if(
      *answer.canonical_edges,
      [length](double edge) { return std::abs(edge - length) <= tolerance::kSameArcLength; }));
}

/// The faces crossed, each in its own tetrahedron: "0213", or "-" along an edge.
std::string faces_of(const SpectrumAnswer& answer, const Arc& arc) {
  std::string text;
  for (std::uint32_t n = 0; n < arc.face_count; ++n)
    text.push_back(static_cast<char>('0' + answer.spectrum.faces[arc.first_face + n]));
  return text.empty() ? "-" : text;
}

std::string_view end_name(SpectrumEnd end) {
  switch (end) {
    case SpectrumEnd::kComplete:
      return "complete";
    case SpectrumEnd::kInterrupted:
      return "interrupted";
    case SpectrumEnd::kTimeLimit:
      break;
  }
  return "time-limit";
}

void append_optional(JsonText& out, std::string_view key, const std::optional<double>& value) {
  fmt::format_to(std::back_inserter(out), ", \"{}\": ", key);
  if (value) {
    append_number(out, *value);
  } else {
    append(out, "null");
  }
}

void append_estimate(JsonText& out, std::string_view key, const std::optional<Estimate>& estimate) {
  append_optional(out, key, estimate ? std::optional(estimate->value) : std::nullopt);
  append_optional(out, fmt::format("{}_uncertainty", key),
                  estimate ? std::optional(estimate->uncertainty) : std::nullopt);
}

void append_identity(JsonText& out, std::string_view key, const Identity& identity) {
  fmt::format_to(std::back_inserter(out), ", \"{}\": {{\"counted\": ", key);
  append_number(out, identity.counted);
  append(out, ", \"exact\": ");
  append_number(out, identity.exact);
  append_estimate(out, "tail", identity.tail);
}

void append_end(JsonText& out, const ArcEnd& end) {
  fmt::format_to(std::back_inserter(out),
                 "{{\"tetrahedron\": {}, \"vertex\": {}, \"foot\": ", end.tile.tetrahedron,
                 end.tile.vertex);
  append_numbers(out, std::array{end.x, end.y});
  out.push_back('}');
}

void append_words(JsonText& out, const SpectrumAnswer& answer, const ArcGroup& group) {
  append(out, ", \"words\": ");
  append_array(out, members(answer, group), [&](JsonText& to, std::size_t n) {
    const Arc& arc = answer.spectrum.arcs[n];
    append(to, "{\"start\": ");
    append_end(to, arc.start);
    append(to, ", \"faces\": [");
    for (std::uint32_t k = 0; k < arc.face_count; ++k) {
      fmt::format_to(std::back_inserter(to), "{}{}", k == 0 ? "" : ", ",
                     answer.spectrum.faces[arc.first_face + k]);
    }
    append(to, "], \"end\": ");
    append_end(to, arc.end);
    to.push_back('}');
  });
}

void append_group(JsonText& out, const SpectrumAnswer& answer, const ArcGroup& group) {
  const auto to = std::back_inserter(out);
  append(out, "{\"length\": ");
  append_number(out, group.length);
  fmt::format_to(to, ", \"multiplicity\": {}, \"ends\": [{}, {}], \"edge\": ", group.multiplicity,
                 group.ends[0], group.ends[1]);
  const auto edges = edges_in(answer, group);
  if (edges.empty()) {
    append(out, "null");
  } else {
    fmt::format_to(to, "{}, \"edges\": [{}]", edges.front(), fmt::join(edges, ", "));
  }
  if (answer.canonical_edges) {
    fmt::format_to(to, ", \"canonical_edges\": {}", canonical_edges_as_long(answer, group.length));
  }
  if (answer.words) append_words(out, answer, group);
  out.push_back('}');
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

std::string group_line(const SpectrumAnswer& answer, const ArcGroup& group) {
  std::string marks;
  const auto edges = edges_in(answer, group);
  if (!edges.empty())
    marks = fmt::format("{} {}", edges.size() == 1 ? "edge" : "edges", fmt::join(edges, ", "));
  if (answer.canonical_edges) {
    if (const std::size_t count = canonical_edges_as_long(answer, group.length); count > 0) {
      marks += fmt::format("{}{} of the canonical decomposition", marks.empty() ? "" : "; ",
                           counted(count, "edge", "edges"));
    }
  }
  std::string line = fmt::format("  {:<20.15g}{:<8}{:<11}{}", group.length, group.multiplicity,
                                 fmt::format("{}-{}", group.ends[0], group.ends[1]), marks);
  line.erase(line.find_last_not_of(' ') + 1);
  line += '\n';
  if (!answer.words) return line;
  for (const std::size_t n : members(answer, group)) {
    const Arc& arc = answer.spectrum.arcs[n];
    line += fmt::format("      {}.{} {} {}.{}\n", arc.start.tile.tetrahedron, arc.start.tile.vertex,
                        faces_of(answer, arc), arc.end.tile.tetrahedron, arc.end.tile.vertex);
  }
  return line;
}

}  // namespace

std::string spectrum_as_json(const SpectrumAnswer& answer) {
  const orthospectrum::Spectrum& spectrum = answer.spectrum;
  JsonText out;
  append_header(out, answer.subject.input);
  append_subject(out, answer.subject);
  append(out, ", \"length\": ");
  append_number(out, spectrum.length);
  fmt::format_to(std::back_inserter(out), ", \"end\": \"{}\", \"arc_count\": {}",
                 end_name(spectrum.end), spectrum.arc_count);
  append_optional(
      out, "shortest_return_path",
      spectrum.arcs.empty() ? std::nullopt : std::optional(spectrum.arcs.front().length));
  append(out, ", \"arcs\": ");
  append_array(out, answer.grouping.groups,
               [&](JsonText& to, const ArcGroup& group) { append_group(to, answer, group); });
  append_identity(out, "area", answer.identities.area);
  out.push_back('}');
  append_identity(out, "volume", answer.identities.volume);
  append_estimate(out, "from_area", answer.identities.volume_from_area);
  out.push_back('}');
  append_estimate(out, "dimension", answer.identities.dimension);
  append_estimate(out, "return_time", answer.identities.return_time[0]);
  append_estimate(out, "return_time_square", answer.identities.return_time[1]);
  out.push_back('}');
  return fmt::to_string(out);
}

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
  if (!spectrum.arcs.empty())
    line("shortest return", fmt::format("{:.15g}", spectrum.arcs.front().length));
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
  out << "length\tends\tedge\tstart\tstart_x\tstart_y\tend\tend_x\tend_y\tdisc_radius\tfaces\n";
  for (const ArcGroup& group : answer.grouping.groups) {
    for (const std::size_t n : members(answer, group)) {
      const Arc& arc = answer.spectrum.arcs[n];
      const std::string edge = arc.edge == orthospectrum::kNoEdge ? "-" : std::to_string(arc.edge);
      fmt::print(out, "{}\t{}-{}\t{}\t{}.{}\t{}\t{}\t{}.{}\t{}\t{}\t{}\t{}\n", arc.length,
                 group.ends[0], group.ends[1], edge, arc.start.tile.tetrahedron,
                 arc.start.tile.vertex, arc.start.x, arc.start.y, arc.end.tile.tetrahedron,
                 arc.end.tile.vertex, arc.end.x, arc.end.y, orthospectrum::disc_radius(arc.length),
                 faces_of(answer, arc));
    }
  }
}

}  // namespace tripus::cli
