// Names of groups, from tables of groups of permutations.
#include <algorithm>
#include <map>
#include <numeric>

#include <gtest/gtest.h>

#include "canonical/group_name.hpp"

namespace tripus::canonical {
namespace {

using Permutation = std::vector<int>;

Permutation composed(const Permutation& a, const Permutation& b) {
  Permutation result(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) result[i] = a[static_cast<std::size_t>(b[i])];
  return result;
}

/// The group that permutations generate, its elements in the order in which they are met.
GroupTable generated(const std::vector<Permutation>& generators) {
  Permutation identity(generators.front().size());
  std::iota(identity.begin(), identity.end(), 0);
  std::vector<Permutation> elements{identity};
  std::map<Permutation, std::uint32_t> number{{identity, 0}};
  for (std::size_t k = 0; k < elements.size(); ++k)
    for (const Permutation& generator : generators) {
      const Permutation next = composed(elements[k], generator);
      if (number.try_emplace(next, static_cast<std::uint32_t>(elements.size())).second)
        elements.push_back(next);
    }
  GroupTable table{elements.size(), {}};
  for (const Permutation& a : elements)
    for (const Permutation& b : elements) table.products.push_back(number.at(composed(a, b)));
  return table;
}

struct NamedGroup {
  const char* name;
  std::size_t order;
  std::vector<Permutation> generators;
};

const std::vector<NamedGroup>& groups() {
  static const std::vector<NamedGroup> kGroups{
      {"trivial", 1, {{0}}},
      {"cyclic of order 2", 2, {{1, 0}}},
      {"cyclic of order 6", 6, {{1, 2, 0, 4, 3}}},
      {"cyclic of order 7", 7, {{1, 2, 3, 4, 5, 6, 0}}},
      {"Z_2 + Z_2", 4, {{1, 0, 2, 3}, {0, 1, 3, 2}}},
      {"Z_2 + Z_4", 8, {{1, 2, 3, 0, 4, 5}, {0, 1, 2, 3, 5, 4}}},
      {"Z_2 + Z_2 + Z_2", 8, {{1, 0, 2, 3, 4, 5}, {0, 1, 3, 2, 4, 5}, {0, 1, 2, 3, 5, 4}}},
      {"Z_3 + Z_6",
       18,
       {{1, 2, 0, 3, 4, 5, 6, 7}, {0, 1, 2, 4, 5, 3, 6, 7}, {0, 1, 2, 3, 4, 5, 7, 6}}},
      {"dihedral of order 6", 6, {{1, 2, 0}, {0, 2, 1}}},
      {"dihedral of order 8", 8, {{1, 2, 3, 0}, {0, 3, 2, 1}}},
      {"dihedral of order 12", 12, {{1, 2, 0, 3, 4}, {0, 2, 1, 3, 4}, {0, 1, 2, 4, 3}}},
      {"quaternion of order 8", 8, {{1, 2, 3, 0, 5, 6, 7, 4}, {4, 7, 6, 5, 2, 1, 0, 3}}},
      {"dicyclic of order 12", 12, {{1, 2, 0, 3, 4, 5, 6}, {0, 2, 1, 4, 5, 6, 3}}},
      {"alternating A_4", 12, {{1, 2, 0, 3}, {1, 0, 3, 2}}},
      {"symmetric S_4", 24, {{1, 2, 3, 0}, {1, 0, 2, 3}}},
      {"Z_2 x alternating A_4", 24, {{1, 2, 0, 3, 4, 5}, {1, 0, 3, 2, 4, 5}, {0, 1, 2, 3, 5, 4}}},
      {"Z_2 x symmetric S_4", 48, {{1, 2, 3, 0, 4, 5}, {1, 0, 2, 3, 4, 5}, {0, 1, 2, 3, 5, 4}}},
      {"Z_2 x dihedral of order 8",
       16,
       {{1, 2, 3, 0, 4, 5}, {0, 3, 2, 1, 4, 5}, {0, 1, 2, 3, 5, 4}}},
      {"alternating A_5", 60, {{1, 2, 3, 4, 0}, {1, 2, 0, 3, 4}}},
      {"symmetric S_5", 120, {{1, 2, 3, 4, 0}, {1, 0, 2, 3, 4}}},
      {"non-abelian of order 21", 21, {{1, 2, 3, 4, 5, 6, 0}, {0, 2, 4, 6, 1, 3, 5}}},
  };
  return kGroups;
}

TEST(GroupNames, OfPermutations) {
  for (const NamedGroup& group : groups()) {
    SCOPED_TRACE(group.name);
    const GroupTable table = generated(group.generators);
    ASSERT_EQ(table.order, group.order);
    EXPECT_EQ(group_name(table), group.name);
    std::size_t all = 0;
    for (const auto& [order, count] : element_orders(table)) {
      EXPECT_EQ(group.order % order, 0u);
      all += count;
    }
    EXPECT_EQ(all, group.order);
  }
}

TEST(GroupNames, DoNotDependOnTheOrderOfElements) {
  for (const NamedGroup& group : groups()) {
    SCOPED_TRACE(group.name);
    const GroupTable table = generated(group.generators);
    // Element k of the new table is element (k + 1) mod n of the old.
    const std::size_t n = table.order;
    GroupTable turned{n, std::vector<std::uint32_t>(n * n)};
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        turned.products[i * n + j] =
            static_cast<std::uint32_t>((table.product((i + 1) % n, (j + 1) % n) + n - 1) % n);
    EXPECT_EQ(group_name(turned), group.name);
  }
}

}  // namespace
}  // namespace tripus::canonical
