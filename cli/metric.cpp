#include "cli/metric.hpp"

#include <limits>

#include <fmt/format.h>

#include "cli/interrupt.hpp"
#include "cli/numbers.hpp"

namespace tripus::cli {

void add_metric_search(CLI::App& verb, MetricSearch& search) {
  auto* retriangulate =
      verb.add_flag("--retriangulate", search.retriangulate,
                    "where the triangulation carries no metric, look for one of the same\n"
                    "manifold that does: simplify it, then search by moves")
          ->option_text(" ");
  verb.add_option("--budget", search.options.budget,
                  fmt::format("triangulations that --retriangulate may try (default: {})",
                              search.options.budget))
      ->option_text("N")
      ->check(whole_number(std::numeric_limits<int>::max()))
      ->needs(retriangulate);
  verb.add_option("--seed", search.options.seed,
                  "orders the moves of --retriangulate that look equally good\n"
                  "(default: 0)")
      ->option_text("N")
      ->check(whole_number(std::numeric_limits<int>::max()))
      ->needs(retriangulate);
}

Solved find_metric(Subject subject, structure::SolveOptions options, const MetricSearch& search) {
  options.stop = &stop_flag();
  options.time_limit = seconds_left();
  options.cone_angles = subject.cone_angles;
  structure::Report report = structure::solve(subject.triangulation, options);
  const bool geometric = report.outcome == structure::Outcome::kGeometric;
  if (geometric || !search.retriangulate || is_work_over())
    return {std::move(subject), std::move(report), std::nullopt};
  options.time_limit = seconds_left();
  structure::Retriangulation found =
      structure::retriangulate(subject.triangulation, std::move(report), options, search.options);
  Subject result = make_subject(subject, found.gluings);
  result.cone_angles = found.cone_angles;
  structure::Report found_report = found.report;
  return {std::move(result), std::move(found_report), std::move(found)};
}

}  // namespace tripus::cli
