#pragma once

#include <limits>
#include <memory>

#include "embedding/holonomy.hpp"

namespace tripus::embedding {

using LongMatrix4 = Eigen::Matrix<long double, 4, 4>;

/// A holonomy whose generators have a hundred digits and satisfy the relators to some fifty. Those
/// of a Holonomy come from lengths in doubles and miss them by 1e-15 or more, and a word that is
/// the identity by many relators, each carried far away, by as much more: no product of such
/// generators can be better, in whatever arithmetic. Here the generators are moved by about what
/// they miss.
class WideHolonomy {
 public:
  /// Newton's method on the relators, each step the shortest. Up to 300 generators, all of which
  /// keep orientation; others stay as they are, and so they do where it does not converge.
  explicit WideHolonomy(const Holonomy& holonomy);
  WideHolonomy(const WideHolonomy&) = delete;
  WideHolonomy& operator=(const WideHolonomy&) = delete;
  ~WideHolonomy();

  /// The isometry of a word, read from left to right, as a Lorentz matrix to rounding of its
  /// entries.
  LongMatrix4 isometry_of(const topology::Word& word) const;
  /// How far the relators are from the identity now: the largest of their coefficients. Infinity if
  /// the generators stayed as they are.
  double relator_defect() const { return defect_; }

 private:
  struct Generators;
  void refine(const std::vector<topology::Word>& relators);

  std::unique_ptr<Generators> generators_;
  double defect_ = std::numeric_limits<double>::infinity();
};

}  // namespace tripus::embedding
