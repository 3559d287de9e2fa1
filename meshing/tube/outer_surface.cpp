#include "meshing/tube/detail/outer_surface.hpp"

#include <limits>

namespace tripus::meshing::tube {
namespace {

/// The face of a box that is nearest by signed distance: axis and side (0 low, 1 high).
struct OuterFace {
  int axis = 0, side = 0;
  double value = -std::numeric_limits<double>::infinity();
};

double face_value(const OuterBox& box, const Point& p, int axis, int side) {
  return side == 0 ? box.low[axis] - p[axis] : p[axis] - box.high[axis];
}

OuterFace nearest_face(const OuterBox& box, const Point& p) {
  OuterFace best;
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side)
      if (const double value = face_value(box, p, axis, side); value > best.value)
        best = {axis, side, value};
  return best;
}

}  // namespace

double OuterSurface::value(const Point& p) const {
  if (const auto* sphere = std::get_if<OuterSphere>(&shape_))
    return distance(p, sphere->center) - sphere->radius;
  if (const auto* box = std::get_if<OuterBox>(&shape_)) return nearest_face(*box, p).value;
  return -std::numeric_limits<double>::infinity();
}

Point OuterSurface::normal(const Point& p) const {
  if (const auto* sphere = std::get_if<OuterSphere>(&shape_)) {
    const Point d = p - sphere->center;
    return norm(d) > 0 ? unit(d) : Point{0, 0, 1};
  }
  Point n{0, 0, 0};
  if (const auto* box = std::get_if<OuterBox>(&shape_)) {
    const OuterFace face = nearest_face(*box, p);
    n[face.axis] = face.side == 0 ? -1 : 1;
  }
  return n;
}

Point OuterSurface::exit_point(const Point& from, const Point& to) const {
  const Point d = unit(to - from);
  double t = 0;
  if (const auto* sphere = std::get_if<OuterSphere>(&shape_)) {
    const Point o = from - sphere->center;
    const double b = dot(o, d), c = dot(o, o) - sphere->radius * sphere->radius;
    t = -b + std::sqrt(std::max(b * b - c, 0.0));
  } else if (const auto* box = std::get_if<OuterBox>(&shape_)) {
    t = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k)
      if (d[k] != 0) t = std::min(t, ((d[k] > 0 ? box->high[k] : box->low[k]) - from[k]) / d[k]);
  }
  return from + t * d;
}

double OuterSurface::distance_from_rim(const Point& p) const {
  const auto* box = std::get_if<OuterBox>(&shape_);
  double least = std::numeric_limits<double>::infinity();
  if (box == nullptr) return least;
  const OuterFace nearest = nearest_face(*box, p);
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side)
      if (axis != nearest.axis || side != nearest.side)
        least = std::min(least, -face_value(*box, p, axis, side));
  return least;
}

Bounds OuterSurface::bounds() const {
  Bounds result;
  if (const auto* sphere = std::get_if<OuterSphere>(&shape_)) {
    const Point r{sphere->radius, sphere->radius, sphere->radius};
    result.add(sphere->center - r);
    result.add(sphere->center + r);
  } else if (const auto* box = std::get_if<OuterBox>(&shape_)) {
    result.add(box->low);
    result.add(box->high);
  }
  return result;
}

}  // namespace tripus::meshing::tube
