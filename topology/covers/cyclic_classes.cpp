#include "topology/covers/cyclic_classes.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "base/stop.hpp"
#include "topology/covers/detail/abelianization.hpp"

namespace tripus::topology {
namespace {

std::int64_t remainder(std::int64_t x, std::int64_t modulus) {
  const std::int64_t r = x % modulus;
  return r < 0 ? r + modulus : r;
}

std::vector<std::int64_t> divisors(std::int64_t n) {
  std::vector<std::int64_t> low;
  std::vector<std::int64_t> high;
  for (std::int64_t d = 1; d * d <= n; ++d) {
    if (n % d != 0) continue;
    low.push_back(d);
    if (d * d != n) high.push_back(n / d);
  }
  low.insert(low.end(), high.rbegin(), high.rend());
  return low;
}

/// The orbits of (Z/N)* on the tuples of values, value by value. The units that keep the values so
/// far are those = 1 modulo m, m the least common multiple of the orders of the values; m = N means
/// that the class is onto. The next value is h a with h | N, and a is a unit modulo N/h that
/// matters only modulo gcd(m, N/h).
class ClassSearch {
 public:
  ClassSearch(std::int64_t modulus, const std::vector<std::int64_t>& orders)
      : modulus_(modulus), values_(orders.size()), best_(orders.size() + 1, 1) {
    for (std::size_t i = orders.size(); i-- > 0;) best_[i] = std::lcm(best_[i + 1], orders[i]);
    for (const std::int64_t order : orders) {
      factors_.push_back({});
      for (const std::int64_t d : divisors(modulus))
        if (order % (modulus / d) == 0) factors_.back().push_back(d);
    }
  }

  SearchEnd run(const CyclicClasses::Visit& visit, const Stop& stop) {
    const bool all = best_[0] != modulus_ || choose(0, 1, visit, stop);
    return all ? SearchEnd::kComplete : SearchEnd::kStopped;
  }

 private:
  bool choose(std::size_t i, std::int64_t m, const CyclicClasses::Visit& visit, const Stop& stop) {
    if (stop.requested()) return false;
    if (i == values_.size()) return visit(values_);
    for (const std::int64_t factor : factors_[i]) {
      const std::int64_t order = modulus_ / factor;
      const std::int64_t now = std::lcm(m, order);
      if (std::lcm(now, best_[i + 1]) != modulus_) continue;
      const std::int64_t period = std::gcd(m, order);
      for (std::int64_t residue = 0; residue < period; ++residue) {
        if (std::gcd(residue, period) != 1) continue;
        std::int64_t unit = residue;
        while (std::gcd(unit, order) != 1) unit += period;
        values_[i] = remainder(factor * unit, modulus_);
        if (!choose(i + 1, now, visit, stop)) return false;
      }
    }
    return true;
  }

  std::int64_t modulus_;
  std::vector<std::int64_t> values_;
  std::vector<std::int64_t> best_;                  // what values i, i + 1, ... can still do
  std::vector<std::vector<std::int64_t>> factors_;  // divisors of N that value i may have
};

}  // namespace

CyclicClasses::CyclicClasses(const Triangulation& triangulation, std::size_t modulus)
    : modulus_(static_cast<std::int64_t>(modulus)) {
  if (modulus == 0 || modulus > std::size_t{std::numeric_limits<int>::max()})
    throw InvalidInput("cyclic classes modulo " + std::to_string(modulus) + "; expected 1 to " +
                       std::to_string(std::numeric_limits<int>::max()));
  FundamentalGroup group = fundamental_group(triangulation);
  const detail::Abelianization abelian = detail::abelianization(group.presentation);
  homology_.rank = abelian.rank;
  orders_.assign(abelian.rank, modulus_);
  for (const auto& factor : abelian.factors) {
    homology_.invariant_factors.push_back(to_decimal(factor));
    orders_.push_back(to_int64(gcd(factor, BigInteger(modulus_))));
  }
  coordinates_.reserve(abelian.coordinates.size());
  for (const auto& row : abelian.coordinates) {
    coordinates_.emplace_back();
    for (const BigInteger& x : row)
      coordinates_.back().push_back(remainder(to_int64(x % modulus_), modulus_));
  }
  face_letters_ = std::move(group.face_letters);
}

std::vector<int> CyclicClasses::shifts(std::span<const std::int64_t> values) const {
  if (values.size() != orders_.size())
    throw InvalidInput("a class has " + std::to_string(orders_.size()) +
                       " values here, one for each summand of H1 = " + to_string(homology_) +
                       ", not " + std::to_string(values.size()));
  for (std::size_t i = homology_.rank; i < values.size(); ++i)
    if (remainder(values[i], modulus_) % (modulus_ / orders_[i]) != 0)
      throw InvalidInput("value " + std::to_string(values[i]) +
                         " of the class is for a generator of order " +
                         homology_.invariant_factors[i - homology_.rank] +
                         ": that times the value must be 0 modulo " + std::to_string(modulus_));
  std::vector<std::int64_t> shift_of(coordinates_.size(), 0);
  for (std::size_t g = 0; g < shift_of.size(); ++g)
    for (std::size_t i = 0; i < values.size(); ++i)
      shift_of[g] = (shift_of[g] + coordinates_[g][i] * remainder(values[i], modulus_)) % modulus_;
  std::vector<int> shifts(face_letters_.size(), 0);
  for (std::size_t slot = 0; slot < shifts.size(); ++slot) {
    if (face_letters_[slot] == 0) continue;
    const auto shift = static_cast<int>(shift_of[generator_of(face_letters_[slot])]);
    shifts[slot] = face_letters_[slot] > 0 ? shift : -shift;
  }
  return shifts;
}

std::int64_t CyclicClasses::common_divisor(std::span<const std::int64_t> values) const {
  std::int64_t divisor = modulus_;
  for (const std::int64_t value : values) divisor = std::gcd(divisor, remainder(value, modulus_));
  return divisor;
}

SearchEnd CyclicClasses::for_each(const Visit& visit, const Stop& stop) const {
  return ClassSearch(modulus_, orders_).run(visit, stop);
}

}  // namespace tripus::topology
