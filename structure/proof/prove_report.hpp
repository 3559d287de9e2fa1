#pragma once

#include <string>

#include "structure/proof/proof_text.hpp"
#include "structure/report.hpp"

namespace tripus::structure {

struct ProveReportOptions {
  int digits = 0;                                     ///< 0 for doubles, else as prove_digits
  std::vector<topology::ConeAngle> cone_angles = {};  ///< [E] of the report; empty for 2 pi
};

/// The proof that goes with a report: of the metric where it is geometric, of a minimiser with flat
/// tetrahedra where it is degenerate; otherwise not proved, with the reason.
ProofText prove_report(const topology::Triangulation& triangulation, const Report& report,
                       const ProveReportOptions& options = {}, const Context& context = {});

/// One sentence for a person: what is proved, or why not.
std::string proof_message(const ProofText& proof);

}  // namespace tripus::structure
