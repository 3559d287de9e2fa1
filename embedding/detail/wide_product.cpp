#include "embedding/detail/wide_product.hpp"

#include <cmath>

#include "embedding/detail/wide_map.hpp"

namespace tripus::embedding::detail {
namespace {

using geometry::Complex;
using geometry::Matrix4;
using geometry::MoebiusMap;

/// A sum of products, as if calculated in twice the digits and then rounded.
class LongSum {
 public:
  explicit LongSum(double first) : sum_(first) {}
  void add(double x, double y) {
    const double product = x * y, sum = sum_ + product, part = sum - sum_;
    rest_ += std::fma(x, y, -product) + ((sum_ - (sum - part)) + (product - part));
    sum_ = sum;
  }
  double value() const { return sum_ + rest_; }

 private:
  double sum_, rest_ = 0;
};

/// a d - b c - 1, which in plain doubles would be noise where the map takes the origin far.
Complex excess_of(const MoebiusMap& map) {
  const auto& [a, b, c, d, reverses] = map;
  LongSum re(-1), im(0);
  re.add(a.real(), d.real());
  re.add(-a.imag(), d.imag());
  re.add(-b.real(), c.real());
  re.add(b.imag(), c.imag());
  im.add(a.real(), d.imag());
  im.add(a.imag(), d.real());
  im.add(-b.real(), c.imag());
  im.add(-b.imag(), c.real());
  return {re.value(), im.value()};
}

}  // namespace

WideMap product(const WideMap& p, const WideMap& q) {
  const auto there = [&](std::size_t k) { return p.reverses ? conj(q.m[k]) : q.m[k]; };
  return {{p.m[0] * there(0) + p.m[1] * there(2), p.m[0] * there(1) + p.m[1] * there(3),
           p.m[2] * there(0) + p.m[3] * there(2), p.m[2] * there(1) + p.m[3] * there(3)},
          p.reverses != q.reverses};
}

WideMap inverse(const WideMap& map) {
  const auto& [a, b, c, d] = map.m;
  const WideComplex none{};
  const WideMap result{{d, none - b, none - c, a}, map.reverses};
  // w = f(conj z) gives conj z = f^-1(w).
  return map.reverses
             ? WideMap{{conj(result.m[0]), conj(result.m[1]), conj(result.m[2]), conj(result.m[3])},
                       true}
             : result;
}

/// As on_group of doubles.
WideMap on_group(const WideMap& given) {
  constexpr int kSteps = 5;  // from 1e-3 to 1e-96
  WideMap map = given;
  for (int step = 0; step < kSteps; ++step) {
    const auto& [a, b, c, d] = map.m;
    WideComplex excess = a * d - b * c;
    excess.re -= 1;
    const WideComplex along =
        excess * (WideNumber(1) / (a.square() + b.square() + c.square() + d.square()));
    map.m = {a - along * conj(d), b + along * conj(c), c + along * conj(b), d - along * conj(a)};
  }
  return map;
}

WideMap widened(const MoebiusMap& map) {
  return on_group(WideMap{{WideComplex::of(map.a), WideComplex::of(map.b), WideComplex::of(map.c),
                           WideComplex::of(map.d)},
                          map.reverses});
}

MoebiusMap rounded(const WideMap& map) {
  return {map.m[0].rounded(), map.m[1].rounded(), map.m[2].rounded(), map.m[3].rounded(),
          map.reverses};
}

namespace {

WideMap wide_product(std::span<const MoebiusMap> maps) {
  WideMap result = widened({});
  for (const MoebiusMap& map : maps) result = product(result, widened(map));
  return result;
}

}  // namespace

/// The columns are x, y, z and time: A sigma A* for each of Pauli's matrices; docs/theory.md (61).
template <class Scalar>
Eigen::Matrix<Scalar, 4, 4> to_matrix(const WideMap& map) {
  const auto& [a, b, c, d] = map.m;
  const WideComplex ac = a * conj(c), ad = a * conj(d), bc = b * conj(c), bd = b * conj(d);
  const WideNumber aa = a.square(), bb = b.square(), cc = c.square(), dd = d.square();
  const WideComplex ab = a * conj(b), cd = c * conj(d);
  Eigen::Matrix<Scalar, 4, 4> matrix;
  const auto column = [&](int n, const WideComplex& across, const WideNumber& top,
                          const WideNumber& bottom) {
    matrix.col(n) << static_cast<Scalar>(across.re), static_cast<Scalar>(across.im),
        static_cast<Scalar>((top - bottom) / 2), static_cast<Scalar>((top + bottom) / 2);
  };
  column(0, ad + bc, 2 * ab.re, 2 * cd.re);
  // sigma_y = (0, i; -i, 0): i (a conj(d) - b conj(c)) and i (a conj(b) - conj(a) b) = -2 Im.
  const WideComplex turned = ad - bc;
  column(1, {-turned.im, turned.re}, -2 * ab.im, -2 * cd.im);
  column(2, ac - bd, aa - bb, cc - dd);
  column(3, ac + bd, aa + bb, cc + dd);
  if (map.reverses) matrix.col(1) *= -1;
  return matrix;
}

template Eigen::Matrix<double, 4, 4> to_matrix<double>(const WideMap& map);
template Eigen::Matrix<long double, 4, 4> to_matrix<long double>(const WideMap& map);

/// Newton's steps towards a d - b c = 1, each the shortest. Scaling would do it as well, but moves
/// a map that takes the origin far by much more than its error.
MoebiusMap on_group(const MoebiusMap& map) {
  constexpr int kSteps = 3;
  MoebiusMap result = map;
  for (int step = 0; step < kSteps; ++step) {
    const auto& [a, b, c, d, reverses] = result;
    const Complex along =
        excess_of(result) / (std::norm(a) + std::norm(b) + std::norm(c) + std::norm(d));
    if (!std::isfinite(along.real()) || !std::isfinite(along.imag())) return map;
    result = {a - along * std::conj(d), b + along * std::conj(c), c + along * std::conj(b),
              d - along * std::conj(a), reverses};
  }
  return result;
}

MoebiusMap product_of(std::span<const MoebiusMap> maps) { return rounded(wide_product(maps)); }

Matrix4 matrix_of_product(std::span<const MoebiusMap> maps) {
  return to_matrix<double>(wide_product(maps));
}

}  // namespace tripus::embedding::detail
