#include "manifold/subject.hpp"

#include <utility>

#include "manifold/labels.hpp"
#include "manifold/prepared.hpp"
#include "topology/isosig.hpp"

namespace tripus {

Subject make_subject(std::string input, topology::NamedGluings loaded) {
  Subject subject{.input = std::move(input),
                  .name = std::move(loaded.name),
                  .triangulation = topology::Triangulation(std::move(loaded.gluings)),
                  .isosig = {}};
  subject.orientation_known = loaded.orientation_known;
  subject.notes = std::move(loaded.notes);
  subject.cone_angles = std::move(loaded.cone_angles);
  auto signature = topology::full_isosig(subject.triangulation.gluings(), kSignatureWorkLimit);
  if (!signature) return subject;
  // Where the mirror image is the same triangulation there is nothing to know.
  if (signature->is_amphicheiral) subject.orientation_known = true;
  if (subject.orientation_known && signature->sign != 0)
    subject.oriented_isosig = signature->oriented();
  subject.isosig = std::move(signature->isosig);
  return subject;
}

Subject make_subject(const Subject& subject, topology::Gluings gluings) {
  return make_subject(subject.input, {.name = subject.name,
                                      .gluings = std::move(gluings),
                                      .notes = subject.notes,
                                      .orientation_known = subject.orientation_known});
}

Subject load_subject(const std::string& input, const Context& context) {
  return make_subject(input, load_input(input, context));
}

Subject load_manifold_subject(const std::string& input, const Context& context) {
  return make_subject(input, load_manifold_input(input, context));
}

Subject load_solvable_subject(const std::string& input, const Context& context,
                              const Requirement& require) {
  return make_subject(input, load_solvable_input(input, context, require));
}

Subject load_labelled_subject(const std::string& input, Balls balls, const Context& context) {
  return make_subject(input, load_labelled_input(input, balls, context));
}

Subject load_ideal_subject(const std::string& input, Balls balls, const Context& context,
                           const LabelledRequirement& require) {
  Subject subject = load_labelled_subject(input, balls, context);
  if (subject.cone_angles.empty()) {
    topology::NamedGluings ideal{.name = subject.name,
                                 .gluings = subject.triangulation.gluings(),
                                 .notes = subject.notes,
                                 .orientation_known = subject.orientation_known};
    make_ideal(ideal, topology::FiniteVertices::kRemove, context.stop);
    if (ideal.notes.size() > subject.notes.size()) {
      if (context.note) context.note(quoted(input) + ": " + ideal.notes.back());
      subject = make_subject(input, std::move(ideal));
    }
  }
  const std::string source = input == "-" ? "standard input" : quoted(input);
  try {
    require(subject.triangulation, subject.cone_angles);
  } catch (const Unsupported& error) {
    throw Unsupported(source + ": " + error.what());
  } catch (const InvalidInput& error) {
    throw InvalidInput(source + ": " + error.what());
  }
  return subject;
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
  if (subject.notes.empty()) return;
  append(out, ", \"notes\": ");
  append_array(out, subject.notes,
               [](JsonText& text, const std::string& note) { append_string(text, note); });
}

void append_oriented(JsonText& out, const Subject& subject) {
  append(out, ", \"oriented_isosig\": ");
  if (subject.oriented_isosig) {
    append_string(out, *subject.oriented_isosig);
  } else {
    append(out, "null");
  }
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

}  // namespace tripus
