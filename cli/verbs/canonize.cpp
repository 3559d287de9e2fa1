// tripus canonize: the canonical decomposition, the isometry group and the isometry signature.
#include <memory>
#include <string>

#include <fmt/format.h>

#include "canonical/proved.hpp"
#include "cli/canonize_options.hpp"
#include "cli/describe.hpp"
#include "cli/help.hpp"
#include "cli/interrupt.hpp"
#include "cli/remedies.hpp"
#include "cli/texts.hpp"
#include "cli/verb.hpp"

namespace tripus::cli {
namespace {

std::string as_json(const Subject& subject, const canonical::CanonizeAnswer& answer,
                    const canonical::CanonicalProof* proof) {
  JsonText out;
  append_header(out, subject.input);
  append_subject(out, subject);
  append_oriented(out, subject);
  append_cone_orders(out, subject);
  append(out, answer.manifold ? ", \"outcome\": \"geometric\"" : ", \"outcome\": \"unresolved\"");
  if (answer.manifold) {
    append_manifold(out, *answer.manifold);
    append(out, subject.orientation_known ? ", \"orientation_known\": true"
                                          : ", \"orientation_known\": false");
  } else {
    append(out, ", \"certificate\": ");
    append(out,
           answer.report.certificate ? structure::to_json(*answer.report.certificate) : "null");
    append(out, ", \"advice\": ");
    append_string(out, structure::to_string(answer.advice));
  }
  if (proof != nullptr)
    append(out, ", \"proof\": " + structure::to_json(canonical::proof_text(*proof)));
  append(out, ", \"message\": ");
  append_string(out, answer.message);
  out.push_back('}');
  return fmt::to_string(out);
}

std::string as_text(const Subject& subject, const canonical::CanonizeAnswer& answer,
                    const canonical::CanonicalProof* proof) {
  std::string text = fmt::format("{}: {}\n", printable(subject.input), answer.message);
  if (answer.manifold) {
    text += manifold_as_text(*answer.manifold);
    if (!subject.orientation_known && answer.manifold->decomposition.is_orientable() &&
        !answer.manifold->isometries.is_amphicheiral)
      text +=
          "  the orientation is not known, since the INPUT is a signature without + or -: the "
          "sign\n  above is that of INPUT+\n";
    if (proof != nullptr)
      text += fmt::format("  {:<14}{}\n", "proof", canonical::proof_message(*proof));
    return text;
  }
  if (answer.advice != structure::Advice::kNone)
    text += fmt::format("  {}\n", advice_text(answer.advice));
  text += certificate_as_text(answer.report);
  return text;
}

Reply canonize_one(const CanonicalCommand& command, const Subject& subject) {
  canonical::CanonizeOptions options = command.canonize;
  options.solve.cone_angles = subject.cone_angles;
  const auto answer = canonical::canonize(subject.triangulation, options);
  std::optional<canonical::CanonicalProof> proof;
  if (command.prove && answer.manifold)
    proof = canonical::prove_canonical(*answer.manifold, interruptible());
  const auto* given = proof ? &*proof : nullptr;
  return {command.common.json ? as_json(subject, answer, given) : as_text(subject, answer, given),
          answer.manifold ? kSuccess : kNoAnswer};
}

void add_canonize(CLI::App* verb, Command& chosen) {
  auto command = std::make_shared<CanonicalCommand>();
  add_common_options(*verb, command->common);
  add_canonize_options(*verb, command->canonize);
  add_prove_option(*verb, command->prove,
                   "also prove the decomposition, or name the faces that are not");
  verb->footer(std::string(kInputHelp) + "\n" + kCanonicalStatusHelp);
  verb->final_callback([command, &chosen] {
    chosen = [command] {
      return answer_inputs(command->common, [command](const std::string& input) {
        const Subject subject = load_ideal_subject(input, Balls::kRefused, interruptible(),
                                                   require_canonizable_with_remedy);
        CanonicalCommand limited = *command;
        limit_work(limited.canonize);
        return canonize_one(limited, subject);
      });
    };
  });
}

}  // namespace

namespace registered_verbs {

std::span<const Verb> canonize() {
  static constexpr Verb kRows[] = {
      {"canonize", "canonical decomposition, isometry group, isometry signature", add_canonize, 6}};
  return kRows;
}

}  // namespace registered_verbs
}  // namespace tripus::cli
