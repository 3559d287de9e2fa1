// tripus info: what a triangulation is.
#include <fmt/format.h>

#include "cli/answer.hpp"
#include "cli/describe.hpp"
#include "cli/help.hpp"
#include "cli/interrupt.hpp"
#include "cli/verb.hpp"
#include "topology/homology.hpp"

namespace tripus::cli {
namespace {

std::string as_json(const Subject& subject) {
  const topology::Triangulation& m = subject.triangulation;
  JsonText out;
  append_header(out, subject.input);
  append_subject(out, subject);
  append_oriented(out, subject);
  fmt::format_to(std::back_inserter(out), ", \"vertex_count\": {}, \"component_count\": {}",
                 m.vertex_count(), m.component_count());
  append_vertices(out, m);
  append_cone_orders(out, subject);
  append(out, ", \"H1\": ");
  append_string(out, topology::to_string(topology::first_homology(m)));
  append(out, ", ");
  append_edge_classes(out, m);
  const std::string why_not = objection_to(m, subject.cone_angles);
  append(out, ", \"solvable\": ");
  append(out, why_not.empty() ? "true" : "false");
  append(out, ", \"message\": ");
  append_string(out, why_not.empty() ? one_line(m) + "." : why_not);
  out.push_back('}');
  return fmt::to_string(out);
}

std::string as_text(const Subject& subject) {
  const topology::Triangulation& m = subject.triangulation;
  std::string text = fmt::format("{}{}\n", printable(subject.input),
                                 subject.name.empty() || subject.name == subject.input
                                     ? ""
                                     : fmt::format(" ({})", printable(subject.name)));
  const auto line = [&](std::string_view label, const std::string& value) {
    text += fmt::format("  {:<14}{}\n", label, value);
  };
  line("signature", signature_text(subject.isosig));
  if (subject.oriented_isosig) line("oriented", signature_text(subject.oriented_isosig));
  line("tetrahedra", std::to_string(m.tetrahedron_count()));
  std::vector<std::string> valences;
  for (std::size_t e = 0; e < m.edge_count(); ++e) valences.push_back(std::to_string(m.valence(e)));
  line("edge classes", fmt::format("{}, of valence {}", m.edge_count(), shortened(valences)));
  std::vector<std::string> links;
  for (std::size_t v = 0; v < m.vertex_count(); ++v) {
    const auto& link = m.link(v);
    links.push_back(link.orientable ? fmt::format("genus {} ({})", link.genus(), link_kind(link))
                                    : fmt::format("Euler characteristic {}, non-orientable ({})",
                                                  link.euler_characteristic, link_kind(link)));
  }
  line("vertex links", shortened(links));
  if (!subject.cone_angles.empty()) {
    std::vector<std::string> orders;
    for (const topology::ConeAngle& k : subject.cone_angles) orders.push_back(k.order_text());
    line("cone orders", shortened(orders));
  }
  line("orientable", m.is_orientable() ? "yes" : "no");
  if (!m.is_connected()) line("components", std::to_string(m.component_count()));
  line("H1", topology::to_string(topology::first_homology(m)));
  const std::string why_not = objection_to(m, subject.cone_angles);
  if (!why_not.empty()) line("not solvable", why_not);
  return text;
}

void add_info(CLI::App* verb, Command& chosen) {
  auto options = std::make_shared<CommonOptions>();
  add_common_options(*verb, *options);
  verb->footer(std::string(kInputHelp) +
               "\nExit status: 0 done, 1 interrupted, 2 bad usage or bad input, 3 a failure of the "
               "program itself.");
  verb->final_callback([options, &chosen] {
    chosen = [options] {
      return answer_inputs(*options, [options](const std::string& input) {
        const Subject subject = load_labelled_subject(input, Balls::kAllowed, interruptible());
        return Reply{options->json ? as_json(subject) : as_text(subject), kSuccess};
      });
    };
  });
}

}  // namespace

namespace registered_verbs {

std::span<const Verb> info() {
  static constexpr Verb kRows[] = {
      {"info", "what a triangulation is: edge classes, links, homology, signature", add_info, 1}};
  return kRows;
}

}  // namespace registered_verbs
}  // namespace tripus::cli
