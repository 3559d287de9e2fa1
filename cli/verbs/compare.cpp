// tripus compare: homeomorphic or not, and how it was decided.
#include "canonical/compare.hpp"

#include <memory>

#include <fmt/format.h>

#include "canonical/proved.hpp"
#include "cli/answer.hpp"
#include "cli/arguments.hpp"
#include "cli/canonize_options.hpp"
#include "cli/describe.hpp"
#include "cli/help.hpp"
#include "cli/interrupt.hpp"
#include "cli/remedies.hpp"
#include "cli/texts.hpp"
#include "cli/verb.hpp"

namespace tripus::cli {
namespace {

using canonical::Comparison;
using canonical::Verdict;

struct CompareCommand {
  CommonOptions common;  ///< INPUT is the first manifold
  std::string second;
  canonical::CanonizeOptions canonize;
  bool prove = false;
};

void append_side(JsonText& out, std::string_view key, const std::string& input,
                 const std::optional<canonical::CanonicalManifold>& manifold) {
  fmt::format_to(std::back_inserter(out), ", \"{}\": {{\"input\": ", key);
  append_string(out, input);
  if (manifold) append_manifold(out, *manifold);
  out.push_back('}');
}

void append_proof(JsonText& out, const canonical::ComparisonProof& proof) {
  fmt::format_to(std::back_inserter(out), ", \"proof\": {{\"proved\": {}, ", proof.proved);
  append(out, proof.proved ? "\"by\": " : "\"reason\": ");
  append_string(out, proof.proved ? proof.by : proof.reason);
  out.push_back('}');
}

std::string as_json(const CompareCommand& command, const Comparison& comparison,
                    const canonical::ComparisonProof* proof) {
  JsonText out;
  append_header(out, command.common.input);
  append(out, ", \"verdict\": ");
  append_string(out, canonical::to_string(comparison.verdict));
  append(out, ", \"decided_by\": ");
  if (comparison.decided_by.empty()) {
    append(out, "null");
  } else {
    append_string(out, comparison.decided_by);
  }
  append(out, ", \"isometry\": ");
  if (comparison.isometry) {
    append_cell_map(out, *comparison.isometry);
  } else {
    append(out, "null");
  }
  // null: there is an isometry, and nothing is known of orientations.
  const bool unknown = !comparison.orientations_known;
  fmt::format_to(std::back_inserter(out),
                 ", \"keeps_orientation\": {}, \"reverses_orientation\": {}",
                 unknown                        ? "null"
                 : comparison.keeps_orientation ? "true"
                                                : "false",
                 unknown                           ? "null"
                 : comparison.reverses_orientation ? "true"
                                                   : "false");
  append_side(out, "first", command.common.input, comparison.first);
  append_side(out, "second", command.second, comparison.second);
  if (comparison.advice != structure::Advice::kNone) {
    append(out, ", \"advice\": ");
    append_string(out, structure::to_string(comparison.advice));
  }
  if (proof != nullptr) append_proof(out, *proof);
  append(out, ", \"message\": ");
  append_string(out, comparison.message);
  out.push_back('}');
  return fmt::to_string(out);
}

std::string as_text(const Comparison& comparison, const canonical::ComparisonProof* proof) {
  std::string text = comparison.message + "\n";
  if (comparison.advice != structure::Advice::kNone)
    text += fmt::format("  {}\n", advice_text(comparison.advice));
  if (!comparison.decided_by.empty())
    text += fmt::format("  {:<14}{}\n", "decided by", comparison.decided_by);
  if (comparison.isometry)
    text += fmt::format("  {:<14}{}\n", "isometry", cell_map_as_text(*comparison.isometry));
  if (proof != nullptr)
    text += fmt::format(
        "  {:<14}{}\n", "proof",
        proof->proved ? "proved by " + proof->by : "not proved: " + proof->reason + ".");
  return text;
}

/// What cannot be compared by a metric is named by its input.
void require_metric(const Subject& subject) {
  const std::string source = subject.input == "-" ? "standard input" : quoted(subject.input);
  try {
    require_canonizable_with_remedy(subject.triangulation, subject.cone_angles);
  } catch (const Unsupported& error) {
    throw Unsupported(source + ": " + error.what());
  } catch (const InvalidInput& error) {
    throw InvalidInput(source + ": " + error.what());
  }
}

Comparison compare_subjects(const Subject& first, const Subject& second,
                            const canonical::CanonizeOptions& options) {
  const bool known = first.orientation_known && second.orientation_known;
  try {
    return canonical::compare(
        {first.triangulation, first.cone_angles}, {second.triangulation, second.cone_angles},
        options, known ? canonical::Orientations::kKnown : canonical::Orientations::kNotKnown);
  } catch (const InvalidInput&) {
    require_metric(first);
    require_metric(second);
    throw;
  }
}

Reply compare_two(const CompareCommand& command) {
  if (command.common.input == "-" && command.second == "-")
    throw InvalidInput("the two manifolds cannot both come from standard input");
  const auto load = [](const std::string& input) {
    return load_ideal_subject(input, Balls::kAllowed, interruptible(),
                              [](const auto&, const auto&) {});
  };
  const Subject first = load(command.common.input);
  const Subject second = load(command.second);
  canonical::CanonizeOptions options = command.canonize;
  limit_work(options);
  const Comparison comparison = compare_subjects(first, second, options);
  std::optional<canonical::ComparisonProof> proof;
  if (command.prove) proof = canonical::prove_comparison(comparison, interruptible());
  const auto* given = proof ? &*proof : nullptr;
  return {command.common.json ? as_json(command, comparison, given) : as_text(comparison, given),
          comparison.verdict == Verdict::kHomeomorphic ? kSuccess : kNoAnswer};
}

void add_compare(CLI::App* verb, Command& chosen) {
  auto command = std::make_shared<CompareCommand>();
  for (auto [name, value] :
       {std::pair("FIRST", &command->common.input), std::pair("SECOND", &command->second)}) {
    verb->add_option(name, *value, "an INPUT: a signature, a file, or - for standard input")
        ->option_text(" ")
        ->transform(unshield())
        ->required();
  }
  verb->add_flag("--json", command->common.json, "one JSON object");
  add_canonize_options(*verb, command->canonize);
  add_prove_option(*verb, command->prove, "also say whether the verdict is proved, and by what");
  verb->footer(
      std::string(kInputHelp) +
      "\nExit status: 0 homeomorphic, 1 not homeomorphic or unresolved, 2 bad usage or bad "
      "input,\n3 a failure of the program itself.");
  verb->final_callback([command, &chosen] {
    chosen = [command] {
      return answer_inputs(command->common,
                           [&](const std::string&) { return compare_two(*command); });
    };
  });
}

}  // namespace

namespace registered_verbs {

std::span<const Verb> compare() {
  static constexpr Verb kRows[] = {
      {"compare", "same manifold or not, and how that is known", add_compare, 7}};
  return kRows;
}

}  // namespace registered_verbs
}  // namespace tripus::cli
