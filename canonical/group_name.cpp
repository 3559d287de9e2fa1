// Names of small finite groups. Each rule decides by properties that no other group has; what no
// rule knows is called by its order.
#include "canonical/group_name.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace tripus::canonical {
namespace {

using Orders = std::map<std::size_t, std::size_t>;

std::uint32_t identity_of(const GroupTable& group) {
  for (std::uint32_t e = 0; e < group.order; ++e)
    if (group.product(e, e) == e) return e;
  return 0;
}

/// [order] the order of each element.
std::vector<std::size_t> orders_of(const GroupTable& group) {
  const std::uint32_t identity = identity_of(group);
  std::vector<std::size_t> orders(group.order);
  for (std::uint32_t g = 0; g < group.order; ++g) {
    orders[g] = 1;
    for (std::uint32_t power = g; power != identity; power = group.product(power, g)) ++orders[g];
  }
  return orders;
}

bool is_abelian(const GroupTable& group) {
  for (std::size_t i = 0; i < group.order; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (group.product(i, j) != group.product(j, i)) return false;
  return true;
}

/// Invariant factors of an abelian group from the orders of its elements: those of order dividing
/// p^k are p^(sum over the p-parts of min(k, their exponent)).
std::string abelian_name(const GroupTable& group, const std::vector<std::size_t>& orders) {
  std::vector<std::size_t> factors;  // largest first
  std::size_t rest = group.order;
  for (std::size_t p = 2; rest > 1; ++p) {
    if (rest % p != 0) continue;
    while (rest % p == 0) rest /= p;
    std::size_t power = 1, before = 1;
    std::vector<std::size_t> parts;  // the p-parts, largest last while they grow
    while (true) {
      power *= p;
      const auto within = static_cast<std::size_t>(
          std::ranges::count_if(orders, [&](std::size_t n) { return power % n == 0; }));
      std::size_t growing = 0;  // parts with exponent >= k
      for (std::size_t ratio = within / before; ratio > 1; ratio /= p) ++growing;
      if (growing == 0) break;
      parts.resize(std::max(parts.size(), growing), 1);
      for (std::size_t k = 0; k < growing; ++k) parts[k] = power;
      before = within;
    }
    factors.resize(std::max(factors.size(), parts.size()), 1);
    for (std::size_t k = 0; k < parts.size(); ++k) factors[k] *= parts[k];
  }
  if (factors.size() == 1) return fmt::format("cyclic of order {}", factors.front());
  std::ranges::reverse(factors);
  std::vector<std::string> names;
  for (const std::size_t factor : factors) names.push_back(fmt::format("Z_{}", factor));
  return fmt::format("{}", fmt::join(names, " + "));
}

/// A cyclic subgroup with two cosets, and what the elements outside are: dihedral where all have
/// order 2, dicyclic where all have order 4 and there is one involution.
std::optional<std::string> two_coset_name(const GroupTable& group,
                                          const std::vector<std::size_t>& orders) {
  const std::size_t half = group.order / 2;
  if (group.order % 2 != 0) return std::nullopt;
  const auto found = std::ranges::find(orders, half);
  if (found == orders.end()) return std::nullopt;
  const auto r = static_cast<std::uint32_t>(found - orders.begin());
  std::vector<char> inside(group.order);
  std::uint32_t power = r;
  for (std::size_t k = 0; k < half; ++k, power = group.product(power, r)) inside[power] = 1;
  bool twos = true, fours = true;
  for (std::size_t g = 0; g < group.order; ++g) {
    if (inside[g]) continue;
    twos = twos && orders[g] == 2;
    fours = fours && orders[g] == 4;
  }
  if (twos) return fmt::format("dihedral of order {}", group.order);
  if (!fours || std::ranges::count(orders, std::size_t{2}) != 1) return std::nullopt;
  if ((half & (half - 1)) == 0) return fmt::format("quaternion of order {}", group.order);
  return fmt::format("dicyclic of order {}", group.order);
}

/// The groups that the orders of their elements tell from all others.
std::optional<std::string> named_by_orders(const Orders& orders) {
  static const std::vector<std::pair<Orders, const char*>> kNamed{
      {{{1, 1}, {2, 3}, {3, 8}}, "alternating A_4"},
      {{{1, 1}, {2, 9}, {3, 8}, {4, 6}}, "symmetric S_4"},
      {{{1, 1}, {2, 15}, {3, 20}, {5, 24}}, "alternating A_5"},
      {{{1, 1}, {2, 25}, {3, 20}, {4, 30}, {5, 24}, {6, 20}}, "symmetric S_5"},
  };
  for (const auto& [pattern, name] : kNamed)
    if (pattern == orders) return name;
  return std::nullopt;
}

/// The subgroup that the squares generate, as a set: it is normal, and the quotient is a sum of
/// Z_2, so that a central involution outside of it splits off.
std::vector<char> generated_by_squares(const GroupTable& group) {
  std::vector<char> member(group.order);
  std::vector<std::uint32_t> squares, todo{identity_of(group)};
  member[todo.front()] = 1;
  for (std::uint32_t g = 0; g < group.order; ++g) squares.push_back(group.product(g, g));
  while (!todo.empty()) {
    const std::uint32_t here = todo.back();
    todo.pop_back();
    for (const std::uint32_t square : squares) {
      const std::uint32_t next = group.product(here, square);
      if (member[next]) continue;
      member[next] = 1;
      todo.push_back(next);
    }
  }
  return member;
}

/// G / <z> for a central involution z.
GroupTable quotient(const GroupTable& group, std::uint32_t z) {
  std::vector<std::uint32_t> number(group.order), first;
  std::vector<char> seen(group.order);
  for (std::uint32_t g = 0; g < group.order; ++g) {
    if (seen[g]) continue;
    const std::uint32_t other = group.product(g, z);
    seen[g] = seen[other] = 1;
    number[g] = number[other] = static_cast<std::uint32_t>(first.size());
    first.push_back(g);
  }
  GroupTable result{first.size(), {}};
  for (const std::uint32_t a : first)
    for (const std::uint32_t b : first) result.products.push_back(number[group.product(a, b)]);
  return result;
}

/// G = Z_2 x G / <z>, if it splits so.
std::optional<GroupTable> without_z2(const GroupTable& group,
                                     const std::vector<std::size_t>& orders) {
  const std::vector<char> squares = generated_by_squares(group);
  for (std::uint32_t z = 0; z < group.order; ++z) {
    if (orders[z] != 2 || squares[z]) continue;
    bool central = true;
    for (std::uint32_t g = 0; g < group.order && central; ++g)
      central = group.product(g, z) == group.product(z, g);
    if (central) return quotient(group, z);
  }
  return std::nullopt;
}

}  // namespace

std::map<std::size_t, std::size_t> element_orders(const GroupTable& group) {
  Orders result;
  for (const std::size_t order : orders_of(group)) ++result[order];
  return result;
}

std::string group_name(const GroupTable& group) {
  if (group.order == 1) return "trivial";
  const std::vector<std::size_t> orders = orders_of(group);
  if (is_abelian(group)) return abelian_name(group, orders);
  if (auto name = two_coset_name(group, orders)) return *name;
  if (auto name = named_by_orders(element_orders(group))) return *name;
  if (const auto rest = without_z2(group, orders)) {
    const std::string name = group_name(*rest);
    if (!name.starts_with("non-abelian")) return "Z_2 x " + name;
  }
  return fmt::format("non-abelian of order {}", group.order);
}

}  // namespace tripus::canonical
