// A verb of one's own: `tripus volume INPUT` prints the volume and nothing else. This file is all
// that it takes: help, --batch, --json, --threads and --time-limit come with the common options.
#include "cli/answer.hpp"
#include "cli/failure.hpp"
#include "cli/interrupt.hpp"
#include "cli/verb.hpp"
#include "manifold/json_text.hpp"
#include "manifold/load.hpp"
#include "manifold/manifold.hpp"
#include "manifold/metric.hpp"

namespace tripus::cli {
namespace {

Reply volume_of(const CommonOptions& options, const std::string& input) {
  const Context context = interruptible();
  const Manifold M = load(input, context);
  const Metric* metric = M.metric(context);
  const int status = metric != nullptr ? kSuccess : kNoAnswer;
  const std::string volume = metric != nullptr ? fmt::format("{}", metric->volume()) : "";
  const std::string& message = M.verdict(context).message;
  if (!options.json) return {(metric != nullptr ? volume : message) + "\n", status};
  JsonText out;
  append_header(out, input);
  fmt::format_to(std::back_inserter(out), ", \"volume\": {}", metric != nullptr ? volume : "null");
  append_text_key(out, "message", message);
  append(out, "}");
  return {fmt::to_string(out), status};
}

void add_volume(CLI::App* verb, Command& chosen) {
  auto options = std::make_shared<CommonOptions>();
  add_common_options(*verb, *options);
  verb->final_callback([options, &chosen] {
    chosen = [options] {
      return answer_inputs(
          *options, [options](const std::string& input) { return volume_of(*options, input); });
    };
  });
}

}  // namespace

namespace registered_verbs {

std::span<const Verb> volume() {
  static constexpr Verb kRows[] = {{"volume", "the volume alone", add_volume}};
  return kRows;
}

}  // namespace registered_verbs
}  // namespace tripus::cli
