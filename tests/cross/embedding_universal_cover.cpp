// Law E5 of embedding/README.md: the universal cover against brute force and against itself.
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "embedding/universal_cover.hpp"
#include "tests/support/embedded_manifolds.hpp"
#include "topology/cyclic_cover.hpp"

namespace tripus::embedding {
namespace {

using testing::Embedded;

/// Cells by the cube of side 1 in which the spatial part of their centre lies: an index that shares
/// nothing with the library's.
class CellIndex {
 public:
  explicit CellIndex(std::span<const Cell> cells) : cells_(cells) {
    for (std::size_t c = 0; c < cells.size(); ++c) index_.emplace(key(centre(c)), c);
  }
  Vector4 centre(std::size_t c) const { return cells_[c].isometry.col(3); }
  /// The cells with a centre within a distance.
  std::vector<std::size_t> near(const Vector4& point, double distance) const {
    std::vector<std::size_t> found;
    const auto at = key(point);
    for (long x = -1; x <= 1; ++x)
      for (long y = -1; y <= 1; ++y)
        for (long z = -1; z <= 1; ++z) {
          const auto range = index_.equal_range({at[0] + x, at[1] + y, at[2] + z});
          for (auto it = range.first; it != range.second; ++it)
            if ((centre(it->second) - point).head<3>().norm() < distance)
              found.push_back(it->second);
        }
    return found;
  }

