// Solids that touch themselves in edges and points: of cubes, whose corners are split so that cubes
// hang together across faces alone.
#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "meshing/mend.hpp"
#include "meshing/validate.hpp"

namespace tripus::meshing {
namespace {

using Place = std::array<int, 3>;

Place moved(Place p, int axis, int by) {
  p[static_cast<std::size_t>(axis)] += by;
  return p;
}

/// Cubes that hang together across faces.
std::set<Place> random_cubes(std::mt19937& random, std::size_t count) {
  std::set<Place> cubes{{0, 0, 0}};
  while (cubes.size() < count) {
    const auto from = std::next(cubes.begin(), std::ptrdiff_t(random() % cubes.size()));
    const Place next = moved(*from, int(random() % 3), random() % 2 == 0 ? 1 : -1);
    if (std::ranges::all_of(next, [](int x) { return x >= 0 && x < 3; })) cubes.insert(next);
  }
  return cubes;
}

struct Surface {
  SurfaceMesh mesh;
  std::size_t doubled = 0;  ///< points in one place with others
};

Surface surface_of(const std::set<Place>& cubes) {
  struct Side {
    Place cube;
    std::array<Place, 4> corners;  ///< counterclockwise from outside
  };
  std::vector<Side> sides;
  for (const Place& cube : cubes)
    for (int axis = 0; axis < 3; ++axis)
      for (const int by : {-1, 1}) {
        if (cubes.contains(moved(cube, axis, by))) continue;
        const Place low = by > 0 ? moved(cube, axis, 1) : cube;
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        Side side{cube, {low, moved(low, u, 1), moved(moved(low, u, 1), v, 1), moved(low, v, 1)}};
        if (by < 0) std::swap(side.corners[1], side.corners[3]);
        sides.push_back(side);
      }
  // Corners of two sides are one point if the sides share an edge there, and at an edge of four
  // sides also the cube.
  std::vector<std::size_t> root(4 * sides.size());
  std::iota(root.begin(), root.end(), std::size_t{0});
  const auto find = [&](std::size_t i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  std::map<std::pair<Place, Place>, std::vector<std::size_t>> at_edge;  // 4 side + k
  for (std::size_t s = 0; s < sides.size(); ++s)
    for (std::size_t k = 0; k < 4; ++k)
      at_edge[std::minmax(sides[s].corners[k], sides[s].corners[(k + 1) % 4])].push_back(4 * s + k);
  for (const auto& [edge, at] : at_edge)
    for (const std::size_t a : at)
      for (const std::size_t b : at) {
        if (at.size() == 4 && sides[a / 4].cube != sides[b / 4].cube) continue;
        for (std::size_t i = 0; i < 2; ++i)
          for (std::size_t j = 0; j < 2; ++j)
            if (sides[a / 4].corners[(a + i) % 4] == sides[b / 4].corners[(b + j) % 4])
              root[find(4 * (a / 4) + (a + i) % 4)] = find(4 * (b / 4) + (b + j) % 4);
      }
  Surface result;
  std::map<std::size_t, std::uint32_t> number;
  std::map<Place, std::size_t> copies;
  const auto point = [&](std::size_t corner) {
    const auto [entry, is_new] =
        number.try_emplace(find(corner), static_cast<std::uint32_t>(number.size()));
    if (is_new) {
      const Place& p = sides[corner / 4].corners[corner % 4];
      result.mesh.points.push_back({double(p[0]), double(p[1]), double(p[2])});
      ++copies[p];
    }
    return entry->second;
  };
  for (std::size_t s = 0; s < sides.size(); ++s) {
    const std::array<std::uint32_t, 4> c{point(4 * s), point(4 * s + 1), point(4 * s + 2),
                                         point(4 * s + 3)};
    result.mesh.triangles.push_back({c[0], c[1], c[2]});
    result.mesh.triangles.push_back({c[0], c[2], c[3]});
  }
  for (const auto& [place, count] : copies)
    if (count > 1) result.doubled += count;
  return result;
}

/// Whether numbers alone tell what belongs together: where other cubes join both ends of an edge of
/// four sides, they do not.
bool closes_up(const SurfaceMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
  for (const Triangle& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) ++sides[std::minmax(t[k], t[(k + 1) % 3])];
  return std::ranges::all_of(sides, [](const auto& side) { return side.second == 2; });
}

TEST(TouchingSheets, ArePartedAsTheFileHasThem) {
  std::mt19937 random(11);
  std::size_t touching = 0;
  for (int round = 0; round < 200; ++round) {
    const Surface given = surface_of(random_cubes(random, 6 + random() % 9));
    if (!closes_up(given.mesh)) continue;
    const SurfaceFile mended = mend({given.mesh, {}});
    const Region region = require_valid(mended.mesh, mended.lines);
    long euler = 0;
    for (const SurfaceComponent& component : region.components) euler += 2 - 2 * component.genus;
    ASSERT_EQ(euler, long(given.mesh.points.size()) - long(given.mesh.triangles.size() / 2))
        << round;
    ASSERT_EQ(mended.mesh.triangles.size(), given.mesh.triangles.size());
    if (given.doubled == 0) {
      EXPECT_TRUE(mended.notes.empty());
      continue;
    }
    ++touching;
    ASSERT_EQ(mended.notes.size(), 1u);
    EXPECT_EQ(mended.notes[0].find(std::to_string(given.doubled) + " points in one place"), 0u)
        << mended.notes[0];
    // By a small part of the cubes.
    for (std::size_t i = 0; i < given.mesh.points.size(); ++i)
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(mended.mesh.points[i][c], given.mesh.points[i][c], 0.04);
  }
  EXPECT_GT(touching, 40u);
}

// What touches in a place that the file has once is not for us to part.
TEST(TouchingSheets, AreRefusedWhereTheyShareThePoint) {
  std::set<Place> cubes{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {0, 1, 1}};
  SurfaceMesh mesh = surface_of(cubes).mesh;
  std::map<Point, std::uint32_t> first;
  for (std::uint32_t i = 0; i < mesh.points.size(); ++i) first.try_emplace(mesh.points[i], i);
  for (Triangle& t : mesh.triangles)
    for (std::uint32_t& corner : t) corner = first.at(mesh.points[corner]);
  const SurfaceFile mended = mend({mesh, {}});
  EXPECT_THROW((void)require_valid(mended.mesh, mended.lines), InvalidInput);
}

}  // namespace
}  // namespace tripus::meshing
