#include <gtest/gtest.h>

#include "meshing/formats/formats.hpp"
#include "tests/support/sample_surfaces.hpp"

namespace tripus::meshing {
namespace {

TEST(MeshingOff, ReadsBackWhatItWrote) {
  const SurfaceMesh torus = testing::torus_surface(2, 1.0 / 3, 12, 9);
  EXPECT_EQ(read_off(write_off(torus)).mesh, torus);
  EXPECT_EQ(read_off(write_off({})).mesh, SurfaceMesh{});
}

TEST(MeshingOff, KnowsLinesAndSkipsCommentsAndColours) {
  const SurfaceFile file = read_off(
      "OFF 3 1 0 # all on one line\r\n0 0 0 255 0 0\n# between\n1 0 0\n0 +1 0\n\n3 0 1 2 0.5 0.5 "
      "1\n");
  EXPECT_EQ(file.mesh.points, (std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(file.mesh.triangles, (std::vector<Triangle>{{0, 1, 2}}));
  EXPECT_EQ(file.lines.points, (std::vector<std::uint32_t>{2, 4, 5}));
  EXPECT_EQ(file.lines.cells, (std::vector<std::uint32_t>{7}));
}

}  // namespace
}  // namespace tripus::meshing