 private:
  static std::array<long, 3> key(const Vector4& point) {
    return {std::lround(point[0]), std::lround(point[1]), std::lround(point[2])};
  }
  std::span<const Cell> cells_;
  std::multimap<std::array<long, 3>, std::size_t> index_;
};

/// Largest hyperbolic distance between the corners of common faces as their two cells see them.
double matching_error(const Embedded& m, std::span<const Cell> cells, double radius,
                      std::size_t* pairs) {
  const CellIndex index(cells);
  const topology::Gluings& gluings = m.triangulation.gluings();
  double worst = 0;
  for (const Cell& cell : cells) {
    if (std::acosh(cell.isometry(3, 3)) > radius) continue;
    for (int f = 0; f < 4; ++f) {
      const std::uint32_t other = gluings.neighbour(cell.tetrahedron, f);
      const topology::Perm4 p = gluings.gluing(cell.tetrahedron, f);
      const Matrix4 beside =
          cell.isometry * m.embedding.face_pairings[cell.tetrahedron][static_cast<std::size_t>(f)];
      for (const std::size_t c : index.near(beside.col(3), 0.05)) {
        EXPECT_EQ(cells[c].tetrahedron, other);
        ++*pairs;
        for (int i = 0; i < 4; ++i) {
          for (int j = 0; j < 4; ++j) {
            if (i == j || i == f || j == f) continue;
            const Vector4 here =
                cell.isometry * geometry::corner(m.embedding.tetrahedra[cell.tetrahedron], i, j);
            const Vector4 there =
                cells[c].isometry * geometry::corner(m.embedding.tetrahedra[other], p(i), p(j));
            worst = std::max(worst, geometry::hyperbolic_distance(geometry::on_hyperboloid(here),
                                                                  geometry::on_hyperboloid(there)));
          }
        }
      }
    }
  }
  return worst;
}

TEST(UniversalCover, HoldsEachCellOnce) {
  for (const char* name : {"cPcbbbihq", "cMcabbjdw", "dLQbcccdhkw", "eLPkbcdddhjoow"}) {
    const auto m = testing::try_embed(name);
    ASSERT_TRUE(m) << name;
    UniversalCoverOptions options;
    options.max_cells = 1000;
    const auto cells = universal_cover(m->embedding, m->triangulation, options);
    ASSERT_EQ(cells.size(), 1000u);
    // Pairwise, without any index.
    for (std::size_t a = 0; a < cells.size(); ++a)
      for (std::size_t b = 0; b < a; ++b)
        ASSERT_GT((cells[a].isometry.col(3) - cells[b].isometry.col(3)).norm(), 1e-3)
            << name << ' ' << a << ' ' << b;
  }
}

TEST(UniversalCover, FacesMatchWithinRadiusTen) {
  const Embedded tripus = testing::embedded_tripus();
  UniversalCoverOptions options;
  options.max_cells = 100'000;
  const auto cells = universal_cover(tripus.embedding, tripus.triangulation, options);
  ASSERT_EQ(cells.size(), 100'000u);
  const CellIndex index(cells);
  for (std::size_t c = 0; c < cells.size(); ++c)
    ASSERT_EQ(index.near(index.centre(c), 0.05).size(), 1u) << c;
  std::size_t pairs = 0;
  EXPECT_LT(matching_error(tripus, cells, 10, &pairs), 1e-8);
  EXPECT_GT(pairs, 100'000u);
}

TEST(UniversalCover, FacesMatchFarFromTheRoot) {
  // A long way straight out: depth 60 and beyond, where drift would show.
  const Embedded tripus = testing::embedded_tripus();
  Matrix4 place = Matrix4::Identity();
  std::vector<Cell> path{{0, place, 0, kNoCell}};
  const topology::Gluings& gluings = tripus.triangulation.gluings();
  std::uint32_t t = 0;
  for (std::uint32_t depth = 1; std::acosh(place(3, 3)) < 10; ++depth) {
    // The face farthest from the root.
    int out = 0;
    for (int f = 1; f < 4; ++f) {
      const auto& pairings = tripus.embedding.face_pairings[t];
      if ((place * pairings[std::size_t(f)])(3, 3) > (place * pairings[std::size_t(out)])(3, 3))
        out = f;
    }
    place = geometry::reorthogonalised(
        place * tripus.embedding.face_pairings[t][static_cast<std::size_t>(out)]);
    t = gluings.neighbour(t, out);
    path.push_back({t, place, depth, depth - 1});
  }
  std::size_t pairs = 0;
  EXPECT_LT(matching_error(tripus, path, 12, &pairs), 1e-8);
  EXPECT_GE(pairs, 2 * (path.size() - 1));
}

TEST(UniversalCover, ParentsComeFirstAndAreBeside) {
  const auto m = testing::try_embed("dLQbcccdhkw");
  UniversalCoverOptions options;
  options.max_cells = 500;
  const auto cells = universal_cover(m->embedding, m->triangulation, options);
  EXPECT_EQ(cells[0].parent, kNoCell);
  EXPECT_EQ(cells[0].isometry, Matrix4::Identity());
  double last = 0;
  for (std::size_t c = 1; c < cells.size(); ++c) {
    ASSERT_LT(cells[c].parent, c);
    const Cell& parent = cells[cells[c].parent];
    EXPECT_EQ(cells[c].depth, parent.depth + 1);
    double nearest = 1;
    for (int f = 0; f < 4; ++f) {
      if (m->triangulation.gluings().neighbour(parent.tetrahedron, f) != cells[c].tetrahedron)
        continue;
      const Matrix4 beside =
          parent.isometry *
          m->embedding.face_pairings[parent.tetrahedron][static_cast<std::size_t>(f)];
      nearest = std::min(nearest, (beside - cells[c].isometry).norm());
    }
    EXPECT_LT(nearest, 1e-9);
    last = std::max(last, cells[c].isometry(3, 3));
  }
  // A smaller cover is the beginning of a larger one.
  options.max_cells = 100;
  const auto fewer = universal_cover(m->embedding, m->triangulation, options);
  for (std::size_t c = 0; c < fewer.size(); ++c)
    EXPECT_EQ(fewer[c].isometry, cells[c].isometry) << c;
}

TEST(UniversalCover, DepthsAreThoseOfTheGroup) {
  // Around each edge of the tripus there are 12 cells, so up to depth 5 the cover is a tree with 4,
  // 3, 3, ... branches; at depth 6 each of the 6 edges of the root closes: 12 ways become 6 cells.
  const Embedded tripus = testing::embedded_tripus();
  const std::size_t expected[] = {1, 5, 17, 53, 161, 485, 1451};
  for (std::uint32_t depth = 0; depth < 7; ++depth) {
    UniversalCoverOptions options;
    options.max_depth = depth;
    const UniversalCover cover =
        grow_universal_cover(tripus.embedding, tripus.triangulation, options);
    EXPECT_EQ(cover.cells.size(), expected[depth]);
    EXPECT_EQ(cover.end, CoverEnd::kComplete);
  }
}

TEST(UniversalCover, OfACoverIsThatOfTheManifold) {
  const Embedded tripus = testing::embedded_tripus();
  const topology::Triangulation cover(topology::cyclic_cover(
      tripus.triangulation.gluings(), *topology::primitive_class(tripus.triangulation), 5));
  const structure::Report report = structure::solve(cover);
  const Embedding embedded = embed(cover, report.edge_lengths);
  for (const std::uint32_t root : {0u, 7u}) {
    UniversalCoverOptions options;
    options.max_depth = 8;
    options.root = root;
    EXPECT_EQ(universal_cover(embedded, cover, options).size(),
              universal_cover(tripus.embedding, tripus.triangulation, {.max_depth = 8}).size());
  }
}

TEST(UniversalCover, RadiusCoversTheBall) {
  const auto m = testing::try_embed("dLQbcccdhkw");
  UniversalCoverOptions options;
  options.max_radius = 2.5;
  const auto cells = universal_cover(m->embedding, m->triangulation, options);
  // Every centre within the radius among many more cells is there, and none twice.
  UniversalCoverOptions many;
  many.max_cells = 20'000;
  const auto all = universal_cover(m->embedding, m->triangulation, many);
  const CellIndex index(cells);
  ASSERT_GT(std::acosh(all.back().isometry(3, 3)), 3.0);
  std::size_t inside = 0;
  for (const Cell& cell : all) {
    if (std::acosh(cell.isometry(3, 3)) > options.max_radius) continue;
    ++inside;
    EXPECT_EQ(index.near(cell.isometry.col(3), 1e-6).size(), 1u);
  }
  EXPECT_GT(inside, 20u);
  EXPECT_GE(cells.size(), inside);
}

}  // namespace
}  // namespace tripus::embedding
