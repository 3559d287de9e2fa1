#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "meshing/predicates.hpp"

// Signs against integers: coordinates that are whole numbers, scaled by a power of two, have
// determinants that 128-bit integers hold.

namespace tripus::meshing {
namespace {

using Whole = std::array<std::int64_t, 3>;
__extension__ using Integer = __int128;

int sign_of(Integer x) { return (x > 0) - (x < 0); }

int whole_orientation(const Whole& a, const Whole& b, const Whole& c, const Whole& d) {
  Integer m[3][3];
  for (int k = 0; k < 3; ++k) {
    m[0][k] = b[std::size_t(k)] - a[std::size_t(k)];
    m[1][k] = c[std::size_t(k)] - a[std::size_t(k)];
    m[2][k] = d[std::size_t(k)] - a[std::size_t(k)];
  }
  return sign_of(m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) +
                 m[0][1] * (m[1][2] * m[2][0] - m[1][0] * m[2][2]) +
                 m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]));
}

Point scaled(const Whole& w, double factor) {
  return {double(w[0]) * factor, double(w[1]) * factor, double(w[2]) * factor};
}

TEST(MeshingPredicates, OrientationIsTheSignOfTheVolume) {
  const Point o{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  EXPECT_EQ(orientation(o, x, y, z), 1);
  EXPECT_EQ(orientation(o, y, x, z), -1);
  EXPECT_EQ(orientation(o, x, y, {0.3, 0.7, 0}), 0);
  EXPECT_EQ(orientation(o, x, y, {0.3, 0.7, 1e-70}), 1);
  EXPECT_EQ(orientation(o, x, y, {0.3, 0.7, -1e-70}), -1);
}

TEST(MeshingPredicates, NearlyFlatTetrahedraHaveTheSignOfWholeNumbers) {
  std::mt19937_64 random(7);
  int zeros = 0, exact_only = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const std::int64_t size = std::int64_t{1} << (trial % 38 + 1);
    std::uniform_int_distribution<std::int64_t> whole(-size, size), step(-1, 1), times(-3, 3);
    Whole a, u, v, b, c, d;
    const std::int64_t s = times(random), t = times(random);
    for (std::size_t k = 0; k < 3; ++k) {
      a[k] = whole(random), u[k] = whole(random), v[k] = whole(random);
      b[k] = a[k] + u[k], c[k] = a[k] + v[k];
      d[k] = a[k] + s * u[k] + t * v[k] + (trial % 3 == 0 ? 0 : step(random));
    }
    const int expected = whole_orientation(a, b, c, d);
    for (const double factor : {1.0, 0x1p-150, 0x1p150}) {
      const Point pa = scaled(a, factor), pb = scaled(b, factor), pc = scaled(c, factor),
                  pd = scaled(d, factor);
      ASSERT_EQ(orientation(pa, pb, pc, pd), expected) << "trial " << trial;
      ASSERT_EQ(orientation(pb, pa, pc, pd), -expected);
      ASSERT_EQ(orientation(pd, pc, pb, pa), expected);
    }
    zeros += expected == 0;
    exact_only += expected != 0 && size > (1 << 20);
  }
  EXPECT_GT(zeros, 1000);
  EXPECT_GT(exact_only, 1000);
}

TEST(MeshingPredicates, ProjectedOrientationIsExactAlongEveryAxis) {
  std::mt19937_64 random(11);
  for (int trial = 0; trial < 5000; ++trial) {
    const std::int64_t size = std::int64_t{1} << (trial % 50 + 1);
    std::uniform_int_distribution<std::int64_t> whole(-size, size), step(-1, 1);
    Whole a, b, c;
    for (std::size_t k = 0; k < 3; ++k) {
      a[k] = whole(random), b[k] = whole(random);
      c[k] = 2 * b[k] - a[k] + (trial % 2) * step(random);
    }
    for (int axis = 0; axis < 3; ++axis) {
      const auto i = std::size_t((axis + 1) % 3), j = std::size_t((axis + 2) % 3);
      const Integer area =
          Integer(b[i] - a[i]) * (c[j] - a[j]) - Integer(b[j] - a[j]) * (c[i] - a[i]);
      ASSERT_EQ(projected_orientation(scaled(a, 1), scaled(b, 1), scaled(c, 1), axis),
                sign_of(area));
    }
  }
}

TEST(MeshingPredicates, SegmentAndTriangle) {
  const Point a{0, 0, 0}, b{4, 0, 0}, c{0, 4, 0};
  const auto meets = [&](const Point& p, const Point& q) {
    const bool answer = segment_meets_triangle(p, q, a, b, c);
    EXPECT_EQ(segment_meets_triangle(q, p, a, b, c), answer);
    EXPECT_EQ(segment_meets_triangle(p, q, c, a, b), answer);
    EXPECT_EQ(segment_meets_triangle(p, q, b, a, c), answer);
    return answer;
  };
  EXPECT_TRUE(meets({1, 1, -1}, {1, 1, 1}));         // through the inside
  EXPECT_TRUE(meets({2, 2, -1}, {2, 2, 1}));         // through a side
  EXPECT_TRUE(meets({4, 0, -1}, {4, 0, 1}));         // through a corner
  EXPECT_TRUE(meets({1, 1, 0}, {1, 1, 1}));          // ends inside
  EXPECT_TRUE(meets({1, 1, 0}, {2, 1, 0}));          // in the plane, inside
  EXPECT_TRUE(meets({-1, 1, 0}, {5, 1, 0}));         // in the plane, across
  EXPECT_TRUE(meets({4, 0, 0}, {8, 0, 0}));          // on the line of a side, at the corner
  EXPECT_FALSE(meets({4.5, 0, 0}, {8, 0, 0}));       // on the line of a side, beyond
  EXPECT_FALSE(meets({3, 3, -1}, {3, 3, 1}));        // beside
  EXPECT_FALSE(meets({1, 1, 0x1p-200}, {1, 1, 1}));  // above by a hair
  EXPECT_FALSE(meets({3, 3, 0}, {5, 5, 0}));         // in the plane, beside
  EXPECT_FALSE(meets({-1, -1, -1}, {-1, -1, 1}));
}

}  // namespace
}  // namespace tripus::meshing
