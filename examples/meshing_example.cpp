// The smallest use of meshing/README.md: a solid torus from its surface.
#include <cstdio>
#include <string>

#include "base/error.hpp"
#include "meshing/formats/read_mesh.hpp"
#include "meshing/manifold.hpp"
#include "topology/homology.hpp"
#include "topology/isosig.hpp"

using namespace tripus;
using namespace tripus::meshing;

namespace {

/// A square ring: the outline of a picture frame, 16 points and 32 triangles.
std::string frame() {
  std::string points, faces;
  const auto number = [](int depth, int ring, int corner) {
    return std::to_string(8 * depth + 4 * ring + corner % 4);
  };
  for (const char* z : {"0", "1"})
    for (const int reach : {3, 1})
      for (const int side : {0, 1, 2, 3})
        points += std::to_string(side % 3 == 0 ? -reach : reach) + " " +
                  std::to_string(side < 2 ? -reach : reach) + " " + z + "\n";
  const auto quad = [&](const std::string& a, const std::string& b, const std::string& c,
                        const std::string& d) {
    faces += "3 " + a + " " + b + " " + c + "\n3 " + a + " " + c + " " + d + "\n";
  };
  for (int i = 0; i < 4; ++i) {
    quad(number(0, 0, i), number(0, 0, i + 1), number(1, 0, i + 1), number(1, 0, i));
    quad(number(1, 0, i), number(1, 0, i + 1), number(1, 1, i + 1), number(1, 1, i));
    quad(number(1, 1, i), number(1, 1, i + 1), number(0, 1, i + 1), number(0, 1, i));
    quad(number(0, 1, i), number(0, 1, i + 1), number(0, 0, i + 1), number(0, 0, i));
  }
  return "OFF\n16 32 0\n" + points + faces;
}

std::string no_other_file(const std::string& name) { throw InvalidInput("no file " + name); }

}  // namespace

int main() {
  const std::string text = frame();
  const MeshFile file = read_mesh(text, "surface.off", no_other_file);
  const MeshedManifold solid = manifold_of(file);  // checks, fills, cones, simplifies
  std::puts(topology::isosig(solid.gluings).c_str());

  for (std::size_t i = 0; i < kStageCount; ++i)
    std::printf("%-10s %zu\n", std::string(stage_name(static_cast<MeshStage>(i))).c_str(),
                solid.tetrahedra[i]);
  const topology::Triangulation torus(solid.gluings);
  const bool ok = solid.boundary_genera == std::vector<int>{1} &&
                  topology::to_string(topology::first_homology(torus)) == "Z";
  return ok ? 0 : 1;
}
