// tripus canonize: the canonical decomposition, the isometry group and the isometry signature.
#include <limits>
#include <memory>

#include <fmt/format.h>

#include "cli/answer.hpp"
#include "cli/canonize_options.hpp"
#include "cli/commands.hpp"
#include "cli/describe.hpp"
#include "cli/help.hpp"
#include "cli/interrupt.hpp"
#include "cli/manifold_text.hpp"
#include "cli/numbers.hpp"

namespace tripus::cli {
namespace {

struct CanonizeCommand {
  CommonOptions common;
  canonical::CanonizeOptions canonize;
};

std::string as_json(const Subject& subject, const canonical::CanonizeAnswer& answer) {
  JsonText out;
  append_header(out, subject.input);
  append_subject(out, subject);
  append(out, answer.manifold ? ", \"outcome\": \"geometric\"" : ", \"outcome\": \"unresolved\"");
  if (answer.manifold) append_manifold(out, *answer.manifold);
  append(out, ", \"message\": ");
  append_string(out, answer.message);
  out.push_back('}');
  return fmt::to_string(out);
}

std::string as_text(const Subject& subject, const canonical::CanonizeAnswer& answer) {
  std::string text = fmt::format("{}: {}\n", printable(subject.input), answer.message);
  if (answer.manifold) text += manifold_as_text(*answer.manifold);
  return text;
}

Outcome canonize_one(const CanonizeCommand& command, const std::string& input) {
  const Subject subject = load_subject(input);
  catch_interrupts();
  canonical::CanonizeOptions options = command.canonize;
  options.solve.stop_requested = &interrupt_requested();
  const auto answer = canonical::canonize(subject.triangulation, options);
  return {command.common.json ? as_json(subject, answer) : as_text(subject, answer),
          answer.manifold ? kSuccess : kNoAnswer};
}

}  // namespace

void add_canonize_options(CLI::App& verb, canonical::CanonizeOptions& options) {
  verb.add_option("--budget", options.retriangulation.budget,
                  fmt::format("triangulations to try where one carries no metric (default: {})",
                              options.retriangulation.budget))
      ->option_text("N")
      ->check(whole_number(std::numeric_limits<int>::max()));
}

const char* const kCanonicalStatusHelp =
    "Exit status: 0 an answer (for --batch: the run finished), 1 \"no\", unresolved or "
    "interrupted,\n"
    "2 bad usage or bad input, 3 a failure of the program itself.";

void add_canonize(CLI::App& program, Command& chosen) {
  CLI::App* verb = program.add_subcommand(
      "canonize", "canonical decomposition, isometry group, isometry signature");
  auto command = std::make_shared<CanonizeCommand>();
  add_common_options(*verb, command->common);
  add_canonize_options(*verb, command->canonize);
  verb->footer(std::string(kInputHelp) + "\n" + kCanonicalStatusHelp);
  verb->final_callback([command, &chosen] {
    chosen = [command] {
      return answer_inputs(command->common,
                           [&](const std::string& input) { return canonize_one(*command, input); });
    };
  });
}

}  // namespace tripus::cli
