// Which manifold it is: its signature, its isometries, its name in the census.
#include <cstdio>

#include "canonical/census.hpp"
#include "topology/isosig.hpp"

int main() {
  using namespace tripus;
  const topology::Triangulation tripus(topology::decode_isosig("cPcbbbihq"));
  const auto answer = canonical::canonize(tripus);
  std::puts(answer.message.c_str());
  if (!answer.manifold) return 1;  // no metric was found
  const auto& signature = answer.manifold->signature;
  std::printf("%s, %zu isometries\n", signature.oriented.c_str(),
              answer.manifold->isometries.order);
  const auto* entry = canonical::shipped_census().find(signature.unoriented);
  if (entry == nullptr) return 1;
  std::puts(entry->name.c_str());
  return 0;
}
