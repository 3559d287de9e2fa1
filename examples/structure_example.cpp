// From a signature to a verdict.
#include <cstdio>

#include "structure/solve.hpp"
#include "topology/isosig.hpp"

int main() {
  using namespace tripus;
  const topology::Triangulation manifold(topology::decode_isosig("cPcbbbihq"));
  const structure::Report report = structure::solve(manifold);
  std::puts(report.message.c_str());
  for (const structure::VertexReport& vertex : report.vertices)
    std::printf("geodesic boundary of genus %d, area %.12f\n", vertex.genus, vertex.area);
  return report.outcome == structure::Outcome::kGeometric ? 0 : 1;
}
