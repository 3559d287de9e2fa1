#include "meshing/tube/detail/sweep.hpp"

#include "base/tolerances.hpp"

namespace tripus::meshing::tube {
namespace {

constexpr double kEps = tolerance::kSweepClearance;

struct Range {
  double low, high;
};

template <std::size_t N>
Range along(const Point& axis, const std::array<Point, N>& points) {
  Range r{HUGE_VAL, -HUGE_VAL};
  for (const Point& p : points) {
    const double x = dot(axis, p);
    r.low = std::min(r.low, x);
    r.high = std::max(r.high, x);
  }
  return r;
}

/// Two convex bodies with no common corner: is there a plane between them? Points are relative to
/// one of them; `size` bounds them all.
bool separate(const std::array<Point, 4>& t, const std::array<Point, 3>& f, double size) {
  const auto parts = [&](const Point& axis) {
    const double length = norm(axis);
    if (length <= kEps * size * size) return false;
    const Range a = along(axis, t), b = along(axis, f);
    const double gap = kEps * size * length;
    return a.low > b.high + gap || b.low > a.high + gap;
  };
  const std::array<Point, 6> te{t[1] - t[0], t[2] - t[0], t[3] - t[0],
                                t[2] - t[1], t[3] - t[1], t[3] - t[2]};
  const std::array<Point, 3> fe{f[1] - f[0], f[2] - f[0], f[2] - f[1]};
  if (parts(cross(fe[0], fe[1]))) return true;
  if (parts(cross(te[0], te[1])) || parts(cross(te[0], te[2])) || parts(cross(te[1], te[2])) ||
      parts(cross(te[3], te[4])))
    return true;
  for (const Point& x : te)
    for (const Point& y : fe)
      if (parts(cross(x, y))) return true;
  // Flat bodies in one plane are told apart within it.
  const Point n = cross(fe[0], fe[1]);
  for (const Point& y : fe)
    if (parts(cross(n, y))) return true;
  for (const Point& x : te)
    if (parts(cross(n, x))) return true;
  return false;
}

/// Two cones from a common corner, given by unit vectors along their edges: is there a plane
/// through the corner with one on each side, touching nothing but the corner?
///
/// Normals n with n . t >= 0 and n . f <= 0 for all edges form a cone, whose own edges are cross
/// products of two of these vectors (or, if all lie in one plane, of one with that plane's normal).
/// Their sum is inside it, and so separates strictly if any normal does.
bool cones_apart(const std::array<Point, 3>& t, const std::array<Point, 2>& f) {
  const std::array<Point, 5> rays{t[0], t[1], t[2], -1.0 * f[0], -1.0 * f[1]};
  Point sum{0, 0, 0};
  const auto add = [&](const Point& x, const Point& y) {
    const Point n = cross(x, y);
    const double length = norm(n);
    if (length <= kEps) return;
    double low = 0, high = 0;
    for (const Point& ray : rays) {
      const double d = dot(n, ray) / length;
      low = std::min(low, d);
      high = std::max(high, d);
    }
    if (low > -kEps) sum = sum + (1 / length) * n;
    if (high < kEps) sum = sum - (1 / length) * n;
  };
  for (std::size_t i = 0; i < rays.size(); ++i)
    for (std::size_t j = i + 1; j < rays.size(); ++j) add(rays[i], rays[j]);
  const Point plane = cross(f[0], f[1]);
  for (const Point& ray : rays) add(plane, ray);
  const double length = norm(sum);
  if (length <= kEps) return false;
  for (const Point& ray : rays)
    if (!(dot(sum, ray) > kEps * length)) return false;
  return true;
}

/// A wedge a b u p and a half-plane a b q at a common edge a b.
bool wedge_apart(const Point& edge, const Point& u, const Point& p, const Point& q) {
  const Point e = unit(edge);
  const auto across = [&](const Point& x) { return x - dot(x, e) * e; };
  const Point x = across(u), y = across(p), z = across(q);
  const double nx = norm(x), ny = norm(y), nz = norm(z);
  if (!(nx > 0 && ny > 0 && nz > 0)) return false;
  const double wedge = angle_between(x, y), to_x = angle_between(x, z), to_y = angle_between(y, z);
  // z is in the wedge exactly if the two angles add up to the wedge's.
  return to_x + to_y > wedge + kEps && to_x > kEps && to_y > kEps;
}

/// Moves the corners common to both to the front of each, in the same order.
int gather_common(Simplex<4>& t, Simplex<3>& f) {
  int common = 0;
  for (int i = 0; i < 4 && common < 3; ++i)
    for (int j = common; j < 3; ++j)
      if (t.names[i] == f.names[j]) {
        std::swap(t.names[i], t.names[common]);
        std::swap(t.points[i], t.points[common]);
        std::swap(f.names[j], f.names[common]);
        std::swap(f.points[j], f.points[common]);
        ++common;
        break;
      }
  return common;
}

}  // namespace

bool meet_in_common_face_only(const Simplex<4>& tetrahedron, const Simplex<3>& triangle) {
  Simplex<4> t = tetrahedron;
  Simplex<3> f = triangle;
  const int common = gather_common(t, f);
  if (common == 3) return false;
  const Point o = t.points[0];
  double size = 0;
  for (Point& p : t.points) {
    p = p - o;
    size = std::max(size, norm(p));
  }
  for (Point& p : f.points) {
    p = p - o;
    size = std::max(size, norm(p));
  }
  if (common == 0) return separate(t.points, f.points, size);
  for (int k = 1; k < 4; ++k)
    if (norm(t.points[k]) <= kEps * size) return false;
  if (common == 1)
    return cones_apart({unit(t.points[1]), unit(t.points[2]), unit(t.points[3])},
                       {unit(f.points[1]), unit(f.points[2])});
  return wedge_apart(t.points[1], t.points[2], t.points[3], f.points[2]);
}

}  // namespace tripus::meshing::tube
