#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace tripus::meshing::detail {

/// x + y = sum + error, exactly.
struct TwoTerms {
  double large;
  double small;
};

/// D. E. Knuth, The Art of Computer Programming 2, section 4.2.2, theorem B.
inline TwoTerms exact_sum(double x, double y) {
  const double sum = x + y;
  const double part = sum - x;
  return {sum, (x - (sum - part)) + (y - part)};
}

inline TwoTerms exact_difference(double x, double y) { return exact_sum(x, -y); }

inline TwoTerms exact_product(double x, double y) {
  const double product = x * y;
  return {product, std::fma(x, y, -product)};
}

/// An unevaluated sum of at most Capacity doubles that do not overlap, smallest first: numbers are
/// added to it without rounding. J. R. Shewchuk, Adaptive precision floating-point arithmetic and
/// fast robust geometric predicates (1997), theorem 10, is why add() keeps the order.
template <std::size_t Capacity>
class Expansion {
 public:
  void add(double x) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const TwoTerms s = exact_sum(x, terms_[i]);
      if (s.small != 0) terms_[kept++] = s.small;
      x = s.large;
    }
    if (x != 0) terms_[kept++] = x;
    size_ = kept;
  }
  void add_product(double x, double y) {
    if (x == 0 || y == 0) return;
    const TwoTerms p = exact_product(x, y);
    add(p.small);
    add(p.large);
  }
  /// Adds the product of two differences, or of a difference and an expansion.
  void add_product(const TwoTerms& x, const TwoTerms& y) {
    for (const double s : {x.small, x.large})
      for (const double t : {y.small, y.large}) add_product(s, t);
  }
  template <std::size_t Other>
  void add_product(const TwoTerms& x, const Expansion<Other>& y) {
    for (std::size_t i = 0; i < y.size(); ++i)
      for (const double s : {x.small, x.large}) add_product(s, y.term(i));
  }

  std::size_t size() const { return size_; }
  double term(std::size_t i) const { return terms_[i]; }
  /// The largest term outweighs the others together.
  int sign() const {
    if (size_ == 0) return 0;
    return terms_[size_ - 1] > 0 ? 1 : -1;
  }

 private:
  std::array<double, Capacity> terms_;
  std::size_t size_ = 0;
};

}  // namespace tripus::meshing::detail
