#pragma once

#include <string>

#include "manifold/subject.hpp"
#include "structure/proof/proof_text.hpp"
#include "structure/report.hpp"
#include "structure/retriangulate.hpp"

namespace tripus {

/// The JSON of `tripus solve`, with its keys in the documented order; no line end. After a
/// retriangulation, subject and report are those of the triangulation that it ended with; a proof
/// is added if there is one.
std::string report_as_json(const Subject& subject, const structure::Report& report,
                           const structure::Retriangulation* retriangulation = nullptr,
                           const structure::ProofText* proof = nullptr);

}  // namespace tripus
