#include "geometry/moebius.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/LU>

namespace tripus::geometry {
namespace {

using Matrix2 = std::array<Complex, 4>;  // row-major

/// The product without the tests for infinity that operator* of std::complex makes.
Complex times(const Complex& p, const Complex& q) {
  return {p.real() * q.real() - p.imag() * q.imag(), p.real() * q.imag() + p.imag() * q.real()};
}

Complex conjugate_if(bool wanted, const Complex& w) { return wanted ? std::conj(w) : w; }

Matrix2 product(const Matrix2& p, const Matrix2& q) {
  return {times(p[0], q[0]) + times(p[1], q[2]), times(p[0], q[1]) + times(p[1], q[3]),
          times(p[2], q[0]) + times(p[3], q[2]), times(p[2], q[1]) + times(p[3], q[3])};
}

Matrix2 adjoint(const Matrix2& m) {
  return {std::conj(m[0]), std::conj(m[2]), std::conj(m[1]), std::conj(m[3])};
}

/// The Pauli matrices in the order of the coordinates x, y, z, time.
const std::array<Matrix2, 4>& pauli() {
  static const Complex i{0, 1};
  static const std::array<Matrix2, 4> matrices{
      {{0, 1, 1, 0}, {0, i, -i, 0}, {1, 0, 0, -1}, {1, 0, 0, 1}}};
  return matrices;
}

/// The map that takes three points to 0, 1, infinity, not normalised.
MoebiusMap to_zero_one_infinity(const std::array<BoundaryPoint, 3>& p) {
  const auto bracket = [](const BoundaryPoint& u, const BoundaryPoint& v) {
    return u.x * v.y - u.y * v.x;
  };
  const Complex near = bracket(p[1], p[2]), far = bracket(p[1], p[0]);
  return {p[0].y * near, -p[0].x * near, p[2].y * far, -p[2].x * far, false};
}

MoebiusMap compose(const MoebiusMap& first, const MoebiusMap& second) {
  const bool flip = first.reverses;
  return {
      times(first.a, conjugate_if(flip, second.a)) + times(first.b, conjugate_if(flip, second.c)),
      times(first.a, conjugate_if(flip, second.b)) + times(first.b, conjugate_if(flip, second.d)),
      times(first.c, conjugate_if(flip, second.a)) + times(first.d, conjugate_if(flip, second.c)),
      times(first.c, conjugate_if(flip, second.b)) + times(first.d, conjugate_if(flip, second.d)),
      first.reverses != second.reverses};
}

}  // namespace

MoebiusMap operator*(const MoebiusMap& first, const MoebiusMap& second) {
  return compose(first, second);
}

MoebiusMap inverse(const MoebiusMap& map) {
  const bool flip = map.reverses;
  return {conjugate_if(flip, map.d), conjugate_if(flip, -map.b), conjugate_if(flip, -map.c),
          conjugate_if(flip, map.a), map.reverses};
}

MoebiusMap normalised(const MoebiusMap& map) {
  const Complex root = std::sqrt(map.a * map.d - map.b * map.c);
  return {map.a / root, map.b / root, map.c / root, map.d / root, map.reverses};
}

BoundaryPoint apply(const MoebiusMap& map, const BoundaryPoint& point) {
  const Complex x = conjugate_if(map.reverses, point.x), y = conjugate_if(map.reverses, point.y);
  return {map.a * x + map.b * y, map.c * x + map.d * y};
}

MoebiusMap map_of_triples(const std::array<BoundaryPoint, 3>& from,
                          const std::array<BoundaryPoint, 3>& to, bool reverses) {
  std::array<BoundaryPoint, 3> start = from;
  if (reverses)
    for (BoundaryPoint& p : start) p = {std::conj(p.x), std::conj(p.y)};
  MoebiusMap map = compose(inverse(to_zero_one_infinity(to)), to_zero_one_infinity(start));
  map.reverses = reverses;
  return normalised(map);
}

Matrix4 to_matrix(const MoebiusMap& map) {
  const Matrix2 m{map.a, map.b, map.c, map.d};
  const Matrix2 adjoint_m = adjoint(m);
  Matrix4 matrix;
  for (int column = 0; column < 4; ++column) {
    const Matrix2 h = product(product(m, pauli()[static_cast<std::size_t>(column)]), adjoint_m);
    matrix.col(column) << h[1].real(), h[1].imag(), (h[0].real() - h[3].real()) / 2,
        (h[0].real() + h[3].real()) / 2;
  }
  if (map.reverses) matrix.col(1) *= -1;
  return matrix;
}

MoebiusMap to_moebius(const Matrix4& isometry) {
  return to_moebius(isometry, isometry.determinant() < 0);
}

MoebiusMap to_moebius(const Matrix4& isometry, bool reverses) {
  Matrix4 matrix = isometry;
  if (reverses) matrix.col(1) *= -1;
  // sum_n (M sigma_n M*) C sigma_n = 2 tr(M* C) M for every C: one of the four sigmas as C makes
  // the trace at least |M| / sqrt(2).
  Matrix2 best{};
  double largest = -1;
  for (const Matrix2& c : pauli()) {
    Matrix2 sum{};
    for (std::size_t n = 0; n < 4; ++n) {
      Matrix2 image{};
      for (std::size_t r = 0; r < 4; ++r)
        for (std::size_t e = 0; e < 4; ++e)
          image[e] += matrix(static_cast<int>(r), static_cast<int>(n)) * pauli()[r][e];
      const Matrix2 term = product(product(image, c), pauli()[n]);
      for (std::size_t e = 0; e < 4; ++e) sum[e] += term[e];
    }
    double size = 0;
    for (const Complex& entry : sum) size += std::norm(entry);
    if (size > largest) {
      largest = size;
      best = sum;
    }
  }
  // The determinant of the multiple is a small difference of large numbers where A moves the origin
  // far: good enough for the phase, which no isometry depends on. The size is that of A's time.
  const Complex root = std::sqrt(best[0] * best[3] - best[1] * best[2]);
  const double size = std::sqrt(largest / (2 * isometry(3, 3)));
  const Complex scale = root == Complex(0) ? Complex(size) : size * (root / std::abs(root));
  return {best[0] / scale, best[1] / scale, best[2] / scale, best[3] / scale, reverses};
}

Vector4 image_of_origin(const MoebiusMap& map) {
  const double top = std::norm(map.a) + std::norm(map.b);
  const double bottom = std::norm(map.c) + std::norm(map.d);
  const Complex across = times(map.a, std::conj(map.c)) + times(map.b, std::conj(map.d));
  return {across.real(), across.imag(), (top - bottom) / 2, (top + bottom) / 2};
}

BoundaryPoint to_boundary(const Vector4& null_vector) {
  const Complex w(null_vector[0], null_vector[1]);
  // (x + i y) / (time - z) = (time + z) / (x - i y): the form without cancellation.
  if (null_vector[2] > 0) return {null_vector[3] + null_vector[2], std::conj(w)};
  return {w, null_vector[3] - null_vector[2]};
}

double difference(const MoebiusMap& first, const MoebiusMap& second) {
  if (first.reverses != second.reverses) return std::numeric_limits<double>::infinity();
  double best = std::numeric_limits<double>::infinity();
  for (const double sign : {1.0, -1.0}) {
    best = std::min(
        best, std::max({std::abs(first.a - sign * second.a), std::abs(first.b - sign * second.b),
                        std::abs(first.c - sign * second.c), std::abs(first.d - sign * second.d)}));
  }
  return best;
}

}  // namespace tripus::geometry
