#include "manifold/diagram_table.hpp"

#include <algorithm>
#include <charconv>
#include <map>
#include <utility>

#include "base/error.hpp"
#include "canonical/canonize.hpp"
#include "structure/proof/prove_report.hpp"
#include "structure/retriangulate.hpp"
#include "structure/solve.hpp"
#include "topology/diagrams/read_diagram.hpp"
#include "topology/diagrams/small_exterior.hpp"
#include "topology/homology.hpp"
#include "topology/isosig.hpp"

namespace tripus {
namespace {

using topology::Triangulation;

constexpr const char* kHeader =
    "name\tcrossings\tboundary\thomology\tisosig\ttetrahedra\thyperbolic\tproved\tvolume\t"
    "signature\toriented_signature\tisometries\treversing\tgroup\tsame_as";
constexpr std::size_t kColumns = 15;

std::string boundary_of(const Triangulation& triangulation) {
  std::vector<int> genera;
  for (std::size_t v = 0; v < triangulation.vertex_count(); ++v)
    genera.push_back(triangulation.link(v).genus());
  std::ranges::sort(genera, std::greater<>());
  return fmt::format("{}", fmt::join(genera, "+"));
}

void set_triangulation(DiagramRow& row, const Triangulation& triangulation) {
  row.isosig = topology::full_isosig(triangulation.gluings()).oriented();
  row.tetrahedra = triangulation.tetrahedron_count();
}

void set_metric(DiagramRow& row, const Triangulation& triangulation,
                const structure::Report& report, const Context& context) {
  set_triangulation(row, triangulation);
  row.hyperbolic = true;
  row.volume = report.volume;
  row.proved = structure::prove_report(triangulation, report, {}, context).proved;
}

void set_canonical(DiagramRow& row, const canonical::CanonicalManifold& manifold) {
  row.signature = manifold.signature.unoriented;
  row.oriented_signature = manifold.signature.oriented;
  row.isometries = manifold.isometries.order;
  row.reversing = manifold.isometries.order - manifold.isometries.orientation_preserving;
  row.group = manifold.isometries.name;
}

std::string number(const std::optional<double>& value) {
  return value ? fmt::format("{}", *value) : "";
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t end = std::min(text.find(separator, from), text.size());
    parts.emplace_back(text.substr(from, end - from));
    from = end + 1;
  }
  return parts;
}

template <class Number>
Number parsed(const std::string& text, std::size_t line) {
  Number value{};
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc() || end != text.data() + text.size())
    throw InvalidInput(fmt::format("line {}: {} is no number", line, quoted(text)));
  return value;
}

DiagramRow parse_row(const std::vector<std::string>& cells, std::size_t line) {
  DiagramRow row;
  row.name = cells[0];
  row.crossings = parsed<std::size_t>(cells[1], line);
  row.boundary = cells[2];
  row.homology = cells[3];
  row.isosig = cells[4];
  row.tetrahedra = parsed<std::size_t>(cells[5], line);
  if (!cells[6].empty()) row.hyperbolic = cells[6] == "yes";
  row.proved = cells[7] == "yes";
  if (!cells[8].empty()) row.volume = parsed<double>(cells[8], line);
  row.signature = cells[9];
  row.oriented_signature = cells[10];
  if (!cells[11].empty()) row.isometries = parsed<std::size_t>(cells[11], line);
  if (!cells[12].empty()) row.reversing = parsed<std::size_t>(cells[12], line);
  row.group = cells[13];
  if (!cells[14].empty()) row.same_as = split(cells[14], ',');
  return row;
}

}  // namespace

DiagramRow diagram_row(const topology::TabledDiagram& diagram, const Context& context) {
  const StopFlag stop(context);
  topology::SimplifyOptions simplify;
  simplify.stop_requested = stop.get();
  const Triangulation small(
      topology::small_exterior({.name = {}, .diagram = diagram.diagram}, simplify).gluings);
  DiagramRow row;
  row.name = diagram.name;
  row.crossings = diagram.crossings;
  row.boundary = boundary_of(small);
  row.homology = to_string(topology::first_homology(small));
  set_triangulation(row, small);
  structure::SolveOptions solve;
  solve.stop_requested = stop.get();
  solve.evidence = false;
  canonical::CanonizeOptions options;
  options.solve = solve;
  const canonical::CanonizeAnswer answer = canonical::canonize(small, options);
  const structure::Report report = structure::solve(small, solve);
  // The canonical decomposition may be subdivided further than the least triangulation is.
  if (report.outcome == structure::Outcome::kGeometric)
    set_metric(row, small, report, context);
  else if (answer.manifold)
    set_metric(row, answer.manifold->triangulation, answer.manifold->report, context);
  if (!answer.manifold) return row;
  set_canonical(row, *answer.manifold);
  return row;
}

