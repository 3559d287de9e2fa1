#include "fuzz/fuzzer.hpp"
#include "topology/formats/formats.hpp"

namespace {

using namespace tripus;

void check(const topology::NamedGluings& parsed) {
  const auto again = topology::read_regina_table(topology::write_regina_table(parsed));
  fuzz::require(again.gluings == parsed.gluings);
  const auto rewritten = topology::read_regina_xml(topology::write_regina_xml(parsed));
  fuzz::require(rewritten.size() == 1 && rewritten[0].gluings == parsed.gluings);
  fuzz::check_table(parsed.gluings);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto text = fuzz::as_text(data, size);
  try {
    for (const auto& each : topology::read_regina_xml(text)) check(each);
  } catch (const InvalidInput&) {
  }
  try {
    check(topology::read_regina_table(text));
  } catch (const InvalidInput&) {
  }
  return 0;
}
