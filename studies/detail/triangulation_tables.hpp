#pragma once

#include "studies/study.hpp"

namespace tripus::studies::detail {

/// What the one table of a triangulations study says.
Findings triangulations_findings(const std::vector<Table>& tables);

}  // namespace tripus::studies::detail
