#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "base/stop.hpp"
#include "topology/covers/transitive_actions.hpp"
#include "topology/homology.hpp"

namespace tripus::topology {

/// The homomorphisms of H1 to Z/N, by their values on a basis of H1.
///
/// The basis: H1 = r Z + Z_d1 + Z_d2 + ... as to_string(homology()) writes it; the values are those
/// on the r free generators, then on the generators of order d1, d2, ... It comes from the Smith
/// normal form of the relators and is the same for all N, but depends on the labels of the
/// triangulation. `shifts` says what a class is without a basis.
class CyclicClasses {
 public:
  /// Throws InvalidInput if the triangulation is not connected, and Unsupported if H1 needs more
  /// than 1000 generators (the normal form is dense, of cubic cost).
  CyclicClasses(const Triangulation& triangulation, std::size_t modulus);

  const AbelianGroup& homology() const { return homology_; }
  /// How many values a class has: rank + number of invariant factors.
  std::size_t value_count() const { return orders_.size(); }

  /// The class as a cocycle [T x 4]: crossing face f of tetrahedron t leads from sheet k to sheet
  /// k + shift modulo N. In 0..N-1 on one side of each glued pair, and its opposite on the other.
  /// Throws InvalidInput if there are not value_count() values, or a value times the order of its
  /// generator is not 0 modulo N.
  std::vector<int> shifts(std::span<const std::int64_t> values) const;

  /// The greatest common divisor of the values and N; the class is onto if it is 1.
  std::int64_t common_divisor(std::span<const std::int64_t> values) const;

  /// Returns false to stop.
  using Visit = std::function<bool(std::span<const std::int64_t> values)>;
  /// Visits the classes that are onto, one of each orbit of the units of Z/N: values in 0..N-1,
  /// from the left the least of its orbit but for zeros, which come last. No step of the search is
  /// in vain: the time is linear in the number of classes.
  SearchEnd for_each(const Visit& visit, const Stop& stop = {}) const;

 private:
  std::int64_t modulus_;
  AbelianGroup homology_;
  std::vector<std::int64_t> orders_;  ///< [values] gcd(order of the generator, N), N if infinite
  std::vector<Letter> face_letters_;  ///< [T x 4]
  std::vector<std::vector<std::int64_t>> coordinates_;  ///< [generators x values] modulo N
};

}  // namespace tripus::topology
