// The short record of an answer: a line of fields, for lists of millions.
#include "cli/solve_record.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "base/error.hpp"
#include "cli/describe.hpp"
#include "energies/co_volume.hpp"
#include "solver/extreme_eigenvalues.hpp"
#include "topology/isosig.hpp"

namespace tripus::cli {
namespace {

std::string number(double x) { return fmt::format("{}", x); }

/// What a metric says, or nothing.
template <class F>
std::string of_metric(const Solved& solved, const F& text) {
  return solved.is_geometric() ? text(solved.report) : std::string();
}

/// The least or largest of the angles, in radians.
std::string angle(const Solved& solved, bool largest) {
  return of_metric(solved, [&](const structure::Report& report) {
    double found = largest ? 0 : std::numeric_limits<double>::infinity();
    for (const auto& angles : report.dihedral_angles)
      for (const double theta : angles)
        found = largest ? std::max(found, theta) : std::min(found, theta);
    return number(found);
  });
}

/// "g2", "g2+T": the kinds of the vertex links.
std::string links(const Solved& solved) {
  std::vector<std::string> names;
  for (const structure::VertexReport& vertex : solved.report.vertices) {
    if (!vertex.orientable)
      names.push_back(vertex.link_euler_characteristic == 0
                          ? "K"
                          : fmt::format("n{}", 2 - vertex.link_euler_characteristic));
    else
      names.push_back(vertex.genus == 1 ? "T" : fmt::format("g{}", vertex.genus));
  }
  std::ranges::sort(names);
  return fmt::format("{}", fmt::join(names, "+"));
}

/// Largest over least eigenvalue of the Hessian at the metric. With cusps it has a kernel.
std::string condition(const Solved& solved) {
  return of_metric(solved, [&](const structure::Report& report) -> std::string {
    energies::CoVolume energy(solved.subject.triangulation, solved.subject.cone_angles);
    if (!energy.is_hyperideal()) return {};
    std::vector<double> gradient(report.edge_lengths.size());
    if (!energy.evaluate(report.edge_lengths, gradient, {.second_derivatives = true})) return {};
    const double ratio = solver::extreme_eigenvalues(energy).condition();
    return std::isfinite(ratio) ? fmt::format("{:.6g}", ratio) : std::string();
  });
}

std::string certificate(const Solved& solved) {
  const auto& found = solved.report.certificate;
  return found ? std::string(structure::to_string(found->kind)) : std::string();
}

constexpr RecordField kFields[] = {
    {"input", "the INPUT", [](const Solved& s) { return printable(s.subject.input); }},
    {"signature", "of the triangulation that was solved, without labels",
     [](const Solved& s) { return topology::isosig(s.subject.triangulation.gluings()); }},
    {"tetrahedra", "their number",
     [](const Solved& s) { return std::to_string(s.subject.triangulation.tetrahedron_count()); }},
    {"edges", "the number of edge classes",
     [](const Solved& s) { return std::to_string(s.subject.triangulation.edge_count()); }},
    {"links", "of the vertices: g2, g2+g3, g2+T", [](const Solved& s) { return links(s); }},
    {"outcome", "geometric, degenerate, infeasible, unresolved; or refused",
     [](const Solved& s) { return std::string(structure::to_string(s.report.outcome)); }},
    {"certificate", "its kind, of what is not geometric: none, semi",
     [](const Solved& s) { return certificate(s); }},
    {"volume", "of the metric, as all that follow",
     [](const Solved& s) {
       return of_metric(s, [](const auto& report) { return number(report.volume); });
     }},
    {"curvature", "max|K|, radians",
     [](const Solved& s) {
       return of_metric(s, [](const auto& report) { return number(report.max_curvature); });
     }},
    {"shortest", "least edge length",
     [](const Solved& s) {
       return of_metric(s, [](const auto& report) {
         return number(*std::ranges::min_element(report.edge_lengths));
       });
     }},
    {"longest", "largest edge length",
     [](const Solved& s) {
       return of_metric(s, [](const auto& report) {
         return number(*std::ranges::max_element(report.edge_lengths));
       });
     }},
    {"least-angle", "least dihedral angle, radians",
     [](const Solved& s) { return angle(s, false); }},
    {"largest-angle", "largest dihedral angle, radians",
     [](const Solved& s) { return angle(s, true); }},
    {"search", "how that for other triangulations ended (--retriangulate)",
     [](const Solved& s) {
       return s.search() == nullptr ? std::string()
                                    : std::string(structure::to_string(s.search()->end));
     }},
    {"condition", "condition number of the Hessian; not with cusps",
     [](const Solved& s) { return condition(s); }},
};

const RecordField& find_field(std::string_view name) {
  for (const RecordField& field : kFields)
    if (field.name == name) return field;
  std::vector<std::string_view> names;
  for (const RecordField& field : kFields) names.push_back(field.name);
  throw InvalidInput(fmt::format("--fields: there is no field {}; there are {}",
                                 tripus::quoted(std::string(name)), fmt::join(names, ", ")));
}

template <class Text>
std::string record_line(const std::vector<const RecordField*>& fields, const Text& text) {
  std::string result;
  for (const RecordField* field : fields) {
    if (field != fields.front()) result += '\t';
    result += text(*field);
  }
  return result + '\n';
}

}  // namespace

std::vector<const RecordField*> parse_fields(std::string_view list) {
  std::vector<const RecordField*> fields;
  for (std::size_t from = 0; from <= list.size();) {
    const std::size_t comma = std::min(list.find(',', from), list.size());
    const RecordField& field = find_field(list.substr(from, comma - from));
    if (std::ranges::find(fields, &field) != fields.end())
      throw InvalidInput(
          fmt::format("--fields: {} comes twice", tripus::quoted(std::string(field.name))));
    fields.push_back(&field);
    from = comma + 1;
  }
  return fields;
}

std::string record_header(const std::vector<const RecordField*>& fields) {
  return record_line(fields, [](const RecordField& field) { return std::string(field.name); });
}

std::string record(const std::vector<const RecordField*>& fields, const Solved& solved) {
  return record_line(fields, [&](const RecordField& field) { return field.text(solved); });
}

std::string failed_record(const std::vector<const RecordField*>& fields, const std::string& input,
                          const std::exception& error) {
  const bool refused = dynamic_cast<const InvalidInput*>(&error) != nullptr;
  return record_line(fields, [&](const RecordField& field) -> std::string {
    if (field.name == "input") return printable(input);
    if (field.name != "outcome") return {};
    return refused ? "refused" : std::string(structure::to_string(structure::Outcome::kUnresolved));
  });
}

std::string fields_help() {
  std::string text;
  for (const RecordField& field : kFields)
    text += fmt::format("  {:<14} {}\n", field.name, field.meaning);
  return text;
}

}  // namespace tripus::cli
