#include <atomic>
#include <cstdint>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "topology/covers/cover_homology.hpp"
#include "topology/covers/covers.hpp"
#include "topology/covers/cyclic_classes.hpp"
#include "topology/cyclic_cover.hpp"
#include "topology/isosig.hpp"

namespace tripus::topology {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

Triangulation triangulation(const std::string& signature) {
  return Triangulation(decode_isosig(signature));
}

/// Subgroups of index d: a conjugacy class has d / deck_group_order of them.
std::uint64_t subgroups(const Presentation& group, std::size_t degree) {
  std::uint64_t count = 0;
  for_each_transitive_action(group, degree, [&](const TransitiveAction& action) {
    count += degree / action.deck_group_order;
    return true;
  });
  return count;
}

Presentation free_abelian(int rank) {
  Presentation group{static_cast<std::size_t>(rank), {}};
  for (Letter a = 1; a <= rank; ++a)
    for (Letter b = a + 1; b <= rank; ++b) group.relators.push_back({a, b, -a, -b});
  return group;
}

// M. Hall, Subgroups of finite index in free groups (1949).
TEST(TransitiveActions, OfFreeGroupsAreAsManyAsHallCounts) {
  for (const std::size_t rank : {1u, 2u, 3u}) {
    std::vector<std::uint64_t> hall(1, 0);
    const auto power = [rank](std::uint64_t x) {
      std::uint64_t result = 1;
      for (std::size_t i = 1; i < rank; ++i) result *= x;
      return result;
    };
    std::vector<std::uint64_t> factorial{1};
    for (std::uint64_t d = 1; d <= (rank == 3 ? 4u : 6u); ++d) {
      factorial.push_back(factorial.back() * d);
      hall.push_back(d * power(factorial[d]));
      for (std::uint64_t i = 1; i < d; ++i) hall[d] -= power(factorial[d - i]) * hall[i];
      EXPECT_EQ(subgroups({rank, {}}, d), hall[d]) << "rank " << rank << ", index " << d;
    }
  }
}

// The sum over the subgroups of index k of Z^(r-1), each with k^(r-1) ... : a_r(n) is the sum of
// a_(r-1)(k) (n/k)^(r-1) over the divisors k of n.
TEST(TransitiveActions, OfFreeAbelianGroupsAreSumsOverDivisors) {
  std::vector<std::uint64_t> count(13, 1);  // rank 1
  for (int rank = 1; rank <= 3; ++rank) {
    for (std::size_t n = 1; n < count.size(); ++n)
      EXPECT_EQ(subgroups(free_abelian(rank), n), count[n]) << "rank " << rank << ", index " << n;
    std::vector<std::uint64_t> next(count.size(), 0);
    for (std::size_t n = 1; n < count.size(); ++n)
      for (std::size_t k = 1; k <= n; ++k) {
        if (n % k != 0) continue;
        std::uint64_t power = 1;
        for (int i = 0; i < rank; ++i) power *= n / k;
        next[n] += count[k] * power;
      }
    count = next;
  }
}

// The symmetric group of degree 4 as a Coxeter group has 30 subgroups in 11 classes.
TEST(TransitiveActions, OfTheSymmetricGroup) {
  const Presentation group{
      3, {{1, 1}, {2, 2}, {3, 3}, {1, 2, 1, 2, 1, 2}, {2, 3, 2, 3, 2, 3}, {1, 3, 1, 3}}};
  std::size_t classes = 0;
  std::uint64_t all = 0;
  for (std::size_t degree = 1; degree <= 24; ++degree) {
    all += subgroups(group, degree);
    for_each_transitive_action(group, degree, [&](const TransitiveAction&) { return ++classes; });
  }
  EXPECT_EQ(classes, 11u);
  EXPECT_EQ(all, 30u);
}

TEST(TransitiveActions, OfTheTrivialGroup) {
  EXPECT_EQ(subgroups({0, {}}, 1), 1u);
  EXPECT_EQ(subgroups({0, {}}, 2), 0u);
  EXPECT_EQ(subgroups({2, {{1}, {2}}}, 1), 1u);
  EXPECT_EQ(subgroups({2, {{1}, {2}}}, 3), 0u);
}

TEST(TransitiveActions, StopWhenTold) {
  int visits = 0;
  const auto three = [&](const TransitiveAction&) { return ++visits < 3; };
  EXPECT_EQ(for_each_transitive_action({2, {}}, 5, three), SearchEnd::kStopped);
  EXPECT_EQ(visits, 3);
  const std::atomic<bool> stop = true;
  EXPECT_EQ(for_each_transitive_action({2, {}}, 5, three, &stop), SearchEnd::kStopped);
  EXPECT_EQ(visits, 3);
  for (const std::size_t degree : {std::size_t{0}, std::size_t{101}, std::size_t{1} << 40})
    EXPECT_THROW(for_each_transitive_action({2, {}}, degree, three), InvalidInput);
}

// x = y z, y = z^2: all is a power of z, whose 15th is 1.
TEST(ReducedPresentation, SolvesForGenerators) {
  const Presentation group{3, {{-1, 2, 3}, {-2, 3, 3}, {1, 1, 1, 2, 3, 3, 3, 3}}};
  const ReducedPresentation short_form = reduced(group);
  EXPECT_EQ(short_form.presentation.generator_count, 1u);
  ASSERT_EQ(short_form.presentation.relators.size(), 1u);
  EXPECT_EQ(short_form.presentation.relators[0].size(), 15u);
  EXPECT_EQ(short_form.kept.size() + short_form.solved.size(), 3u);
  std::size_t visits = 0;
  for_each_transitive_action(short_form.presentation, 5, [&](const TransitiveAction& action) {
    const TransitiveAction all = extended(action, short_form);
    EXPECT_EQ(all.images.size(), 3u);
    for (std::uint32_t k = 0; k < 5; ++k) {
      EXPECT_EQ(all.images[0][k], all.images[2][all.images[1][k]]);
      EXPECT_EQ(all.images[1][k], all.images[2][all.images[2][k]]);
    }
    return ++visits;
  });
  EXPECT_EQ(visits, 1u);
}

TEST(FundamentalGroup, OfADisconnectedTriangulationIsRefused) {
  EXPECT_THAT([] { fundamental_group(triangulation("cPcbbbihqcPcbbbiht")); },
              ThrowsMessage<InvalidInput>(HasSubstr("has 2 components")));
}

// Onto classes up to units: Jordan's totient of the rank over Euler's.
TEST(CyclicClasses, OfAFreeH1AreCountedByTotients) {
  const Triangulation tripus = triangulation("cPcbbbihq");  // H1 = 2 Z
  for (std::int64_t n = 1; n <= 40; ++n) {
    std::int64_t pairs = 0;
    std::int64_t units = 0;
    for (std::int64_t a = 0; a < n; ++a) {
      units += std::gcd(a, n) == 1;
      for (std::int64_t b = 0; b < n; ++b) pairs += std::gcd(std::gcd(a, b), n) == 1;
    }
    const CyclicClasses classes(tripus, static_cast<std::size_t>(n));
    std::set<std::vector<std::int64_t>> orbits;
    std::int64_t visits = 0;
    classes.for_each([&](std::span<const std::int64_t> values) {
      EXPECT_EQ(classes.common_divisor(values), 1);
      std::vector<std::int64_t> least(2, n);
      for (std::int64_t u = 1; u <= n; ++u)
        if (std::gcd(u, n) == 1)
          least = std::min(least, std::vector{u * values[0] % n, u * values[1] % n});
      orbits.insert(least);
      return ++visits > 0;
    });
    EXPECT_EQ(visits, pairs / units) << n;
    EXPECT_EQ(static_cast<std::int64_t>(orbits.size()), visits) << n;
  }
}

// The lens space L(8,3): Z_8 maps onto Z/n for n = 1, 2, 4, 8 and no other.
TEST(CyclicClasses, OfAFiniteH1) {
  const Triangulation lens = triangulation("cMcabbjqs");
  ASSERT_EQ(to_string(first_homology(lens)), "Z_8");
  for (std::size_t n = 1; n <= 20; ++n) {
    std::size_t visits = 0;
    for_each_cyclic_cover(lens, n, [&](const Cover& cover) {
      EXPECT_TRUE(Triangulation(cover.gluings).is_connected());
      return ++visits;
    });
    EXPECT_EQ(visits, 8 % n == 0 ? 1u : 0u) << n;
  }
}

TEST(CyclicClasses, RefuseWrongValues) {
  const Triangulation tripus = triangulation("cPcbbbihq");
  const auto cover = [&](std::vector<std::int64_t> values, std::size_t degree) {
    return [&tripus, values = std::move(values), degree] {
      cyclic_cover_of_class(tripus, degree, values);
    };
  };
  EXPECT_THAT(cover({1}, 3), ThrowsMessage<InvalidInput>(HasSubstr("has 2 values")));
  EXPECT_THAT(cover({2, 4}, 6), ThrowsMessage<InvalidInput>(HasSubstr("common divisor 2")));
  EXPECT_THAT(cover({0, 0}, 2), ThrowsMessage<InvalidInput>(HasSubstr("not onto Z/2")));
  EXPECT_THAT(cover({1, 0}, 0), ThrowsMessage<InvalidInput>(HasSubstr("degree 0")));
  EXPECT_THAT(cover({1, 0}, std::size_t{1} << 60),
              ThrowsMessage<InvalidInput>(HasSubstr("degree")));
  const Triangulation lens = triangulation("cMcabbjqs");
  EXPECT_THAT([&] { cyclic_cover_of_class(lens, 16, std::vector<std::int64_t>{1}); },
              ThrowsMessage<InvalidInput>(HasSubstr("order 8")));
  EXPECT_EQ(isosig(cyclic_cover_of_class(tripus, 3, std::vector<std::int64_t>{-2, 3}).gluings),
            isosig(cyclic_cover_of_class(tripus, 3, std::vector<std::int64_t>{1, 0}).gluings));
}

// In the orientable double cover everything is there twice, and it is the one orientable cover with
// two sheets. Gieseking's manifold, and others with one vertex and two tetrahedra.
TEST(Covers, OrientableDoubleCovers) {
  for (const char* signature : {"bkaaid", "cMcabbidt", "cMcabbijr", "cMcabbick", "cMcabbifw",
                                "cPcbbbchw", "cPcbbbcjt", "cMcabbjdw"}) {
    const Triangulation base = triangulation(signature);
    if (base.is_orientable()) {
      EXPECT_THROW((void)orientable_double_cover(base), InvalidInput) << signature;
      continue;
    }
    const Cover cover = orientable_double_cover(base);
    const Triangulation above(cover.gluings);
    EXPECT_EQ(cover.degree, 2u);
    EXPECT_TRUE(above.is_orientable()) << signature;
    EXPECT_TRUE(above.is_connected()) << signature;
    EXPECT_EQ(above.tetrahedron_count(), 2 * base.tetrahedron_count());
    ASSERT_EQ(above.edge_count(), 2 * base.edge_count()) << signature;
    long below_sum = 0, above_sum = 0;
    for (std::size_t v = 0; v < base.vertex_count(); ++v)
      below_sum += base.link(v).euler_characteristic;
    for (std::size_t v = 0; v < above.vertex_count(); ++v) {
      EXPECT_TRUE(above.link(v).orientable);
      above_sum += above.link(v).euler_characteristic;
    }
    EXPECT_EQ(above_sum, 2 * below_sum) << signature;
    // It is one of all the covers with two sheets.
    std::size_t orientable = 0;
    for_each_cover(base, 2, [&](const Cover& each) {
      if (Triangulation(each.gluings).is_orientable()) {
        ++orientable;
        EXPECT_EQ(isosig(each.gluings), isosig(cover.gluings)) << signature;
      }
      return true;
    });
    EXPECT_EQ(orientable, 1u) << signature;
  }
}

TEST(Covers, LabelsAreSheets) {
  const Triangulation base = triangulation("cPcbbbihq");
  std::size_t visits = 0;
  for_each_cover(base, 4, [&](const Cover& cover) {
    EXPECT_EQ(cover.gluings.tetrahedron_count(), 8u);
    for (std::size_t t = 0; t < 8; ++t)
      for (int f = 0; f < 4; ++f) {
        EXPECT_EQ(cover.gluings.neighbour(t, f) % 2, base.gluings().neighbour(t % 2, f));
        EXPECT_EQ(cover.gluings.gluing(t, f), base.gluings().gluing(t % 2, f));
      }
    return ++visits;
  });
  EXPECT_EQ(visits, 30u);  // Regina, Group::enumerateCovers
}

}  // namespace
}  // namespace tripus::topology
