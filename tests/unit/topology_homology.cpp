#include <algorithm>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "topology/cyclic_cover.hpp"
#include "topology/detail/smith_form.hpp"
#include "topology/dual_graph.hpp"
#include "topology/homology.hpp"
#include "topology/isosig.hpp"

namespace tripus::topology {
namespace {

std::string h1(const std::string& signature) {
  return to_string(first_homology(Triangulation(decode_isosig(signature))));
}

// `Triangulation3.homology()` of Regina 7.3 for its own examples.
TEST(Homology, OfKnownManifolds) {
  EXPECT_EQ(h1("cPcbbbihq"), "2 Z");           // the tripus
  EXPECT_EQ(h1("cPcbbbiht"), "Z");             // figure eight knot complement
  EXPECT_EQ(h1("bkaagj"), "0");                // a 3-sphere
  EXPECT_EQ(h1("cPcbbbihqcPcbbbiht"), "3 Z");  // a disjoint union adds
}

TEST(AbelianGroup, IsWrittenAsReginaWritesIt) {
  EXPECT_EQ(to_string(AbelianGroup{}), "0");
  EXPECT_EQ(to_string(AbelianGroup{1, {}}), "Z");
  EXPECT_EQ(to_string(AbelianGroup{2, {"3"}}), "2 Z + Z_3");
  EXPECT_EQ(to_string(AbelianGroup{0, {"2", "2", "6"}}), "2 Z_2 + Z_6");
}

// diag(2, 3) is equivalent to diag(1, 6); big entries must not overflow.
TEST(SmithForm, MakesFactorsDivideOneAnother) {
  const auto form = detail::smith_form({{{0, 2}}, {{1, 3}}, {}}, 4);
  EXPECT_EQ(form.rank, 2u);
  ASSERT_EQ(form.factors.size(), 1u);
  EXPECT_EQ(form.factors[0], 6);
}

TEST(SmithForm, NumbersOutgrowSixtyFourBits) {
  // x_{i+1} = 10^6 x_i for six steps, and 7 x_6 = 0 beside 10^6 x_6 = x_0.
  constexpr std::int64_t kStep = 1000000;
  std::vector<detail::SparseRow<std::int64_t>> rows;
  for (std::uint32_t i = 0; i < 6; ++i) rows.push_back({{i, kStep}, {i + 1, -1}});
  rows.push_back({{0, -1}, {6, kStep}});
  const auto form = detail::smith_form(rows, 7);
  EXPECT_EQ(form.rank, 7u);
  ASSERT_EQ(form.factors.size(), 1u);  // determinant 10^42 - 1
  EXPECT_EQ(to_decimal(form.factors[0]), std::string(42, '9'));
}

/// Row and column operations on a diagonal matrix, which its Smith form does not see.
std::vector<detail::SparseRow<std::int64_t>> disguised(const std::vector<std::int64_t>& diagonal,
                                                       std::size_t height, std::size_t width,
                                                       std::mt19937& random) {
  std::vector<std::vector<std::int64_t>> dense(height, std::vector<std::int64_t>(width, 0));
  for (std::size_t i = 0; i < diagonal.size(); ++i) dense[i][i] = diagonal[i];
  const auto pick = [&](std::size_t count) { return random() % count; };
  for (std::size_t step = 0; step < 3 * (height + width); ++step) {
    const std::int64_t factor = random() % 2 == 0 ? 1 : -1;
    if (const auto a = pick(height), b = pick(height); a != b)
      for (std::size_t j = 0; j < width; ++j) dense[a][j] += factor * dense[b][j];
    if (const auto a = pick(width), b = pick(width); a != b)
      for (auto& row : dense) row[a] += factor * row[b];
  }
  std::vector<detail::SparseRow<std::int64_t>> rows(height);
  for (std::size_t i = 0; i < height; ++i)
    for (std::uint32_t j = 0; j < width; ++j)
      if (dense[i][j] != 0) rows[i].push_back({j, dense[i][j]});
  return rows;
}

TEST(SmithForm, IsThatOfADisguisedDiagonal) {
  std::mt19937 random(20261130);
  for (int trial = 0; trial < 400; ++trial) {
    SCOPED_TRACE(trial);
    const std::size_t height = 1 + random() % 9, width = 1 + random() % 14;
    const std::size_t rank = random() % (std::min(height, width) + 1);
    std::vector<std::int64_t> diagonal;
    std::int64_t factor = trial % 3 == 0 ? 1 : 1 + static_cast<std::int64_t>(random() % 6);
    for (std::size_t i = 0; i < rank; ++i) {
      diagonal.push_back(factor);
      if (random() % 3 == 0) factor *= 1 + static_cast<std::int64_t>(random() % 12);
    }
    const auto form = detail::smith_form(disguised(diagonal, height, width, random), width);
    EXPECT_EQ(form.rank, rank);
    std::vector<std::string> expected, found;
    for (const std::int64_t d : diagonal)
      if (d > 1) expected.push_back(std::to_string(d));
    for (const auto& d : form.factors) found.push_back(to_decimal(d));
    EXPECT_EQ(found, expected);
  }
}

// No entry is a unit, and nearly all minors are 0.
TEST(SmithForm, OfManyEqualFactors) {
  constexpr std::uint32_t kCount = 200;
  std::vector<detail::SparseRow<std::int64_t>> rows;
  for (std::uint32_t i = 0; i < kCount; ++i) rows.push_back({{i, 6}});
  const auto form = detail::smith_form(rows, kCount);
  EXPECT_EQ(form.rank, kCount);
  EXPECT_EQ(form.factors, std::vector<BigInteger>(kCount, 6));
}

TEST(DualGraph, SpanningForestHasAParentForAllButOne) {
  const Gluings gluings = decode_isosig("eLAkbccdddprdkcPcbbbihq");
  const SpanningForest forest = spanning_forest(gluings);
  EXPECT_EQ(forest.component_count, 2u);
  EXPECT_FALSE(is_connected(gluings));
  EXPECT_EQ(forest.order.size(), 6u);
  std::size_t roots = 0;
  for (std::size_t t = 0; t < 6; ++t) {
    if (forest.parent[t] == kNoTetrahedron)
      ++roots;
    else
      EXPECT_EQ(gluings.neighbour(forest.parent[t], forest.face[t]), t);
  }
  EXPECT_EQ(roots, 2u);
}

// Long strips of relators are the hard case for elimination; labels must not matter.
TEST(Homology, OfALongCoverWithAnyLabels) {
  const Triangulation base(decode_isosig("cPcbbbihq"));
  const Gluings cover = cyclic_cover(base.gluings(), *primitive_class(base), 4000);
  EXPECT_EQ(to_string(first_homology(Triangulation(cover))), "4001 Z");
  EXPECT_EQ(to_string(first_homology(Triangulation(random_relabelling(cover, 1)))), "4001 Z");
}

// H1 of the n-fold cyclic cover of the figure-eight knot's complement is Z + coker(A^n - 1) with A
// = (2 1; 1 1), whose powers are Fibonacci numbers: Z_L + Z_L with the Lucas number L_n for odd n,
// Z_F + Z_5F with the Fibonacci number F_n for even n.
TEST(Homology, OfCoversWithLongTorsion) {
  const Triangulation base(decode_isosig("cPcbbbiht"));
  const auto shifts = *primitive_class(base);
  std::vector<BigInteger> fibonacci{0, 1};
  while (fibonacci.size() <= 5001)
    fibonacci.push_back(fibonacci.back() + fibonacci[fibonacci.size() - 2]);
  std::vector<std::size_t> degrees{999, 1000, 5000};
  for (std::size_t n = 1; n <= 150; ++n) degrees.push_back(n);
  for (const std::size_t n : degrees) {
    const BigInteger lucas = fibonacci[n - 1] + fibonacci[n + 1], &f = fibonacci[n];
    std::vector<std::string> expected;
    for (const BigInteger& factor :
         n % 2 == 1 ? std::vector{lucas, lucas} : std::vector<BigInteger>{f, 5 * f})
      if (factor > 1) expected.push_back(to_decimal(factor));
    const Triangulation cover(cyclic_cover(base.gluings(), shifts, n));
    const AbelianGroup found = first_homology(cover);
    EXPECT_EQ(found.rank, 1u) << n;
    EXPECT_EQ(found.invariant_factors, expected) << n;
    if (n > 150) continue;
    const AbelianGroup again =
        first_homology(Triangulation(random_relabelling(cover.gluings(), n)));
    EXPECT_EQ(again.invariant_factors, expected) << n;
  }
}

// Law C1: covers multiply everything that is local and keep the valences.
TEST(CyclicCover, MultipliesCellsAndKeepsValences) {
  const Triangulation base(decode_isosig("cPcbbbihq"));
  const auto shifts = primitive_class(base);
  ASSERT_TRUE(shifts);
  for (const std::size_t degree : {1u, 2u, 3u, 10u, 101u}) {
    const Triangulation cover(cyclic_cover(base.gluings(), *shifts, degree));
    EXPECT_TRUE(cover.is_connected());
    EXPECT_TRUE(cover.is_orientable());
    EXPECT_EQ(cover.tetrahedron_count(), 2 * degree);
    ASSERT_EQ(cover.edge_count(), degree);
    for (std::size_t e = 0; e < degree; ++e) EXPECT_EQ(cover.valence(e), 12u);
    int euler_characteristic = 0;
    for (std::size_t v = 0; v < cover.vertex_count(); ++v)
      euler_characteristic += cover.link(v).euler_characteristic;
    EXPECT_EQ(euler_characteristic, -2 * static_cast<int>(degree));
  }
  EXPECT_EQ(isosig(cyclic_cover(base.gluings(), *shifts, 1)), "cPcbbbihq");
}

TEST(CyclicCover, RefusesBranchingAndMismatches) {
  const Triangulation base(decode_isosig("cPcbbbihq"));
  auto shifts = *primitive_class(base);
  EXPECT_THROW((void)cyclic_cover(base.gluings(), shifts, 0), InvalidInput);
  shifts[0] += 1;
  EXPECT_THROW((void)cyclic_cover(base.gluings(), shifts, 5), InvalidInput);
  shifts.pop_back();
  EXPECT_THROW((void)cyclic_cover(base.gluings(), shifts, 5), InvalidInput);
  EXPECT_EQ(primitive_class(Triangulation(decode_isosig("bkaagj"))), std::nullopt);
}

// Symmetric triangulations are the hard case for signatures: 2 d frames give the same string.
TEST(CyclicCover, SignatureOfALargeCoverIsFast) {
  const Triangulation base(decode_isosig("cPcbbbihq"));
  const Gluings cover = cyclic_cover(base.gluings(), *primitive_class(base), 2000);
  const auto signature = isosig(random_relabelling(cover, 11), 100'000'000);
  ASSERT_TRUE(signature);
  EXPECT_EQ(isosig(decode_isosig(*signature)), *signature);
  EXPECT_TRUE(is_isomorphic(decode_isosig(*signature), cover));
}

TEST(Triangulation, HoldsLessThan150BytesATetrahedron) {
  const Triangulation base(decode_isosig("cPcbbbihq"));
  const Triangulation cover(cyclic_cover(base.gluings(), *primitive_class(base), 500'000));
  EXPECT_EQ(cover.tetrahedron_count(), 1'000'000u);
  EXPECT_LT(cover.memory_bytes(), 150u * cover.tetrahedron_count());
}

}  // namespace
}  // namespace tripus::topology
