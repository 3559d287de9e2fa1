// The surface of a ball with one straight pipe through it: meshing/tube/README.md.
#include <iostream>

#include "meshing/formats/formats.hpp"
#include "meshing/tube/tube_surface.hpp"

int main() {
  using namespace tripus::meshing;
  const SpatialGraph graph = read_spatial_graph(
      R"({"edges": [[[0,0,-3], [0,0,-1], [0,0,1], [0,0,3]]],
          "outer": {"sphere": {"center": [0,0,0], "radius": 2}}})");
  const Tube tube = make_tube(graph, {.radius = 0.5, .triangles = 2000});
  std::cout << write_off(tube.surface);
  return tube.euler_characteristics == std::vector<long>{0} ? 0 : 1;  // a torus
}
