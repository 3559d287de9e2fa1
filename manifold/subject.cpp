#include "manifold/subject.hpp"

#include <utility>

#include "manifold/load.hpp"
#include "topology/isosig.hpp"

namespace tripus {
Subject make_subject(std::string input, std::string name, topology::Gluings gluings) {
  topology::Triangulation triangulation(std::move(gluings));
  auto isosig = topology::isosig(triangulation.gluings(), kSignatureWorkLimit);
  return {std::move(input), std::move(name), std::move(triangulation), std::move(isosig)};
}

Subject load_subject(const std::string& input, const Context& context) {
  topology::NamedGluings loaded = load_input(input, context);
  return make_subject(input, std::move(loaded.name), std::move(loaded.gluings));
}

Subject load_solvable_subject(const std::string& input, const Context& context) {
  topology::NamedGluings loaded = load_solvable_input(input, context);
  return make_subject(input, std::move(loaded.name), std::move(loaded.gluings));
}

std::string_view link_kind(const topology::VertexLink& link) {
  if (link.euler_characteristic == 2) return "finite";
  if (!link.orientable) return "unsupported";
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

}  // namespace tripus
