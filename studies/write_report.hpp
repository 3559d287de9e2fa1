#pragma once

#include <string>
#include <vector>

#include "studies/study.hpp"

namespace tripus::studies {

/// What timings depend on.
struct Machine {
  std::string processor;  ///< model name, "unknown" where the system does not tell
  unsigned cores = 1;
  std::string compiler;
};

Machine this_machine();

/// What a report is made of.
struct ReportSource {
  const Study& study;
  const StudyOptions& options;
  unsigned threads = 1;
  const std::vector<Table>& tables;
  const Findings& findings;
};

/// Version, seed, options, machine, tables with their columns, findings and facts, as JSON.
std::string summary_json(const ReportSource& source);

/// One page with the findings, the figures as inline SVG and what is in the files: no scripts and
/// nothing to load.
std::string report_html(const ReportSource& source);

}  // namespace tripus::studies
