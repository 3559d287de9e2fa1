#include "manifold/report_json.hpp"

#include <fmt/format.h>

#include "structure/valence_theorem.hpp"

namespace tripus {
namespace {

using structure::Report;
using structure::VertexReport;

void append_vertex(JsonText& out, const VertexReport& vertex) {
  fmt::format_to(std::back_inserter(out),
                 "{{\"link_euler_characteristic\": {}, \"genus\": {}, \"kind\": \"{}\"",
                 vertex.link_euler_characteristic,
                 vertex.orientable ? std::to_string(vertex.genus) : "null",
                 topology::to_string(vertex.kind));
  if (vertex.cone_points > 0)
    append_number_key(out, "orbifold_euler_characteristic", vertex.orbifold_euler_characteristic);
  append_number_key(out, "area", vertex.area);
  out.push_back('}');
}

void append_retriangulation(JsonText& out, const structure::Retriangulation& found) {
  append(out, ", \"retriangulation\": {\"from\": ");
  append_string(out, found.start);
  fmt::format_to(std::back_inserter(out),
                 ", \"tried\": {}, \"ended\": \"{}\", \"path\": ", found.tried,
                 structure::to_string(found.end));
  append_array(out, found.path, [](JsonText& to, const topology::Move& move) {
    append_string(to, topology::to_string(move));
  });
  if (!found.simplified.empty()) {
    append(out, ", \"simplified\": ");
    append_string(out, found.simplified);
  }
  append(out, ", \"volumes\": ");
  append_array(out, found.volumes, [](JsonText& to, const structure::OtherVolume& other) {
    append(to, "{\"isosig\": ");
    append_string(to, other.isosig);
    fmt::format_to(std::back_inserter(to), ", \"outcome\": \"{}\"",
                   structure::to_string(other.outcome));
    append_number_key(to, "volume", other.volume);
    to.push_back('}');
  });
  out.push_back('}');
}

/// What is known about the manifold: null under "hyperbolic" is a hint.
void append_closed_bigon(JsonText& out, const structure::ClosedBigon& bigon) {
  fmt::format_to(std::back_inserter(out),
                 ", \"manifold\": {{\"hyperbolic\": {}, \"by\": \"closed bigon\", \"surface\": "
                 "\"{}\", \"consequence\": \"{}\", \"edge\": {}, \"opposite\": {}, \"message\": ",
                 bigon.decides() ? "false" : "null", structure::surface_name(bigon),
                 structure::to_string(bigon.consequence), bigon.edge, bigon.opposite);
  append_string(out, structure::message(bigon));
  out.push_back('}');
}

void append_valence_theorem(JsonText& out, const structure::ValenceTheorem& theorem) {
  fmt::format_to(std::back_inserter(out),
                 ", \"valence_theorem\": {{\"claim\": \"{}\", \"least_valence\": {}, \"source\": "
                 "\"{}\", \"message\": ",
                 structure::to_string(theorem.claim()), theorem.least_valence, theorem.source());
  append_string(out, structure::message(theorem));
  out.push_back('}');
}

}  // namespace

std::string report_as_json(const Subject& subject, const Report& report,
                           const structure::Retriangulation* retriangulation,
                           const structure::ProofText* proof) {
  JsonText out;
  append_header(out, subject.input);
  append_subject(out, subject);
  append(out, ", \"vertices\": ");
  append_array(out, report.vertices, append_vertex);
  append_cone_orders(out, subject);
  fmt::format_to(std::back_inserter(out),
                 ", \"outcome\": \"{}\", \"method\": \"{}\", \"iterations\": {}, "
                 "\"evaluations\": {}",
                 structure::to_string(report.outcome), report.method, report.iterations,
                 report.evaluations);
  append_number_key(out, "seconds", report.seconds);
  append_number_key(out, "max_curvature", report.max_curvature);
  append_number_key(out, "volume", report.volume);
  append(out, ", \"edge_lengths\": ");
  append_numbers(out, report.edge_lengths);
  append(out, ", \"dihedral_angles\": ");
  append_array(out, report.dihedral_angles,
               [](JsonText& to, const auto& angles) { append_numbers(to, angles); });
  append(out, ", ");
  append_edge_classes(out, subject.triangulation);
  append(out, ", \"flat_tetrahedra\": ");
  append_array(out, report.flat_tetrahedra, [](JsonText& to, std::size_t t) {
    fmt::format_to(std::back_inserter(to), "{}", t);
  });
  append(out, ", \"certificate\": ");
  append(out, report.certificate ? structure::to_json(*report.certificate) : "null");
  if (report.strict_angles) {
    append(out, ", \"angle_structure\": ");
    append(out, structure::to_json(*report.strict_angles));
  }
  if (report.closed_bigon) append_closed_bigon(out, *report.closed_bigon);
  if (const auto theorem = structure::valence_theorem(subject.triangulation, subject.cone_angles))
    append_valence_theorem(out, *theorem);
  if (retriangulation != nullptr) append_retriangulation(out, *retriangulation);
  if (proof != nullptr) append(out, ", \"proof\": " + structure::to_json(*proof));
  if (report.advice != structure::Advice::kNone) {
    append(out, ", \"advice\": ");
    append_string(out, structure::to_string(report.advice));
  }
  append(out, ", \"message\": ");
  append_string(out, report.message);
  out.push_back('}');
  return fmt::to_string(out);
}

}  // namespace tripus
