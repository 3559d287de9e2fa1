// Every trial of docs/verdicts.md in full; prints its tables. Run by scripts/verdicts.
#include <chrono>
#include <cstdlib>
#include <map>
#include <string_view>

#include <fmt/format.h>

#include "tests/support/data_files.hpp"
#include "tests/support/verdict_trials.hpp"

namespace {

using namespace tripus;
using structure::Outcome;

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

int complaints = 0;
void complain(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) fmt::print(stderr, "  {}\n", line);
  complaints += static_cast<int>(lines.size());
}

constexpr const char* kLists[] = {"triangulations-2.txt", "triangulations-3.txt",
                                  "triangulations-4.txt"};

/// The weakest evidence of some minimisers with flat tetrahedra.
struct FlatSummary {
  int count = 0;
  std::size_t flat = 0;  ///< tetrahedra, at most
  long double max_curvature = 0, least_excess = 1e9L, greatest_excess = -1e9L, shortfall = 1e9L;
  double longest = 0;

  void add(const structure::Report& report, const testing::FlatEvidence& evidence) {
    ++count;
    flat = std::max(flat, report.flat_tetrahedra.size());
    max_curvature = std::max(max_curvature, evidence.max_curvature);
    least_excess = std::min(least_excess, evidence.excess);
    greatest_excess = std::max(greatest_excess, evidence.excess);
    shortfall = std::min(shortfall, evidence.shortfall);
    longest = std::max(longest, evidence.longest);
  }
  void print(const char* name) const {
    fmt::print("| {} | {} | {} | {:.1e} | {:.2f} | {:.1e} to {:.1e} | {:.3f} |\n", name, count,
               flat, static_cast<double>(max_curvature), longest, static_cast<double>(least_excess),
               static_cast<double>(greatest_excess), static_cast<double>(shortfall));
  }
};

void verdicts() {
  fmt::print(
      "### Verdicts\n\n"
      "| List | all | geometric | degenerate, strict | degenerate, semi | infeasible, semi | "
      "infeasible, none | unresolved | seconds |\n|---|---|---|---|---|---|---|---|---|\n");
  FlatSummary isolated, rays;
  for (const char* list : kLists) {
    testing::VerdictCounts counts;
    const auto start = Clock::now();
    for (const auto& signature : testing::data_lines(list)) {
      const auto triangulation = testing::decode(signature);
      const auto report = structure::solve(triangulation);
      testing::count_verdict(signature, triangulation, report, counts);
      if (report.outcome != Outcome::kDegenerate) continue;
      const auto evidence = testing::flat_evidence(triangulation, report);
      (evidence.free_edges.empty() ? isolated : rays).add(report, evidence);
    }
    fmt::print("| `{}` | {} | {} | {} | {} | {} | {} | {} | {:.1f} |\n", list,
               counts.triangulations, counts.geometric, counts.degenerate_strict,
               counts.degenerate_semi, counts.infeasible_semi, counts.infeasible_none,
               counts.unresolved, seconds_since(start));
    complain(counts.wrong);
  }
  fmt::print(
      "\n### Minimisers with flat tetrahedra, computed again in extended precision\n\n"
      "| Minimisers | number | flat tetrahedra, at most | largest max\\|K\\| | longest edge | "
      "\\|cos\\| - 1 at the angles pi | least 1 - \\|cos\\| elsewhere "
      "|\n|---|---|---|---|---|---|---|\n");
  isolated.print("isolated");
  rays.print("a ray, 1 further out");
}

void starts(int random_starts, std::size_t step_of_four) {
  fmt::print(
      "\n### Starts\n\n"
      "| List | method | solves | failures | largest difference of a length | most iterations | "
      "seconds |\n|---|---|---|---|---|---|---|\n");
  for (const char* list : kLists) {
    const auto signatures = testing::data_lines(list);
    const std::size_t step =
        std::string_view(list).find('4') == std::string_view::npos ? 1 : step_of_four;
    for (const char* method : {"newton", "newton-cg"}) {
      testing::StartTrials trials;
      const auto start = Clock::now();
      for (std::size_t k = 0; k < signatures.size(); k += step)
        testing::try_starts(signatures[k], method, random_starts, trials);
      fmt::print("| `{}`{} | `{}` | {} | {} | {:.1e} | {} | {:.1f} |\n", list,
                 step == 1 ? "" : fmt::format(", every {}th", step), method, trials.solves,
                 trials.failed.size(), trials.worst, trials.most_iterations, seconds_since(start));
      complain(trials.failed);
    }
  }
}

std::vector<std::string> geometric_of(const char* list) {
  std::vector<std::string> geometric;
  for (const auto& signature : testing::data_lines(list))
    if (structure::solve(testing::decode(signature)).outcome == Outcome::kGeometric)
      geometric.push_back(signature);
  return geometric;
}

