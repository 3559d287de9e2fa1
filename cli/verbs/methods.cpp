// tripus methods: every energy, method and flow by name.
#include <fmt/format.h>

#include "cli/failure.hpp"
#include "cli/output.hpp"
#include "cli/verb.hpp"
#include "energies/energies.hpp"
#include "integrators/flow.hpp"
#include "integrators/stepper.hpp"
#include "manifold/json_text.hpp"
#include "solver/method.hpp"

namespace tripus::cli {
namespace {

/// One line of one of the tables.
struct Row {
  std::string_view name;
  std::string_view description;
};

template <class Table>
std::vector<Row> rows_of(const Table& table) {
  std::vector<Row> rows;
  for (const auto& entry : table) rows.push_back({entry.name, entry.description});
  return rows;
}

void append_rows(JsonText& out, std::string_view key, const std::vector<Row>& rows) {
  append(out, ", ");
  append_string(out, key);
  append(out, ": ");
  append_array(out, rows, [](JsonText& to, const Row& row) {
    append(to, "{\"name\": ");
    append_string(to, row.name);
    append(to, ", \"description\": ");
    append_string(to, row.description);
    to.push_back('}');
  });
}

std::string section(std::string_view title, const std::vector<Row>& rows) {
  std::string text = fmt::format("{}\n", title);
  for (const Row& row : rows) text += fmt::format("  {:<24}{}\n", row.name, row.description);
  return text;
}

int run(bool json) {
  const auto energies = rows_of(energies::energies());
  const auto methods = rows_of(solver::methods());
  const auto flows = rows_of(integrators::flows());
  const auto steppers = rows_of(integrators::steppers());
  if (json) {
    JsonText out;
    append_header(out, "methods");
    append_rows(out, "energies", energies);
    append_rows(out, "methods", methods);
    append_rows(out, "flows", flows);
    append_rows(out, "steppers", steppers);
    append(out, "}\n");
    write_output({out.data(), out.size()});
    return kSuccess;
  }
  write_output(section("Energies", energies) + "\n");
  write_output(section("Methods: --method NAME minimises the co-volume over the edge lengths,\n"
                       "--method angles:NAME the volume energy over the dihedral angles;\n"
                       "auto, the default, is newton, or newton-cg for large triangulations",
                       methods) +
               "\n");
  write_output(section("Flows of the edge lengths: --method flow:FLOW/STEPPER; g = -K is the "
                       "gradient, H the Hessian",
                       flows) +
               "\n");
  write_output(section("Steppers", steppers));
  return kSuccess;
}

void add_methods(CLI::App* verb, Command& chosen) {
  auto json = std::make_shared<bool>(false);
  verb->add_flag("--json", *json, "one JSON object on standard output");
  verb->final_callback([json, &chosen] { chosen = [json] { return run(*json); }; });
}

}  // namespace

namespace registered_verbs {

std::span<const Verb> methods() {
  static constexpr Verb kRows[] = {
      {"methods", "every energy, method and flow by name", add_methods, 23}};
  return kRows;
}

}  // namespace registered_verbs
}  // namespace tripus::cli
