// The verb that the page asks for a picture: the data of viewer/web, without a page around it.
#include "viewer/web/page_data.hpp"

#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "cli/answer.hpp"
#include "cli/describe.hpp"
#include "cli/interrupt.hpp"
#include "cli/metric.hpp"
#include "cli/numbers.hpp"
#include "cli/remedies.hpp"
#include "cli/texts.hpp"
#include "cli/verb.hpp"
#include "manifold/report_json.hpp"
#include "viewer/wall_discs.hpp"

namespace tripus::cli {
namespace {

struct PageDataCommand {
  CommonOptions common;
  MetricSearch search;
  std::size_t cells = 20;
  std::string model = "ball";
  bool discs = false;
  double length = 0;  ///< of the discs; 0: some hundred of them
};

Reply page_data_of(const PageDataCommand& command, const std::string& input) {
  const Solved solved =
      find_metric(load_ideal_subject(input, Balls::kRefused, interruptible(), require_with_remedy),
                  {}, command.search);
  const Subject& subject = solved.subject;
  if (!solved.is_geometric())
    return {report_as_json(subject, solved.report, solved.search()), kNoAnswer};
  const auto embedding =
      embedding::embed(subject.triangulation, solved.report.edge_lengths, {subject.cone_angles, 0});
  std::optional<viewer::WallDiscs> discs;
  if (command.discs || command.length > 0)
    discs = viewer::find_wall_discs(
        embedding, subject.triangulation, solved.report.edge_lengths,
        command.length > 0 ? std::optional(command.length) : std::nullopt, interruptible());
  return {viewer::page_data({.name = subject.name.empty() ? subject.input : subject.name,
                             .isosig = subject.isosig.value_or(""),
                             .cells = command.cells,
                             .model = command.model,
                             .discs = discs ? &*discs : nullptr,
                             .gallery = {}},
                            subject.triangulation, solved.report, embedding),
          kSuccess};
}

void add_page_data(CLI::App* verb, Command& chosen) {
  auto command = std::make_shared<PageDataCommand>();
  add_common_options(*verb, command->common);
  add_metric_search(*verb, command->search);
  verb->add_option("--cells", command->cells, "cells shown at first (default: 20)")
      ->option_text("N")
      ->check(whole_number(std::numeric_limits<int>::max()));
  verb->add_option("--model", command->model, "ball (default), upper or klein")
      ->option_text("NAME");
  verb->add_flag("--discs", command->discs, "with the discs of arcs on the boundary");
  verb->add_option("--disc-length", command->length, "of the arcs up to this length")
      ->option_text("L")
      ->check(positive_number());
  verb->final_callback([command, &chosen] {
    chosen = [command] {
      return answer_inputs(command->common,
                           [&](const std::string& input) { return page_data_of(*command, input); });
    };
  });
}

}  // namespace

namespace registered_verbs {

std::span<const Verb> page_data() {
  static constexpr Verb kRows[] = {
      {"page-data", "what a page needs to show the manifold, as JSON", add_page_data}};
  return kRows;
}

}  // namespace registered_verbs
}  // namespace tripus::cli
