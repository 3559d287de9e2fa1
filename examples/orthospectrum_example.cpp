// The arcs of the tripus up to length 4.
#include <cstdio>

#include "orthospectrum/spectrum.hpp"
#include "structure/solve.hpp"
#include "topology/isosig.hpp"

int main() {
  using namespace tripus;
  const topology::Triangulation triangulation(topology::decode_isosig("cPcbbbihq"));
  const structure::Report report = structure::solve(triangulation);
  orthospectrum::SpectrumOptions options;
  options.length = 4;
  const auto spectrum = orthospectrum::orthospectrum(triangulation, report.edge_lengths, options);
  for (const auto& group : orthospectrum::group_arcs(spectrum, triangulation).groups)
    std::printf("%.12g %zu\n", group.length, group.multiplicity);
  return spectrum.arc_count == 1 + 4 + 12 + 12 ? 0 : 1;
}