void recoveries(int trials_per_count) {
  const auto geometric = geometric_of("triangulations-4.txt");
  fmt::print(
      "\n### Random 2-3 moves undone\n\n"
      "| moves | trials | still geometric | recovered | largest difference of the volume | "
      "triangulations tried, mean | most | seconds |\n|---|---|---|---|---|---|---|---|\n");
  std::mt19937_64 random(20);
  testing::MoveTrials all;
  for (std::size_t moves = 1; moves <= 10; ++moves) {
    testing::MoveTrials trials;
    const auto start = Clock::now();
    for (int trial = 0; trial < trials_per_count; ++trial)
      testing::try_recovery(geometric[random() % geometric.size()], moves, random(), trials);
    fmt::print("| {} | {} | {} | {} | {:.1e} | {:.1f} | {} | {:.1f} |\n", moves, trials.trials,
               trials.still_geometric, trials.recovered, trials.worst,
               static_cast<double>(trials.tried) / trials.trials, trials.most_tried,
               seconds_since(start));
    for (const auto& name : trials.failed) fmt::print(stderr, "  not recovered: {}\n", name);
    all.trials += trials.trials;
    all.recovered += trials.recovered;
    complain(trials.wrong);
  }
  fmt::print("\n{} of {} recovered ({:.2f} %).\n", all.recovered, all.trials,
             100.0 * all.recovered / all.trials);
  if (all.recovered < 0.99 * all.trials) ++complaints;
}

/// What a search makes of a list's triangulations without metric.
struct SearchCounts {
  int all = 0, found = 0, exhausted = 0;
  std::size_t tried = 0;
};

void searches(const char* list, std::size_t budget) {
  std::map<std::string, SearchCounts> counts;
  std::map<structure::SearchEnd, int> ends;
  std::size_t longest = 0, most_tried = 0;
  int flat_volumes = 0, smaller = 0, larger = 0, neighbours = 0, found_in_all = 0;
  const auto start = Clock::now();
  for (const auto& signature : testing::data_lines(list)) {
    const auto triangulation = testing::decode(signature);
    auto report = structure::solve(triangulation);
    if (report.outcome == Outcome::kGeometric) continue;
    auto& count = counts[testing::verdict_of(report)];
    const auto found =
        structure::retriangulate(triangulation, std::move(report), {}, {.budget = budget});
    ++count.all;
    ++ends[found.end];
    count.exhausted += found.end == structure::SearchEnd::kExhausted;
    if (found.end != structure::SearchEnd::kFound) continue;
    ++found_in_all;
    ++count.found;
    count.tried += found.tried;
    most_tried = std::max(most_tried, found.tried);
    longest = std::max(longest, found.path.size());
    if (!testing::path_leads_there(triangulation.gluings(), found))
      complain({signature + ": the path leads elsewhere"});
    for (const auto& other : found.volumes) {
      if (other.outcome == Outcome::kGeometric) {
        ++neighbours;
        continue;
      }
      ++flat_volumes;
      const double ratio = other.volume / found.report.volume;
      smaller += ratio < 1 - 1e-9;
      larger += ratio > 1 + 1e-9;
    }
  }
  fmt::print("\n### Retriangulation of `{}`, budget {}\n\n", list, budget);
  fmt::print(
      "| Verdict | triangulations | metric found | unresolved: budget | unresolved: all "
      "reached | tried where found, mean |\n|---|---|---|---|---|---|\n");
  for (const auto& [verdict, c] : counts) {
    fmt::print("| {} | {} | {} | {} | {} | {:.1f} |\n", verdict, c.all, c.found,
               c.all - c.found - c.exhausted, c.exhausted,
               c.found == 0 ? 0.0 : static_cast<double>(c.tried) / c.found);
  }
  fmt::print(
      "\n{} found, in {:.0f} s for the list; the longest path has {} moves, the longest successful "
      "search tried {}.\nVolumes compared: on a neighbour that carries the metric too, {} times, "
      "the "
      "same always; at minimisers with flat tetrahedra on the path, {} times, the same {}, smaller "
      "{}, larger {}.\n",
      found_in_all, seconds_since(start), longest, most_tried, neighbours, flat_volumes,
      flat_volumes - smaller - larger, smaller, larger);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view what = argc > 1 ? argv[1] : "all";
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  const auto wanted = [&](std::string_view name) { return what == "all" || what == name; };
  if (wanted("verdicts")) verdicts();
  if (wanted("starts")) starts(100, 20);
  if (wanted("moves")) recoveries(50);
  if (wanted("retriangulate")) {
    searches("triangulations-3.txt", structure::RetriangulateOptions{}.budget);
    searches("triangulations-4.txt", structure::RetriangulateOptions{}.budget);
  }
  fmt::print("\n{} complaints\n", complaints);
  return complaints == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
