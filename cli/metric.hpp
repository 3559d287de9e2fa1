#pragma once

#include <optional>

#include "cli/describe.hpp"
#include "cli/verb.hpp"
#include "structure/retriangulate.hpp"
#include "structure/solve.hpp"

namespace tripus::cli {

/// Whether, and how far, to look for another triangulation where one carries no metric.
struct MetricSearch {
  bool retriangulate = false;
  structure::RetriangulateOptions options;
};

/// Adds --retriangulate, --budget and --seed.
void add_metric_search(CLI::App& verb, MetricSearch& search);

/// A triangulation with what was found on it: the INPUT's, or another of its manifold.
struct Solved {
  Subject subject;
  structure::Report report;
  std::optional<structure::Retriangulation> retriangulation;  ///< if there was a search

  bool is_geometric() const { return report.outcome == structure::Outcome::kGeometric; }
  const structure::Retriangulation* search() const {
    return retriangulation ? &*retriangulation : nullptr;
  }
};

/// Solves with the subject's cone angles, and searches on where there is no metric and it was asked
/// for: what is found has cone angles of its own. Heeds interrupts.
Solved find_metric(Subject subject, structure::SolveOptions options, const MetricSearch& search);

}  // namespace tripus::cli
