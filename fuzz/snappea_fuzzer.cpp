#include "fuzz/fuzzer.hpp"
#include "topology/formats/formats.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tripus;
  topology::NamedGluings parsed;
  try {
    parsed = topology::read_snappea(fuzz::as_text(data, size));
    // The format has no open faces, so what the reader leaves open is none.
    topology::require_consistent(parsed.gluings, topology::OpenFaces::kRefused);
  } catch (const InvalidInput&) {
    return 0;
  }
  const auto again = topology::read_snappea(topology::write_snappea(parsed));
  fuzz::require(again.gluings == parsed.gluings);
  fuzz::check_table(parsed.gluings);
  return 0;
}
