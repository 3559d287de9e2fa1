#pragma once

#include "studies/study.hpp"

namespace tripus::studies::detail {

/// Tables of the study of the paper's experiment, in this order.
enum PaperTable : std::size_t { kManifolds };

/// What they say.
Findings paper_findings(const std::vector<Table>& tables);

}  // namespace tripus::studies::detail
