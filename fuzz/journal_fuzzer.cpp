#include <optional>
#include <sstream>
#include <vector>

#include "base/journal.hpp"
#include "canonical/census.hpp"
#include "fuzz/fuzzer.hpp"

// A line of a journal, written out again, is the same line; a census comes of them; and what is
// sealed is read back as it was.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tripus;
  std::vector<canonical::CensusLine> lines;
  std::istringstream text{std::string(fuzz::as_text(data, size))};
  for (std::string line, back; std::getline(text, line);) {
    fuzz::require(unseal(sealed(line), back) && back == line);
    (void)unseal(line, back);
    const auto read = canonical::parse_journal_line(line);
    if (!read) continue;
    const std::string written = canonical::to_journal(*read);
    const auto again = canonical::parse_journal_line(written);
    fuzz::require(again && canonical::to_journal(*again) == written);
    lines.push_back(*read);
  }
  try {
    (void)canonical::make_census(lines);
  } catch (const InvalidInput&) {
  }
  return 0;
}
