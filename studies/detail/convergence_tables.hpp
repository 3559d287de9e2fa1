#pragma once

#include "studies/study.hpp"

namespace tripus::studies::detail {

/// Tables of the convergence study, in this order.
enum ConvergenceTable : std::size_t { kRuns, kIterations, kTheory };

std::vector<TableLayout> convergence_layouts();

/// What the tables of a convergence study say.
Findings convergence_findings(const std::vector<Table>& tables);

}  // namespace tripus::studies::detail
