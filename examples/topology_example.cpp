// The smallest use of tripus::topology: what is the knotted Y?
#include <cstdio>

#include "topology/formats/formats.hpp"
#include "topology/homology.hpp"
#include "topology/isosig.hpp"
#include "topology/requirements.hpp"

int main() {
  using namespace tripus::topology;
  const auto input = read_triangulation(
      R"({"name": "knotted-Y", "gluings": [[[1,"1230"],[1,"3012"],[1,"0321"],[1,"0213"]],
                                           [[0,"1230"],[0,"3012"],[0,"0321"],[0,"0213"]]]})");
  const Triangulation manifold(input.gluings);
  require_solvable(manifold);
  std::printf("%s: %zu tetrahedra, %zu edge, boundary of genus %d, H1 = %s, signature %s\n",
              input.name.c_str(), manifold.tetrahedron_count(), manifold.edge_count(),
              manifold.link(0).genus(), to_string(first_homology(manifold)).c_str(),
              isosig(manifold.gluings()).c_str());
  return isosig(manifold.gluings()) == "cPcbbbihq" ? 0 : 1;
}
