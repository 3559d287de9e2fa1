#include "fuzz/fuzzer.hpp"
#include "topology/diagrams/exterior.hpp"
#include "topology/diagrams/read_diagram.hpp"

// Every form of diagrams: what is read is written and read back, and has an exterior.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tripus;
  topology::NamedDiagram parsed;
  try {
    parsed = topology::read_diagram(fuzz::as_text(data, size));
  } catch (const InvalidInput&) {
    return 0;
  }
  if (parsed.diagram.node_count() > 1000) return 0;
  const topology::Diagram& diagram = parsed.diagram;
  fuzz::require(topology::read_diagram("PD: " + to_text(diagram)).diagram == diagram);
  fuzz::check_table(topology::exterior(diagram).gluings);
  return 0;
}
