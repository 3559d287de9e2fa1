// The verb that the page's gallery asks: the census that is in the module, a row a manifold. (The
// program's `census` makes and reads files, and is not in the module.)
#include "canonical/census.hpp"
#include "cli/failure.hpp"
#include "cli/output.hpp"
#include "cli/verb.hpp"
#include "manifold/canonical_json.hpp"

namespace tripus::cli {
namespace {

/// Without the triangulations, which `identify` tells of one manifold.
int write_census_rows() {
  JsonText out;
  append_header(out, "census");
  append(out, ", \"rows\": ");
  append_array(out, canonical::shipped_census().manifolds,
               [](JsonText& to, canonical::CensusEntry entry) {
                 entry.triangulations.clear();
                 append_entry(to, entry);
               });
  append(out, "}\n");
  write_output({out.data(), out.size()});
  return kSuccess;
}

void add_census_rows(CLI::App* verb, Command& chosen) {
  verb->add_flag("--json", "print one JSON object, as always");
  verb->final_callback([&chosen] { chosen = write_census_rows; });
}

}  // namespace

namespace registered_verbs {

std::span<const Verb> census_rows() {
  static constexpr Verb kRows[] = {
      {"census-rows", "the manifolds of the census, as JSON", add_census_rows}};
  return kRows;
}

}  // namespace registered_verbs
}  // namespace tripus::cli
