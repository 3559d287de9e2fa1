#pragma once

#include <ostream>
#include <string>

#include "manifold/orthospectrum_json.hpp"

namespace tripus::cli {

std::string spectrum_as_text(const SpectrumAnswer& answer);
/// One line for each arc: length, boundary components, edge, both feet, radius of its discs, word.
void write_arc_table(std::ostream& out, const SpectrumAnswer& answer);

}  // namespace tripus::cli
