#include "fuzz/fuzzer.hpp"
#include "topology/formats/formats.hpp"

// The whole entry: recognition, the reader it picks, and the list of a batch file.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tripus;
  const auto text = fuzz::as_text(data, size);
  std::size_t last = 0;
  for (const auto& line : topology::read_batch(text)) {
    fuzz::require(line.line_number > last && !line.text.empty());
    last = line.line_number;
  }
  const auto format = topology::detect_format(text);
  try {
    const auto parsed = topology::read_triangulation(text);
    fuzz::require(!format.empty() && format != topology::kGzip);
    fuzz::check_table(parsed.gluings);
  } catch (const InvalidInput&) {
  }
  return 0;
}
