#pragma once

#include "studies/study.hpp"

namespace tripus::studies::detail {

/// Tables of the stability study, in this order.
enum StabilityTable : std::size_t { kThresholds, kAngles, kStarts, kIrregular, kFlowThresholds };

/// What the tables of a stability study say.
Findings stability_findings(const std::vector<Table>& tables);

}  // namespace tripus::studies::detail
