#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/journal.hpp"
#include "canonical/census.hpp"

namespace tripus::cli {

/// The isomorphism signature of what a line of a list, an INPUT, names. Throws InvalidInput.
std::string signature_of_line(const std::string& text);

/// The lines of earlier runs. Throws InvalidInput with the place of what is none.
std::vector<canonical::CensusLine> lines_of(const Journal& journal);

/// How many lines of a census ended how.
struct LineCounts {
  std::size_t own = 0, moved = 0, unresolved = 0, refused = 0;
};
LineCounts count_lines(const std::vector<canonical::CensusLine>& lines);

}  // namespace tripus::cli
