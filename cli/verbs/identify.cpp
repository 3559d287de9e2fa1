// tripus identify: the name of a manifold in a census.
#include "canonical/identify.hpp"

#include <fmt/format.h>

#include "cli/arguments.hpp"
#include "cli/canonize_options.hpp"
#include "cli/census.hpp"
#include "cli/describe.hpp"
#include "cli/help.hpp"
#include "cli/interrupt.hpp"
#include "cli/remedies.hpp"
#include "cli/texts.hpp"
#include "cli/verb.hpp"

namespace tripus::cli {
namespace {

using canonical::Census;
using canonical::Identification;
using canonical::IdentifiedBy;

struct IdentifyCommand : CanonicalCommand {
  std::string in;  ///< a census to look in instead of the shipped one
};

std::string message_of(const Identification& found, const IdentifyCommand& command,
                       const Census& census) {
  if (found.entry != nullptr) return fmt::format("It is {}.", found.entry->name);
  if (found.by == IdentifiedBy::kNothing) return "Unresolved: " + found.answer->message;
  const canonical::CanonicalManifold& manifold = *found.answer->manifold;
  return fmt::format(
      "It is not in the census {}: its signature is {}, its volume {:.15g}.",
      command.in.empty()
          ? "that comes with the program, which ends with four tetrahedra"
          : fmt::format("{} of {} manifolds", tripus::quoted(command.in), census.manifolds.size()),
      manifold.signature.unoriented, manifold.report.volume);
}

std::string as_json(const Subject& subject, const Identification& found,
                    const std::string& message) {
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
  if (found.by == IdentifiedBy::kNothing) {
    append(out, "null");
  } else {
    append_string(out, canonical::to_string(found.by));
  }
  append(out, ", \"message\": ");
  append_string(out, message);
  out.push_back('}');
  return fmt::to_string(out);
}

Reply identify_one(const IdentifyCommand& command, const Census& census, const std::string& input) {
  const Subject subject =
      load_ideal_subject(input, Balls::kRefused, interruptible(), require_canonizable_with_remedy);
  canonical::CanonizeOptions options = command.canonize;
  options.solve.cone_angles = subject.cone_angles;
  limit_work(options);
  const Identification found = canonical::identify(subject.triangulation, census, options);
  const std::string message = message_of(found, command, census);
  std::string text = fmt::format("{}: {}\n", printable(subject.input), message);
  if (found.entry != nullptr) text += "  " + entry_as_text(*found.entry);
  if (found.entry == nullptr && found.answer && found.answer->advice != structure::Advice::kNone)
    text += fmt::format("  {}\n", advice_text(found.answer->advice));
  return {command.common.json ? as_json(subject, found, message) : text,
          found.entry != nullptr ? kSuccess : kNoAnswer};
}

void add_identify(CLI::App* verb, Command& chosen) {
  auto command = std::make_shared<IdentifyCommand>();
  command->canonize.solve.evidence = false;
  add_common_options(*verb, command->common);
  add_canonize_options(*verb, command->canonize);
  verb->add_option("--in", command->in,
                   "census to look in, TSV or SQLite (default: the shipped one)")
      ->option_text("FILE");
  verb->footer(std::string(kInputHelp) + "\n" + kCanonicalStatusHelp);
  verb->final_callback([command, &chosen] {
    chosen = [command] {
      const ChosenCensus census(command->in);
      return answer_inputs(command->common, [&](const std::string& input) {
        return identify_one(*command, census.get(), input);
      });
    };
  });
}

}  // namespace

namespace registered_verbs {

std::span<const Verb> identify() {
  static constexpr Verb kRows[] = {
      {"identify", "the name of a manifold in the census", add_identify, 8}};
  return kRows;
}

}  // namespace registered_verbs
}  // namespace tripus::cli
