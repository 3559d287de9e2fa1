// tripus table: the tables of knots, links, theta curves and handlebody-knots.
#include <algorithm>
#include <iterator>
#include <memory>
#include <mutex>
#include <optional>

#include <fmt/format.h>

#include "base/output_file.hpp"
#include "base/svg_text.hpp"
#include "cli/failure.hpp"
#include "cli/interrupt.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/verb.hpp"
#include "drawing/drawing.hpp"
#include "manifold/diagram_table.hpp"

namespace tripus::cli {
namespace {

using topology::DiagramTable;

constexpr const char* kTableHelp =
    "TABLE is one of\n"
    "  knots             the prime knots up to 9 crossings, with Rolfsen's names\n"
    "  links             the prime links up to 9 crossings, with Thistlethwaite's names\n"
    "  theta-curves      theta curves and handcuff graphs up to 6 crossings, Moriuchi's names\n"
    "  handlebody-knots  genus 2, up to 7 crossings, names of Ishii, Kishimoto, Moriuchi and\n"
    "                    Suzuki, and of the table for 7 crossings\n"
    "  all               all of these\n"
    "A row: boundary, H1, tetrahedra, volume (* proved), isometries (those that reverse the\n"
    "orientation after the +), and others with the same exterior, orientation aside. \"not\n"
    "hyperbolic\": by a surface or the fundamental group, as `tripus hyperbolic` shows. \"?\": no\n"
    "metric was found, which proves nothing by itself. Files are replaced, whole or not at all.\n"
    "\n"
    "Exit status: 0 printed, 1 interrupted, 2 bad usage or bad input, 3 a failure of the program "
    "itself.";

struct TableCommand {
  std::string table, tsv, database, page;
  std::vector<std::string> names;
  bool json = false, compute = false, quiet = false;
};

std::string line_of(const DiagramRow& row) {
  std::string text = fmt::format("{:<13} {:<7} {:<9} {:>2} tetrahedra  ", row.name,
                                 "g " + row.boundary, row.homology, row.tetrahedra);
  text += row.volume ? fmt::format("volume {:<17.14g}{}", *row.volume, row.proved ? "*" : " ")
                     : fmt::format("{:<25}", row.hyperbolic == false ? "not hyperbolic" : "?");
  if (row.isometries > 0)
    text += fmt::format(" isometries {} + {}", row.isometries - row.reversing, row.reversing);
  if (!row.same_as.empty()) text += fmt::format("  = {}", fmt::join(row.same_as, ", "));
  text.erase(text.find_last_not_of(' ') + 1);
  return text + "\n";
}

/// A page with a picture of every diagram.
std::string page_of(const std::string& table, const std::vector<DiagramRow>& rows) {
  std::string text = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<title>{0}</title>\n"
      "<style>body{{font:15px/1.4 sans-serif;margin:2em}}"
      "main{{display:grid;grid-template-columns:repeat(auto-fill,minmax(230px,1fr));gap:1.5em}}"
      "figure{{margin:0}}figcaption b{{font-size:1.1em}}svg{{max-width:100%;height:auto}}"
      "</style>\n<h1>{0}</h1>\n<main>\n",
      table);
  for (const DiagramRow& row : rows) {
    const topology::TabledDiagram* diagram = topology::find_diagram(row.name);
    text += "<figure>\n" + drawing::to_svg(diagram->diagram, {.size = 200, .title = row.name}) +
            fmt::format(
                "<figcaption><b>{}</b><br>{}<br>H1 {}, {} tetrahedra", escaped_xml(row.name),
                row.volume
                    ? fmt::format("volume {:.12g}{}", *row.volume, row.proved ? ", proved" : "")
                    : std::string(row.hyperbolic == false ? "not hyperbolic" : "no metric found"),
                row.homology, row.tetrahedra);
    if (row.isometries > 0)
      text +=
          fmt::format("<br>isometries: {}{}", row.group, row.reversing > 0 ? ", amphicheiral" : "");
    if (!row.same_as.empty())
      text += fmt::format("<br>same exterior: {}", fmt::join(row.same_as, ", "));
    text += "</figcaption>\n</figure>\n";
  }
  return text + "</main>\n</html>\n";
}

std::string as_json(const std::vector<DiagramRow>& rows) {
  JsonText out;
  append_header(out, "table");
  append(out, ", \"rows\": ");
  append_array(out, rows, [](JsonText& to, const DiagramRow& row) {
    append(to, "\n");
    append_row(to, row, topology::find_diagram(row.name)->diagram);
  });
  append(out, "}\n");
  return fmt::to_string(out);
}

/// Others with the same exterior are looked for in all the tables that are computed.
std::vector<DiagramRow> computed(const std::vector<DiagramTable>& tables, bool quiet) {
  std::vector<DiagramRow> rows;
  Progress progress(!quiet);
  for (const DiagramTable table : tables)
    for (const topology::TabledDiagram& diagram : topology::table_of(table)) {
      if (interrupt_requested()) break;
      if (progress.due()) progress.show(diagram.name);
      rows.push_back(diagram_row(diagram, interruptible()));
    }
  mark_same(rows);
  return rows;
}

std::vector<DiagramRow> shipped(const std::vector<DiagramTable>& tables) {
  std::vector<DiagramRow> rows;
  for (const DiagramTable table : tables)
    rows.insert(rows.end(), shipped_rows(table).begin(), shipped_rows(table).end());
  return rows;
}

std::vector<DiagramTable> tables_of(const std::string& name) {
  if (name == "all")
    return {std::begin(topology::kDiagramTables), std::end(topology::kDiagramTables)};
  const auto table = topology::find_table(name);
  if (!table)
    throw InvalidInput("there is no table " + quoted(name) +
                       "; there are knots, links, theta-curves, handlebody-knots, and all");
  return {*table};
}

/// Throws InvalidInput: the name is in another table, or in none.
[[noreturn]] void refuse_name(const std::string& name, const topology::TabledDiagram* found) {
  for (const DiagramTable table : topology::kDiagramTables)
    for (const topology::TabledDiagram& other : topology::table_of(table))
      if (&other == found)
        throw InvalidInput(quoted(name) + " is in another table: tripus table " +
                           std::string(topology::table_name(table)) + " " + quoted(other.name));
  throw InvalidInput("there is no " + quoted(name) +
                     " in the tables; the nearest names there are " +
                     topology::nearest_diagram_names(name));
}

/// What a row tells is the same for mirror images, but for signatures, diagrams and pictures.
void note_mirror(const std::string& name, const std::string& found) {
  write_message(
      fmt::format("tripus: note: {} is the mirror image of {}, whose row this is: the orientations "
                  "of its signatures and its diagram are the other ones\n",
                  quoted(name), found));
}

std::vector<DiagramRow> chosen_rows(std::vector<DiagramRow> rows,
                                    const std::vector<std::string>& names) {
  if (names.empty()) return rows;
  std::vector<DiagramRow> chosen;
  for (const std::string& name : names) {
    const auto [found, mirrored] = topology::find_diagram_up_to_mirror(name);
    const std::size_t before = chosen.size();
    if (found != nullptr)
      std::ranges::copy_if(
          rows, std::back_inserter(chosen),
          [&, &is = found->name](const DiagramRow& row) { return row.name == is; });
    const bool is_short = chosen.size() == before;  // "5_1" for "5_1 theta" and "5_1 handcuff"
    for (const DiagramRow& row : rows)
      if (is_short && row.name.starts_with(name + " ")) chosen.push_back(row);
    if (chosen.size() == before) refuse_name(name, found);
    if (mirrored) note_mirror(name, found->name);
  }
  return chosen;
}

void write_content(const std::string& path, const std::string& content) {
  path == "-" ? write_output(content) : write_file(path, content);
}

/// Before the work, not after it.
void declare_outputs(const TableCommand& command) {
  for (const auto& [option, path] :
       {std::pair("--tsv", command.tsv), std::pair("--database", command.database),
        std::pair("--page", command.page)})
    if (!path.empty() && path != "-") declare_output(option, path);
}

int run(const TableCommand& command) {
  const std::vector<DiagramTable> tables = tables_of(command.table);
  declare_outputs(command);
  std::vector<DiagramRow> rows =
      command.compute ? computed(tables, command.quiet) : shipped(tables);
  if (interrupt_requested()) {
    write_message(
        fmt::format("tripus: {} after {} rows; nothing was written\n", stop_text(), rows.size()));
    return kNoAnswer;
  }
  rows = chosen_rows(std::move(rows), command.names);
  if (!command.tsv.empty()) write_content(command.tsv, to_tsv(rows));
  if (!command.database.empty()) write_diagram_database(rows, command.database);
  if (!command.page.empty()) write_content(command.page, page_of(command.table, rows));
  if (command.json)
    write_output(as_json(rows));
  else if (command.tsv.empty() && command.database.empty() && command.page.empty())
    for (const DiagramRow& row : rows) write_output(line_of(row));
  return kSuccess;
}

void add_table(CLI::App* verb, Command& chosen) {
  auto command = std::make_shared<TableCommand>();
  verb->add_option("TABLE", command->table, "knots, links, theta-curves, handlebody-knots or all")
      ->option_text(" ")
      ->required();
  verb->add_option("NAME", command->names, "only these rows")->option_text(" ");
  verb->add_option("--tsv", command->tsv, "write it as a table with tabs; - for standard output")
      ->option_text("FILE");
  verb->add_option("--database", command->database, "write it as a SQLite database")
      ->option_text("FILE");
  verb->add_option("--page", command->page, "write a page with a picture of every diagram (HTML)")
      ->option_text("FILE");
  verb->add_flag("--compute", command->compute,
                 "compute everything anew, from the diagrams: about a minute");
  verb->add_flag("--json", command->json, "print one JSON object");
  verb->add_flag("--quiet", command->quiet, "no progress");
  verb->footer(kTableHelp);
  verb->final_callback([command, &chosen] { chosen = [command] { return run(*command); }; });
}

}  // namespace

namespace registered_verbs {

std::span<const Verb> table() {
  static constexpr Verb kRows[] = {
      {"table", "tables of knots, links and handlebody-knots", add_table, 21}};
  return kRows;
}

}  // namespace registered_verbs
}  // namespace tripus::cli
