#pragma once

#include "geometry/hyperbolic_space.hpp"

namespace tripus::viewer {

using geometry::Model;
using geometry::Vector3;
using geometry::Vector4;

/// A half-space in a model, or what is outside a horoball: the points p with
/// f(p) = a |p|^2 + b.p + c - (d.p)^2 <= 0. d = 0 but for horospheres of the Klein ball, which are
/// ellipsoids. Else the wall f = 0 is a sphere or, where a = 0, a plane; |grad f| = 1 on it, so |f|
/// is about the distance from it.
struct HalfSpace {
  double a = 0;
  Vector3 b = Vector3::Zero();
  double c = 0;
  Vector3 d = Vector3::Zero();

  double operator()(const Vector3& p) const {
    const double bent = d.dot(p);
    return a * p.squaredNorm() + b.dot(p) + c - bent * bent;
  }
  Vector3 gradient(const Vector3& p) const { return 2 * a * p + b - 2 * d.dot(p) * d; }
  bool is_sphere() const { return d.isZero(0); }
};

/// The half-space <normal, X> <= 0 of the hyperboloid model (unit spacelike normal).
HalfSpace half_space(Model model, const Vector4& normal);

/// What is outside a horoball: <v, X> <= -1 for a null vector v whose time is positive.
HalfSpace horosphere(Model model, const Vector4& v);

/// The side of the model's own boundary where hyperbolic space lies: z >= 0, or |p| <= 1.
HalfSpace model_side(Model model);

/// The same half-space for q with p = centre + scale q, again with |grad f| = 1 on its wall (d =
/// 0). Requires scale > 0.
HalfSpace in_local_frame(const HalfSpace& half_space, const Vector3& centre, double scale);

}  // namespace tripus::viewer
