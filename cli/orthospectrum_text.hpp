#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "cli/describe.hpp"
#include "orthospectrum/identities.hpp"
#include "orthospectrum/spectrum.hpp"
#include "structure/report.hpp"

namespace tripus::cli {

/// What `tripus orthospectrum` answers.
struct SpectrumAnswer {
  const Subject& subject;
  const structure::Report& report;
  orthospectrum::Spectrum spectrum;
  orthospectrum::Grouping grouping;
  orthospectrum::Identities identities;
  /// Lengths of the edges of the canonical decomposition, if they were asked for and found.
  std::optional<std::vector<double>> canonical_edges;
  bool words = false;  ///< each arc by itself
};

std::string spectrum_as_json(const SpectrumAnswer& answer);
std::string spectrum_as_text(const SpectrumAnswer& answer);
/// One line for each arc: length, boundary components, edge, both feet, radius of its discs, word.
void write_arc_table(std::ostream& out, const SpectrumAnswer& answer);

}  // namespace tripus::cli
