#pragma once

#include <cmath>
#include <span>

namespace tripus::geometry {

/// The founding paper's route to the dihedral angles, equations (3.1) to (3.3), literally: the
/// right-angled hexagon law for the sides of the four boundary triangles, then the triangle law
/// for their angles. It is the reference for the Gram route, and the subject of a study: past a
/// length of about 37 (in double precision) the triangle side rounds to cosh y = 1 and the last
/// equation divides 0 by 0.
///
/// Real is a floating-point type with cosh, sinh, acosh and acos.
///   l      [6]  lengths > 0, order 01 02 03 12 13 23
///   theta  [6]  radians; NaN where the formulae break down
/// Returns false if an angle is not a number.
/// Source: docs/theory.md section 2, paper's route.
template <class Real>
bool paper_dihedral_angles(const Real (&l)[6], Real (&theta)[6]) {
  using std::acos, std::acosh, std::cosh, std::sinh;
  constexpr int edge[4][4] = {{-1, 0, 1, 2}, {0, -1, 3, 4}, {1, 3, -1, 5}, {2, 4, 5, -1}};
  // (3.1): side at vertex i of the triangle's edge in face ijk.
  const auto side = [&](int i, int j, int k) {
    const Real a = l[edge[i][j]], b = l[edge[i][k]], c = l[edge[j][k]];
    return acosh((cosh(a) * cosh(b) + cosh(c)) / (sinh(a) * sinh(b)));
  };
  bool sound = true;
  for (int i = 0; i < 4; ++i) {
    for (int j = i + 1; j < 4; ++j) {
      const int k = i == 0 ? (j == 1 ? 2 : 1) : 0;
      const int m = 6 - i - j - k;
      // (3.2): the triangle law at vertex i; the angle between the faces ijk and ijm.
      const Real x = side(i, j, k), y = side(i, j, m), z = side(i, k, m);
      const Real angle = acos((cosh(x) * cosh(y) - cosh(z)) / (sinh(x) * sinh(y)));
      theta[edge[i][j]] = angle;
      sound = sound && angle == angle;
    }
  }
  return sound;
}

}  // namespace tripus::geometry
