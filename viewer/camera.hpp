#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "viewer/scene.hpp"

namespace tripus::viewer {

/// Looks at the middle of a scene, z upwards.
struct Camera {
  double azimuth = 30;    ///< degrees around z, from x towards y
  double elevation = 20;  ///< degrees above the horizon, in [-89, 89]
  double distance = 4.2;  ///< of the eye, in radii of the scene; >= kClosestDistance
  double zoom = 1;        ///< magnification without moving, in [kLeastZoom, kMostZoom]
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();  ///< of the picture, in halves of its height
};

/// The eye stays outside the scene: image-based CSG needs to see where a primitive begins.
inline constexpr double kClosestDistance = 2.3;
inline constexpr double kFarthestDistance = 100;
inline constexpr double kLeastZoom = 0.2;
inline constexpr double kMostZoom = 200;

/// A camera in a scene: column-major matrices as OpenGL has them, eye space looking along -z.
struct View {
  Eigen::Matrix4d model_view;  ///< from the model to eye space: a rotation and a translation
  Eigen::Matrix4d projection;
  Vector3 eye;  ///< in the model
  double near = 0;
  double far = 0;
  /// Height of the picture in eye space, at distance 1 from the eye.
  double height_at_one = 0;
};

/// Requires width, height > 0 and a scene of positive radius.
///   reach  what is drawn lies within this of the scene's centre; 0: within its radius
View view_of(const Camera& camera, const BoundingBall& scene, int width, int height,
             double reach = 0);

/// The same for a scene in a model, at its focus.
View view_of(const Camera& camera, Model model, const Scene& scene, int width, int height);

/// How far from the middle of the focus cells lie that were moved away from it; 0 if they were not.
double reach_of(Model model, const Scene& scene, const BoundingBall& focus);

/// Unit, in the model, towards the light: from above the viewer's left shoulder.
Vector3 key_light(const View& view);

/// The numbers of balls, the one nearest to the eye first.
std::vector<std::size_t> nearest_first(std::span<const BoundingBall> balls, const Vector3& eye);

/// The ray through a point of the picture, in pixels from its top left corner; unit direction.
struct Ray {
  Vector3 origin;
  Vector3 direction;
};
Ray ray_through(const View& view, int width, int height, double x, double y);

}  // namespace tripus::viewer
