#pragma once

#include <string>

#include "cli/describe.hpp"
#include "structure/report.hpp"
#include "structure/proof/prove_report.hpp"
#include "structure/retriangulate.hpp"

namespace tripus::cli {

/// The JSON of `tripus solve`, with its keys in the documented order; no line end. After a
/// retriangulation, subject and report are those of the triangulation that it ended with; a proof is
/// added if there is one.
std::string report_as_json(const Subject& subject, const structure::Report& report,
                           const structure::Retriangulation* retriangulation = nullptr,
                           const structure::ProofText* proof = nullptr);

/// The same for people, over several lines.
std::string report_as_text(const Subject& subject, const structure::Report& report,
                           const structure::Retriangulation* retriangulation = nullptr,
                           const structure::ProofText* proof = nullptr);

}  // namespace tripus::cli
