// Prints the volume of the tripus.
#include <cstdio>

#include "structure/solve.hpp"
#include "topology/isosig.hpp"

int main() {
  const auto report = tripus::structure::solve(
      tripus::topology::Triangulation(tripus::topology::decode_isosig("cPcbbbihq")));
  std::printf("%.17g\n", report.volume);
}
