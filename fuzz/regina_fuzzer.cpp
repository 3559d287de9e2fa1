#include "fuzz/fuzzer.hpp"
#include "topology/formats/regina.hpp"

namespace {

using Reader = tripus::topology::NamedGluings (*)(std::string_view);

void run(Reader read, std::string_view text) {
  using namespace tripus;
  topology::NamedGluings parsed;
  try {
    parsed = read(text);
  } catch (const InvalidInput&) {
    return;
  }
  const auto again = topology::read_regina_table(topology::write_regina_table(parsed));
  fuzz::require(again.gluings == parsed.gluings);
  fuzz::check_table(parsed.gluings);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto text = tripus::fuzz::as_text(data, size);
  run(tripus::topology::read_regina_xml, text);
  run(tripus::topology::read_regina_table, text);
  return 0;
}
