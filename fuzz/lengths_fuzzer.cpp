#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "cli/files.hpp"
#include "fuzz/fuzzer.hpp"

// The same text as lengths and as an angle: what one lets through, written out, reads the same.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tripus;
  const std::string_view text = fuzz::as_text(data, size);
  try {
    const std::vector<double> lengths = cli::parse_lengths(text);
    std::string written;
    char number[32];
    for (const double length : lengths) {
      std::snprintf(number, sizeof number, "%.17g ", length);
      written += number;
    }
    const std::vector<double> again = cli::parse_lengths(written);
    fuzz::require(again.size() == lengths.size());
    for (std::size_t i = 0; i < lengths.size(); ++i)
      fuzz::require(again[i] == lengths[i] || (std::isnan(again[i]) && std::isnan(lengths[i])));
  } catch (const InvalidInput&) {
    // What is refused is refused with a message; anything else is a crash.
  }
  try {
    fuzz::require(std::isfinite(cli::parse_angle(text)));
  } catch (const InvalidInput&) {
  }
  return 0;
}
