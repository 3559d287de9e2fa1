#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace tripus::canonical {

/// A finite group as its multiplication table: product(i, j) is the number of g_i g_j.
struct GroupTable {
  std::size_t order = 0;
  std::vector<std::uint32_t> products;  ///< [order x order]

  std::uint32_t product(std::size_t i, std::size_t j) const { return products[i * order + j]; }
};

/// How many elements have which order.
std::map<std::size_t, std::size_t> element_orders(const GroupTable& group);

/// "trivial", "cyclic of order 6", "dihedral of order 6", "Z_2 + Z_4", "symmetric S_4", "Z_2 x
/// alternating A_4", ...; "non-abelian of order 16" for a group that has none of these names.
/// Isomorphic groups get the same name. The Klein four-group is "Z_2 + Z_2".
std::string group_name(const GroupTable& group);

}  // namespace tripus::canonical