void mark_same(std::vector<DiagramRow>& rows) {
  std::map<std::string, std::vector<const DiagramRow*>> groups;
  for (const DiagramRow& row : rows)
    if (!row.signature.empty()) groups[row.signature].push_back(&row);
  std::vector<std::vector<std::string>> same;
  for (const DiagramRow& row : rows) {
    same.emplace_back();
    if (!row.signature.empty())
      for (const DiagramRow* other : groups[row.signature])
        if (other != &row) same.back().push_back(other->name);
  }
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].same_as = std::move(same[i]);
}

std::string to_tsv(const std::vector<DiagramRow>& rows) {
  std::string text = std::string(kHeader) + "\n";
  const auto count = [](std::size_t n, bool known) { return known ? std::to_string(n) : ""; };
  for (const DiagramRow& row : rows)
    text += fmt::format("{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\n", row.name,
                        row.crossings, row.boundary, row.homology, row.isosig, row.tetrahedra,
                        row.hyperbolic ? (*row.hyperbolic ? "yes" : "no") : "",
                        row.proved ? "yes" : "", number(row.volume), row.signature,
                        row.oriented_signature, count(row.isometries, row.isometries > 0),
                        count(row.reversing, row.isometries > 0), row.group,
                        fmt::join(row.same_as, ","));
  return text;
}

std::vector<DiagramRow> parse_diagram_rows(std::string_view text) {
  std::vector<DiagramRow> rows;
  std::size_t line = 0;
  for (const std::string& each : split(text, '\n')) {
    ++line;
    if (each.empty() || each[0] == '#' || each == kHeader) continue;
    const std::vector<std::string> cells = split(each, '\t');
    if (cells.size() != kColumns)
      throw InvalidInput(
          fmt::format("line {}: {} columns, expected {}", line, cells.size(), kColumns));
    rows.push_back(parse_row(cells, line));
  }
  return rows;
}

void append_row(JsonText& out, const DiagramRow& row, const topology::Diagram& diagram) {
  const auto text = [&](std::string_view key, const std::string& value) {
    append(out, fmt::format(", \"{}\": ", key));
    value.empty() ? append(out, "null") : append_string(out, value);
  };
  append(out, "{\"name\": ");
  append_string(out, row.name);
  append(out, ", \"diagram\": ");
  append_array(out, diagram.nodes(), [](JsonText& to, const topology::DiagramNode& node) {
    append(to, fmt::format("[\"{}\", [{}]]", node.kind == topology::NodeKind::kCrossing ? "X" : "V",
                           fmt::join(node.arcs, ", ")));
  });
  append(out, fmt::format(", \"crossings\": {}", row.crossings));
  text("boundary", row.boundary);
  text("homology", row.homology);
  text("isosig", row.isosig);
  append(out, fmt::format(
                  ", \"tetrahedron_count\": {}, \"hyperbolic\": {}, \"proved\": {}", row.tetrahedra,
                  row.hyperbolic ? (*row.hyperbolic ? "true" : "false") : "null", row.proved));
  append(out, ", \"volume\": ");
  row.volume ? append_number(out, *row.volume) : append(out, "null");
  text("signature", row.signature);
  text("oriented_signature", row.oriented_signature);
  append(out, ", \"isometry_group\": ");
  if (row.isometries == 0) {
    append(out, "null");
  } else {
    append(out, fmt::format("{{\"order\": {}, \"orientation_reversing\": {}, \"name\": ",
                            row.isometries, row.reversing));
    append_string(out, row.group);
    out.push_back('}');
  }
  append(out, ", \"same_as\": ");
  append_array(out, row.same_as, [](JsonText& to, const std::string& n) { append_string(to, n); });
  out.push_back('}');
}

}  // namespace tripus
