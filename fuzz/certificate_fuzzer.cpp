#include "fuzz/fuzzer.hpp"
#include "structure/certificate.hpp"
#include "topology/isosig.hpp"

// What is read is written back the same, and can be checked against any triangulation.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tripus;
  static const topology::Triangulation triangulation(topology::decode_isosig("dLQbcbcaekw"));
  try {
    const auto certificate = structure::parse_certificate(fuzz::as_text(data, size));
    fuzz::require(structure::parse_certificate(structure::to_json(certificate)) == certificate);
    const auto result = structure::check(triangulation, certificate);
    fuzz::require(result.valid == result.reason.empty());
  } catch (const InvalidInput&) {
  }
  return 0;
}
