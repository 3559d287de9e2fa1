#include <cmath>

#include "canonical/census.hpp"
#include "fuzz/fuzzer.hpp"

// A census that was read, written out, reads the same; nothing in it is NaN, and every query ends.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tripus;
  try {
    const canonical::Census census = canonical::parse_tsv(fuzz::as_text(data, size));
    for (const canonical::CensusEntry& entry : census.manifolds) {
      fuzz::require(std::isfinite(entry.volume));
      fuzz::require(!entry.name.empty() && !entry.signature.empty());
      fuzz::require(!entry.triangulations.empty());
      fuzz::require(census.find(entry.name) != nullptr);
    }
    fuzz::require(canonical::select(census, {.least_volume = -HUGE_VAL}).size() ==
                  census.manifolds.size());
    // Written with 15 digits, so that the second text is the one to compare with.
    const std::string text = canonical::to_tsv(census);
    const canonical::Census again = canonical::parse_tsv(text);
    fuzz::require(again.manifolds.size() == census.manifolds.size());
    fuzz::require(canonical::to_tsv(again) == text);
  } catch (const InvalidInput&) {
    // What is refused is refused with a message; anything else is a crash.
  }
  return 0;
}
