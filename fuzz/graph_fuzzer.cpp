#include "base/error.hpp"
#include "fuzz/fuzzer.hpp"
#include "meshing/formats/read_graph.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tripus;
  try {
    const auto graph = meshing::read_graph(fuzz::as_text(data, size));
    // JSON may say anything; what was put together from pieces has edges of two points or more.
    if (size > 0 && data[0] != '{')
      for (const auto& edge : graph.edges) fuzz::require(edge.size() != 1);
  } catch (const InvalidInput&) {
  }
  return 0;
}
