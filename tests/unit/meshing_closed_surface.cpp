#include <gtest/gtest.h>

#include "meshing/detail/closed_surface.hpp"

namespace {

using namespace tripus;
using meshing::Triangle;
using meshing::detail::doubled_characteristics;
using meshing::detail::manifold_fault;

/// The boundary of a tetrahedron with these corners.
std::vector<Triangle> shell_of(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  return {{a, b, c}, {a, c, d}, {a, d, b}, {b, d, c}};
}

std::vector<Triangle> together(std::vector<Triangle> one, const std::vector<Triangle>& two) {
  one.insert(one.end(), two.begin(), two.end());
  return one;
}

TEST(ClosedSurface, AShellHasNoFault) {
  EXPECT_EQ(manifold_fault(shell_of(0, 1, 2, 3), 4), "");
  EXPECT_EQ(manifold_fault(together(shell_of(0, 1, 2, 3), shell_of(4, 5, 6, 7)), 9),
            "");  // 8 is unused
}

TEST(ClosedSurface, NamesTheEdgeOrVertexThatIsWrong) {
  std::vector<Triangle> open = shell_of(0, 1, 2, 3);
  open.pop_back();
  EXPECT_EQ(manifold_fault(open, 4), "edge 1-2 is open");
  EXPECT_EQ(manifold_fault(together(shell_of(0, 1, 2, 3), {{0, 1, 4}}), 5), "edge 0-1 twice");
  EXPECT_EQ(manifold_fault(together(shell_of(0, 1, 2, 3), shell_of(3, 4, 5, 6)), 7),
            "vertex 3 is pinched");
}

TEST(ClosedSurface, CountsTheCharacteristicOfEachComponent) {
  // A torus of 3 x 3 squares beside a sphere.
  std::vector<Triangle> torus;
  const auto at = [](std::uint32_t i, std::uint32_t j) { return 3 * (i % 3) + j % 3; };
  for (std::uint32_t i = 0; i < 3; ++i)
    for (std::uint32_t j = 0; j < 3; ++j) {
      torus.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      torus.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  const std::vector<Triangle> triangles = together(torus, shell_of(9, 10, 11, 12));
  ASSERT_EQ(manifold_fault(triangles, 13), "");
  topology::DisjointSets sets(13);
  const auto found = doubled_characteristics(triangles, sets);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found.at(sets.root(0)), 0);
  EXPECT_EQ(found.at(sets.root(9)), 4);
}

TEST(DisjointSets, JoinsAndTellsWhatHangsTogether) {
  topology::DisjointSets sets(5);
  EXPECT_TRUE(sets.join(0, 1));
  EXPECT_TRUE(sets.join(3, 4));
  EXPECT_TRUE(sets.join(1, 4));
  EXPECT_FALSE(sets.join(0, 3));
  EXPECT_EQ(sets.root(0), sets.root(4));
  EXPECT_NE(sets.root(0), sets.root(2));
  EXPECT_EQ(sets.add(), 5u);
  EXPECT_EQ(sets.root(5), 5u);
  EXPECT_EQ(sets.size(), 6u);
}

}  // namespace
