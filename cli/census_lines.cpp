#include "base/error.hpp"
#include "cli/answer.hpp"
#include "cli/census.hpp"
#include "cli/output.hpp"
#include "manifold/load.hpp"
#include "topology/isosig.hpp"

namespace tripus::cli {

using canonical::CensusLine;

std::string signature_of_line(const std::string& text) {
  if (text == "-") throw InvalidInput(kNoStandardInput);
  require_not_written(text);
  return topology::isosig(load_manifold_input(text).gluings);
}

std::vector<CensusLine> lines_of(const Journal& journal) {
  std::vector<CensusLine> lines;
  for (std::size_t k = 0; k < journal.lines().size(); ++k) {
    auto line = canonical::parse_journal_line(journal.lines()[k]);
    if (!line) throw InvalidInput(journal.place(k) + " is not one of a census");
    lines.push_back(std::move(*line));
  }
  return lines;
}

LineCounts count_lines(const std::vector<CensusLine>& lines) {
  LineCounts counts;
  for (const CensusLine& line : lines) {
    counts.own += line.resolved && line.own_metric;
    counts.moved += line.resolved && !line.own_metric;
    counts.refused += !line.reason.empty();
    counts.unresolved += !line.resolved && line.reason.empty();
  }
  return counts;
}

}  // namespace tripus::cli
