// tripus identify: the name of a manifold in the census.
#include <fmt/format.h>

#include "canonical/census.hpp"
#include "cli/canonize_options.hpp"
#include "cli/commands.hpp"
#include "cli/describe.hpp"
#include "cli/manifold_text.hpp"

namespace tripus::cli {
namespace {

using canonical::CensusEntry;

/// What was found out, and how.
struct Identified {
  const CensusEntry* entry = nullptr;
  std::string_view how;  ///< "triangulation": it is listed; "decomposition": by its signature
  std::string message;
};

Identified identify(const Subject& subject, const canonical::CanonizeOptions& options) {
  const canonical::Census& census = canonical::shipped_census();
  if (subject.isosig) {
    if (const CensusEntry* entry = census.find(*subject.isosig))
      return {entry, "triangulation", fmt::format("It is {}.", entry->name)};
  }
  const auto answer = canonical::canonize(subject.triangulation, options);
  if (!answer.manifold) return {nullptr, {}, "Unresolved: " + answer.message};
  if (const CensusEntry* entry = census.find(answer.manifold->signature.unoriented))
    return {entry, "decomposition", fmt::format("It is {}.", entry->name)};
  return {nullptr, "decomposition",
          fmt::format("It is not in the census, which ends with four tetrahedra: its signature is "
                      "{}, its volume {:.15g}.",
                      answer.manifold->signature.unoriented, answer.manifold->report.volume)};
}

std::string as_json(const Subject& subject, const Identified& found) {
  JsonText out;
  append_header(out, subject.input);
  append_subject(out, subject);
  append(out, ", \"census\": ");
  if (found.entry != nullptr) {
    append_entry(out, *found.entry);
  } else {
    append(out, "null");
  }
  append(out, ", \"identified_by\": ");
  if (found.how.empty()) {
    append(out, "null");
  } else {
    append_string(out, found.how);
  }
  append(out, ", \"message\": ");
  append_string(out, found.message);
  out.push_back('}');
  return fmt::to_string(out);
}

Outcome identify_one(const CanonicalCommand& command, const Subject& subject) {
  const Identified found = identify(subject, command.canonize);
  std::string text = fmt::format("{}: {}\n", printable(subject.input), found.message);
  if (found.entry != nullptr) text += "  " + entry_as_text(*found.entry);
  return {command.common.json ? as_json(subject, found) : text,
          found.entry != nullptr ? kSuccess : kNoAnswer};
}

}  // namespace

void add_identify(CLI::App& program, Command& chosen) {
  add_canonical_verb(program, "identify", "the name of a manifold in the census", chosen,
                     identify_one);
}

}  // namespace tripus::cli
