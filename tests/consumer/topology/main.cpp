// Prints the first homology of the tripus.
#include <cstdio>

#include "topology/homology.hpp"
#include "topology/isosig.hpp"

int main() {
  using namespace tripus::topology;
  const Triangulation tripus(decode_isosig("cPcbbbihq"));
  std::printf("%s\n", to_string(first_homology(tripus)).c_str());
}
