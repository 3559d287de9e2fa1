#include "cli/canonize_options.hpp"

#include <limits>
#include <memory>

#include <fmt/format.h>

#include "cli/help.hpp"
#include "cli/interrupt.hpp"
#include "cli/numbers.hpp"
#include "cli/remedies.hpp"

namespace tripus::cli {

void add_canonize_options(CLI::App& verb, canonical::CanonizeOptions& options) {
  verb.add_option("--budget", options.retriangulation.budget,
                  fmt::format("triangulations to try where one carries no metric (default: {})",
                              options.retriangulation.budget))
      ->option_text("N")
      ->check(whole_number(std::numeric_limits<int>::max()));
}

void limit_work(canonical::CanonizeOptions& options) {
  options.solve.stop = &stop_flag();
  options.solve.time_limit = seconds_left();
}

void add_prove_option(CLI::App& verb, bool& prove, const char* what) {
  verb.add_flag("--prove", prove, what)->option_text(" ");
}

const char* const kCanonicalStatusHelp =
    "Exit status: 0 an answer (for --batch: the run finished), 1 \"no\", unresolved or "
    "interrupted,\n"
    "2 bad usage or bad input, 3 a failure of the program itself.";

void add_canonical_verb(CLI::App& program, const char* name, const char* description,
                        Command& chosen,
                        Reply (*answer)(const CanonicalCommand& command, const Subject& subject),
                        bool can_prove) {
  CLI::App* verb = program.add_subcommand(name, description);
  auto command = std::make_shared<CanonicalCommand>();
  add_common_options(*verb, command->common);
  add_canonize_options(*verb, command->canonize);
  if (can_prove)
    add_prove_option(*verb, command->prove,
                     "also prove the decomposition, or name the faces that are not");
  verb->footer(std::string(kInputHelp) + "\n" + kCanonicalStatusHelp);
  verb->final_callback([command, answer, &chosen] {
    chosen = [command, answer] {
      return answer_inputs(command->common, [command, answer](const std::string& input) {
        const Subject subject = load_ideal_subject(input, Balls::kRefused, interruptible(),
                                                   require_canonizable_with_remedy);
        CanonicalCommand limited = *command;
        limit_work(limited.canonize);
        return answer(limited, subject);
      });
    };
  });
}

}  // namespace tripus::cli
