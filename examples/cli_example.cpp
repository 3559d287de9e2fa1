// What the program makes of an INPUT, and the JSON that it prints for it.
#include <cstdio>

#include "cli/describe.hpp"
#include "cli/files.hpp"
#include "cli/texts.hpp"
#include "structure/solve.hpp"

int main() {
  using namespace tripus;
  const Subject subject = load_subject("cPcbbbihq");
  structure::SolveOptions options;
  options.initial_lengths = cli::parse_lengths("1.5  # the one edge");
  options.cone_angles = {cli::parse_angle("2pi")};
  const structure::Report report = structure::solve(subject.triangulation, options);
  std::puts(report_as_json(subject, report).c_str());
  return report.outcome == structure::Outcome::kGeometric ? 0 : 1;
}
