#include "fuzz/fuzzer.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    tripus::fuzz::check_table(tripus::topology::decode_isosig(tripus::fuzz::as_text(data, size)));
  } catch (const tripus::InvalidInput&) {
  }
  return 0;
}
