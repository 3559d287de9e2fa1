#include "fuzz/fuzzer.hpp"
#include "topology/formats/formats.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tripus;
  topology::NamedGluings parsed;
  try {
    parsed = topology::read_json(fuzz::as_text(data, size));
  } catch (const InvalidInput&) {
    return 0;
  }
  const auto again = topology::read_json(topology::write_json(parsed));
  fuzz::require(again.gluings == parsed.gluings && again.name == parsed.name);
  fuzz::check_table(parsed.gluings);
  return 0;
}
