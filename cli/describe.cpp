#include "cli/describe.hpp"

#include <algorithm>
#include <map>

#include <fmt/ranges.h>

#include "cli/input.hpp"
#include "cli/labels.hpp"
#include "topology/isosig.hpp"
#include "topology/requirements.hpp"
#include "topology/vertex_kinds.hpp"

namespace tripus::cli {
namespace {

/// Faces visited before the search for the signature is given up: some tenths of a second.
constexpr std::size_t kSignatureWorkLimit = 20'000'000;

}  // namespace

Subject make_subject(std::string input, std::string name, topology::Gluings gluings) {
  topology::Triangulation triangulation(std::move(gluings));
  auto isosig = topology::isosig(triangulation.gluings(), kSignatureWorkLimit);
  return {std::move(input), std::move(name), std::move(triangulation), std::move(isosig)};
}

Subject load_subject(const std::string& input) {
  topology::NamedGluings loaded = load_input(input);
  return make_subject(input, std::move(loaded.name), std::move(loaded.gluings));
}

Subject load_solvable_subject(const std::string& input) {
  topology::NamedGluings loaded = load_solvable_input(input);
  return make_subject(input, std::move(loaded.name), std::move(loaded.gluings));
}

Subject load_labelled_subject(const std::string& input) {
  const auto [plain, labels] = split_labels(input);
  topology::NamedGluings loaded = load_labelled_input(plain);
  Subject subject = make_subject(input, std::move(loaded.name), std::move(loaded.gluings));
  subject.cone_angles = std::move(loaded.cone_angles);
  if (!labels.empty())
    assign_cone_angles(subject.cone_angles, subject.triangulation.edge_count(),
                       std::span(&labels, 1), {});
  return subject;
}

std::string objection_to(const topology::Triangulation& triangulation,
                         std::span<const topology::ConeAngle> cone_angles) {
  try {
    topology::require_solvable(triangulation, cone_angles);
    return {};
  } catch (const InvalidInput& error) {
    return error.what();
  }
}

std::string printable(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f) {
      out += fmt::format("\\x{:02x}", byte);
    } else {
      out += c;
    }
  }
  return out;
}

std::string signature_text(const Subject& subject) {
  constexpr std::size_t kMostShown = 2000;  // some 400 tetrahedra
  constexpr std::size_t kBeginning = 60;
  if (!subject.isosig) return "not computed: it would take too long";
  if (subject.isosig->size() <= kMostShown) return *subject.isosig;
  return fmt::format("{}... ({} characters; --json gives it whole)",
                     subject.isosig->substr(0, kBeginning), subject.isosig->size());
}

std::string counted(std::size_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string_view link_kind(const topology::VertexLink& link) {
  if (link.euler_characteristic > 0) return "finite";
  return link.euler_characteristic == 0 ? "cusp" : "geodesic";
}

void append_subject(JsonText& out, const Subject& subject) {
  const topology::Triangulation& m = subject.triangulation;
  if (!subject.name.empty()) {
    append(out, ", \"name\": ");
    append_string(out, subject.name);
  }
  append(out, ", \"isosig\": ");
  if (subject.isosig) {
    append_string(out, *subject.isosig);
  } else {
    append(out, "null");
  }
  auto to = std::back_inserter(out);
  fmt::format_to(to, ", \"tetrahedron_count\": {}, \"edge_count\": {}, \"orientable\": {}",
                 m.tetrahedron_count(), m.edge_count(), m.is_orientable());
  append(out, ", \"edge_valences\": [");
  for (std::size_t e = 0; e < m.edge_count(); ++e)
    fmt::format_to(to, "{}{}", e == 0 ? "" : ", ", m.valence(e));
  out.push_back(']');
}

void append_vertices(JsonText& out, const topology::Triangulation& m) {
  append(out, ", \"vertices\": [");
  for (std::size_t v = 0; v < m.vertex_count(); ++v) {
    const topology::VertexLink& link = m.link(v);
    auto to = std::back_inserter(out);
    fmt::format_to(to, "{}{{\"link_euler_characteristic\": {}, ", v == 0 ? "" : ", ",
                   link.euler_characteristic);
    if (link.orientable) fmt::format_to(to, "\"genus\": {}, ", link.genus());
    fmt::format_to(to, "\"link_orientable\": {}, \"kind\": \"{}\", \"triangle_count\": {}}}",
                   link.orientable, link_kind(link), link.triangle_count);
  }
  out.push_back(']');
}

void append_cone_orders(JsonText& out, const Subject& subject) {
  if (subject.cone_angles.empty()) return;
  append(out, ", \"cone_orders\": ");
  append_array(out, subject.cone_angles, [](JsonText& to, const topology::ConeAngle& k) {
    const std::string order = k.order_text();
    const bool fraction = order.find('/') != std::string::npos;
    append(to, fraction ? "\"" + order + "\"" : order);
  });
}

void append_edge_classes(JsonText& out, const topology::Triangulation& triangulation) {
  append(out, "\"edge_classes\": [");
  auto to = std::back_inserter(out);
  for (std::size_t t = 0; t < triangulation.tetrahedron_count(); ++t) {
    const auto c = triangulation.edge_classes().subspan(6 * t, 6);
    fmt::format_to(to, "{}[{}, {}, {}, {}, {}, {}]", t == 0 ? "" : ", ", c[0], c[1], c[2], c[3],
                   c[4], c[5]);
  }
  out.push_back(']');
}

std::string shortened(const std::vector<std::string>& items, std::size_t limit) {
  if (items.size() <= limit) return fmt::format("{}", fmt::join(items, ", "));
  return fmt::format("{}, ... ({} in all)",
                     fmt::join(items.begin(), items.begin() + std::ptrdiff_t(limit), ", "),
                     items.size());
}

std::string one_line(const topology::Triangulation& m) {
  std::map<std::string, std::size_t> links;
  for (std::size_t v = 0; v < m.vertex_count(); ++v) {
    const auto& link = m.link(v);
    const std::string_view kind = link_kind(link);
    std::string name(kind);
    if (!link.orientable) {
      name = topology::surface_name(link).substr(2);
    } else if (kind == "geodesic") {
      name = fmt::format("genus {}", link.genus());
    }
    ++links[name];
  }
  std::vector<std::string> boundary;
  boundary.reserve(links.size());
  for (const auto& [name, count] : links)
    boundary.push_back(count == 1 ? name : fmt::format("{} x {}", count, name));
  return fmt::format(
      "{}, {}, {}; vertex links: {}", counted(m.tetrahedron_count(), "tetrahedron", "tetrahedra"),
      counted(m.edge_count(), "edge class", "edge classes"),
      m.is_orientable() ? "orientable" : "non-orientable", fmt::join(boundary, ", "));
}

}  // namespace tripus::cli
