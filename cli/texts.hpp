#pragma once

#include <ostream>
#include <string>

#include "cli/describe.hpp"
#include "manifold/canonical_json.hpp"
#include "manifold/embedding_json.hpp"
#include "manifold/orthospectrum_json.hpp"
#include "manifold/report_json.hpp"
#include "structure/proof/prove_report.hpp"
#include "structure/report.hpp"
#include "structure/retriangulate.hpp"

namespace tripus::cli {

/// A few lines for people; `output` is the file written.
std::string embedding_as_text(const EmbeddedSubject& embedded, const std::string& output);

/// A canonical manifold for people, over several indented lines.
std::string manifold_as_text(const canonical::CanonicalManifold& manifold);

/// "cell 0 -> 1 (0 1 2 3 -> 1 0 2 3)", one a cell.
std::string cell_map_as_text(const canonical::CellMap& map);

/// An entry of a census.
std::string entry_as_text(const canonical::CensusEntry& entry);

std::string spectrum_as_text(const SpectrumAnswer& answer);
/// One line for each arc: length, boundary components, edge, both feet, radius of its discs, word.
void write_arc_table(std::ostream& out, const SpectrumAnswer& answer);

/// The JSON of `report_as_json` for people, over several lines.
std::string report_as_text(const Subject& subject, const structure::Report& report,
                           const structure::Retriangulation* retriangulation = nullptr,
                           const structure::ProofText* proof = nullptr);

/// The line for people of the report's certificate; empty if it has none.
std::string certificate_as_text(const structure::Report& report);

}  // namespace tripus::cli
