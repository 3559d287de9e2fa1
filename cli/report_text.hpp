#pragma once

#include <string>

#include "cli/describe.hpp"
#include "manifold/report_json.hpp"
#include "structure/proof/prove_report.hpp"
#include "structure/report.hpp"
#include "structure/retriangulate.hpp"

namespace tripus::cli {

/// The JSON of `report_as_json` for people, over several lines.
std::string report_as_text(const Subject& subject, const structure::Report& report,
                           const structure::Retriangulation* retriangulation = nullptr,
                           const structure::ProofText* proof = nullptr);

}  // namespace tripus::cli
