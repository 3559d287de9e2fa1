#pragma once

#include "studies/study.hpp"

namespace tripus::studies::detail {

Plan plan_convergence(const StudyOptions& options);
Plan plan_triangulations(const StudyOptions& options);
Plan plan_stability(const StudyOptions& options);
Plan plan_paper(const StudyOptions& options);
Plan plan_valence(const StudyOptions& options);

}  // namespace tripus::studies::detail
