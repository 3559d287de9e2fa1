#include "viewer/half_space.hpp"

#include <cmath>

namespace tripus::viewer {

// A point (x, y, z) of the upper half-space is X = (x, y, (r - 1)/2, (r + 1)/2) / z with
// r = x^2 + y^2 + z^2, a point p of the Poincare ball X = (2 p, 1 + |p|^2) / (1 - |p|^2), and a
// point p of the Klein ball X = (p, 1) / sqrt(1 - |p|^2). The half-spaces below are <normal, X>
// times z, times (1 - |p|^2)/2, and times a positive function of p.
HalfSpace half_space(Model model, const Vector4& normal) {
  const double time = normal[3];
  switch (model) {
    case Model::kUpperHalfSpace:
      return {(normal[2] - time) / 2, {normal[0], normal[1], 0}, -(normal[2] + time) / 2};
    case Model::kPoincareBall:
      return {-time / 2, normal.head<3>(), -time / 2};
    case Model::kKleinBall:
      break;
  }
  const double length = normal.head<3>().norm();
  return {0, normal.head<3>() / length, -time / length};
}

// <v, X> + 1 times the same factors; in the Klein ball (<v, X> + 1) (<v, X> - 1) (|p|^2 - 1) / 2,
// where <v, X> - 1 is negative. |grad f|^2 is |b|^2 - 4 a c = 1 + <v, v> on the spheres.
HalfSpace horosphere(Model model, const Vector4& v) {
  const double time = v[3];
  switch (model) {
    case Model::kUpperHalfSpace:
      return {(v[2] - time) / 2, {v[0], v[1], 1}, -(v[2] + time) / 2};
    case Model::kPoincareBall:
      return {-(time + 1) / 2, v.head<3>(), (1 - time) / 2};
    case Model::kKleinBall:
      break;
  }
  return {-0.5, time * v.head<3>(), (1 - time * time) / 2, std::sqrt(0.5) * v.head<3>()};
}

HalfSpace model_side(Model model) {
  if (model == Model::kUpperHalfSpace) return {0, {0, 0, -1}, 0};
  return {0.5, {0, 0, 0}, -0.5};
}

HalfSpace in_local_frame(const HalfSpace& half_space, const Vector3& centre, double scale) {
  return {half_space.a * scale, half_space.gradient(centre), half_space(centre) / scale,
          std::sqrt(scale) * half_space.d};
}

}  // namespace tripus::viewer
