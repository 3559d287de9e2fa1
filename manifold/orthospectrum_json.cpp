#include "manifold/orthospectrum_json.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/tolerances.hpp"
#include "manifold/json_text.hpp"

namespace tripus {
namespace {

using orthospectrum::Arc;
using orthospectrum::ArcEnd;
using orthospectrum::ArcGroup;
using orthospectrum::Estimate;
using orthospectrum::Identity;
using orthospectrum::SpectrumEnd;

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
  append_array(out, answer.members(group), [&](JsonText& to, std::size_t n) {
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
  const auto edges = answer.edges_in(group);
  if (edges.empty()) {
    append(out, "null");
  } else {
    fmt::format_to(to, "{}, \"edges\": [{}]", edges.front(), fmt::join(edges, ", "));
  }
  if (answer.canonical_edges) {
    fmt::format_to(to, ", \"canonical_edges\": {}", answer.canonical_edges_as_long(group.length));
  }
  if (answer.proved) {
    append(out, ", \"proved_length\": ");
    if (const auto hull = answer.proved->of(answer.grouping, group)) {
      append_numbers(out, std::array{hull->lower, hull->upper});
    } else {
      append(out, "null");
    }
  }
  if (answer.words) append_words(out, answer, group);
  out.push_back('}');
}

}  // namespace

std::span<const std::size_t> SpectrumAnswer::members(const ArcGroup& group) const {
  return std::span(grouping.order).subspan(group.first, group.multiplicity);
}

std::vector<std::uint32_t> SpectrumAnswer::edges_in(const ArcGroup& group) const {
  std::vector<std::uint32_t> edges;
  for (const std::size_t n : members(group))
    if (const Arc& arc = spectrum.arcs[n]; arc.edge != orthospectrum::kNoEdge)
      edges.push_back(arc.edge);
  std::ranges::sort(edges);
  return edges;
}

std::size_t SpectrumAnswer::canonical_edges_as_long(double length) const {
  return static_cast<std::size_t>(std::ranges::count_if(*canonical_edges, [length](double edge) {
    return std::abs(edge - length) <= tolerance::kSameArcLength;
  }));
}

std::string spectrum_as_json(const SpectrumAnswer& answer) {
  const orthospectrum::Spectrum& spectrum = answer.spectrum;
  JsonText out;
  append_header(out, answer.subject.input);
  append_subject(out, answer.subject);
  append(out, ", \"length\": ");
  append_number(out, spectrum.length);
  fmt::format_to(std::back_inserter(out), ", \"end\": \"{}\", \"arc_count\": {}",
                 end_name(spectrum.end), spectrum.arc_count);
  append_optional(out, "shortest_return_path", spectrum.sums.shortest());
  append(out, ", \"arcs\": ");
  append_array(out, answer.grouping.groups,
               [&](JsonText& to, const ArcGroup& group) { append_group(to, answer, group); });
  if (answer.proved) {
    fmt::format_to(std::back_inserter(out), ", \"proved\": {}", answer.proved->proved);
    if (!answer.proved->proved) {
      append(out, ", \"proof_reason\": ");
      append_string(out, answer.proved->reason);
    }
  }
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

}  // namespace tripus
