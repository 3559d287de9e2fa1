// tripus prove: a proof that the metric exists, with every rounding accounted for.
#include <memory>

#include <fmt/format.h>

#include "cli/answer.hpp"
#include "cli/describe.hpp"
#include "cli/help.hpp"
#include "cli/interrupt.hpp"
#include "cli/numbers.hpp"
#include "cli/remedies.hpp"
#include "cli/texts.hpp"
#include "cli/verb.hpp"
#include "structure/proof/prove_report.hpp"
#include "structure/solve.hpp"

namespace tripus::cli {
namespace {

constexpr int kMostDigitsAsked = 100000;

struct ProveCommandOptions {
  CommonOptions common;
  int digits = 0;
};

std::string proof_table(const structure::ProofText& proof) {
  constexpr std::size_t kRows = 20;
  std::string text;
  if (!proof.proved) return text;
  text += "  edge class  length, an exact number, and how far the true one can be from it\n";
  for (std::size_t e = 0; e < proof.lengths.size(); ++e) {
    if (e == kRows)
      return text +
             fmt::format("  ... ({} in all; --json prints every one)\n", proof.lengths.size());
    text += fmt::format("  {:>10}  {} +- {}\n", e, proof.lengths[e], proof.radii[e]);
  }
  return text;
}

Reply prove_one(const ProveCommandOptions& command, const std::string& input) {
  const Subject subject =
      load_ideal_subject(input, Balls::kRefused, interruptible(), require_with_remedy);
  structure::SolveOptions solve;
  solve.cone_angles = subject.cone_angles;
  solve.stop = &stop_flag();
  solve.time_limit = seconds_left();
  structure::Report report = structure::solve(subject.triangulation, solve);
  Context context = interruptible();
  context.threads = command.common.batch.empty() ? command.common.threads : 1;
  const structure::ProofText proof = structure::prove_report(
      subject.triangulation, report, {.digits = command.digits, .cone_angles = subject.cone_angles},
      context);
  const bool metric = proof.proved && proof.claim == structure::Proof::Claim::kMetric;
  if (command.common.json) {
    report.message = structure::proof_message(proof);
    return {report_as_json(subject, report, nullptr, &proof), metric ? kSuccess : kNoAnswer};
  }
  std::string text = fmt::format("{}: {}\n", printable(subject.input), proof_message(proof));
  if (proof.proved && proof.volume)
    text += fmt::format("  volume      from {}\n              to   {}\n", proof.volume->lower,
                        proof.volume->upper);
  return {text + proof_table(proof), metric ? kSuccess : kNoAnswer};
}

void add_prove(CLI::App* verb, Command& chosen) {
  auto command = std::make_shared<ProveCommandOptions>();
  add_common_options(*verb, command->common);
  verb->add_option("--digits", command->digits,
                   "volume, lengths and angles to N proved digits after the point, for\n"
                   "triangulations with few edge classes")
      ->option_text("N")
      ->check(whole_number(kMostDigitsAsked));
  verb->footer(
      std::string(kInputHelp) +
      "\nCusps are welcome, and cone orders behind the INPUT as in \"cPcbbbiht 0=2,1=2\" (0: a "
      "parabolic "
      "edge).\n\"Proved\" accounts for every rounding: docs/theory.md section 9 and docs/proof.md. "
      "`tripus "
      "check`\nverifies what --json prints by other code.\n\n"
      "Exit status: 0 proved geometric (for --batch: the run finished), 1 proved to carry no "
      "metric, or\nnot proved (the message says why), 2 bad usage or bad input, 3 a failure of the "
      "program itself.");
  verb->final_callback([command, &chosen] {
    chosen = [command] {
      return answer_inputs(command->common, [command](const std::string& input) {
        return prove_one(*command, input);
      });
    };
  });
}

}  // namespace

namespace registered_verbs {

std::span<const Verb> prove() {
  static constexpr Verb kRows[] = {
      {"prove", "a proof that the metric exists, to as many digits as wanted", add_prove, 11}};
  return kRows;
}

}  // namespace registered_verbs
}  // namespace tripus::cli
