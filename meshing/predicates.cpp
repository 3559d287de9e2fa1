#include "meshing/predicates.hpp"

#include <cmath>

#include "base/tolerances.hpp"
#include "meshing/detail/expansion.hpp"

namespace tripus::meshing {
namespace {

using detail::exact_difference;
using detail::Expansion;
using detail::TwoTerms;

TwoTerms negated(const TwoTerms& x) { return {-x.large, -x.small}; }

int sign_of(double x) { return (x > 0) - (x < 0); }

int exact_orientation(const Point& a, const Point& b, const Point& c, const Point& d) {
  std::array<std::array<TwoTerms, 3>, 3> m;
  for (std::size_t k = 0; k < 3; ++k) {
    m[0][k] = exact_difference(b[k], a[k]);
    m[1][k] = exact_difference(c[k], a[k]);
    m[2][k] = exact_difference(d[k], a[k]);
  }
  Expansion<192> determinant;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    Expansion<16> minor;
    minor.add_product(m[1][i], m[2][j]);
    minor.add_product(negated(m[1][j]), m[2][i]);
    determinant.add_product(m[0][k], minor);
  }
  return determinant.sign();
}

int exact_projected(const Point& a, const Point& b, const Point& c, std::size_t i, std::size_t j) {
  Expansion<16> area;
  area.add_product(exact_difference(b[i], a[i]), exact_difference(c[j], a[j]));
  area.add_product(negated(exact_difference(b[j], a[j])), exact_difference(c[i], a[i]));
  return area.sign();
}

/// Closed segments in the plane that is seen along `axis`.
bool segments_meet(const Point& p, const Point& q, const Point& a, const Point& b, int axis) {
  const int pa = projected_orientation(p, q, a, axis), pb = projected_orientation(p, q, b, axis);
  const int ap = projected_orientation(a, b, p, axis), aq = projected_orientation(a, b, q, axis);
  if (pa == 0 && pb == 0 && ap == 0 && aq == 0) {  // on one line: compare the coordinates
    for (std::size_t k = 0; k < 3; ++k) {
      if (static_cast<int>(k) == axis) continue;
      if (std::fmax(p[k], q[k]) < std::fmin(a[k], b[k]) ||
          std::fmax(a[k], b[k]) < std::fmin(p[k], q[k]))
        return false;
    }
    return true;
  }
  return pa * pb <= 0 && ap * aq <= 0;
}

bool meets_in_plane(const Point& p, const Point& q, const std::array<const Point*, 3>& t) {
  const int axis = projection_axis(*t[0], *t[1], *t[2]);
  const int turn = projected_orientation(*t[0], *t[1], *t[2], axis);
  bool inside = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point &from = *t[i], &to = *t[(i + 1) % 3];
    if (segments_meet(p, q, from, to, axis)) return true;
    inside = inside && projected_orientation(from, to, p, axis) * turn >= 0;
  }
  return inside;
}

}  // namespace

bool in_exact_range(double coordinate) {
  const double size = std::fabs(coordinate);
  return size == 0 || (size >= 1e-70 && size <= 1e70);
}

int orientation(const Point& a, const Point& b, const Point& c, const Point& d) {
  const double bx = b[0] - a[0], by = b[1] - a[1], bz = b[2] - a[2];
  const double cx = c[0] - a[0], cy = c[1] - a[1], cz = c[2] - a[2];
  const double dx = d[0] - a[0], dy = d[1] - a[1], dz = d[2] - a[2];
  const double yz = cy * dz, zy = cz * dy, zx = cz * dx, xz = cx * dz, xy = cx * dy, yx = cy * dx;
  const double determinant = bx * (yz - zy) + by * (zx - xz) + bz * (xy - yx);
  const double size = std::fabs(bx) * (std::fabs(yz) + std::fabs(zy)) +
                      std::fabs(by) * (std::fabs(zx) + std::fabs(xz)) +
                      std::fabs(bz) * (std::fabs(xy) + std::fabs(yx));
  if (std::fabs(determinant) > tolerance::kOrientationRounding * size) return sign_of(determinant);
  return size == 0 ? 0 : exact_orientation(a, b, c, d);
}

int projected_orientation(const Point& a, const Point& b, const Point& c, int axis) {
  const auto i = static_cast<std::size_t>((axis + 1) % 3);
  const auto j = static_cast<std::size_t>((axis + 2) % 3);
  const double left = (b[i] - a[i]) * (c[j] - a[j]), right = (b[j] - a[j]) * (c[i] - a[i]);
  const double area = left - right, size = std::fabs(left) + std::fabs(right);
  if (std::fabs(area) > tolerance::kOrientationRounding * size) return sign_of(area);
  return size == 0 ? 0 : exact_projected(a, b, c, i, j);
}

int projection_axis(const Point& a, const Point& b, const Point& c) {
  for (int axis = 0; axis < 3; ++axis)
    if (projected_orientation(a, b, c, axis) != 0) return axis;
  return -1;
}

bool segment_meets_triangle(const Point& p, const Point& q, const Point& a, const Point& b,
                            const Point& c) {
  const int side_p = orientation(a, b, c, p), side_q = orientation(a, b, c, q);
  if (side_p * side_q > 0) return false;
  if (side_p == 0 && side_q == 0) return meets_in_plane(p, q, {&a, &b, &c});
  // The line through p and q crosses the plane in one point; it is in the triangle if the line
  // passes the three sides on one hand.
  const int ab = orientation(p, q, a, b), bc = orientation(p, q, b, c);
  if (ab * bc < 0) return false;
  const int ca = orientation(p, q, c, a);
  return ab * ca >= 0 && bc * ca >= 0;
}

}  // namespace tripus::meshing
