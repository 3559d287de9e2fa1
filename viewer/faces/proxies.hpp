#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "viewer/camera.hpp"
#include "viewer/faces/face_set.hpp"

namespace tripus::viewer {

/// Convex polygons of a picture, each around the place of one face: triangles whose corners are x
/// and y in [-1, 1], y upwards, and the number that says where the record of the face begins.
struct ProxyMesh {
  std::vector<Eigen::Vector3f> corners;
  std::vector<std::uint32_t> triangles;

  void clear() {
    corners.clear();
    triangles.clear();
  }
};

/// Finds where faces lie on a picture.
class Projector {
 public:
  Projector(const View& view, int width, int height);

  /// Adds the polygon around points of the model, and what lies within `margin` of their hull.
  /// Adds nothing where it lies outside the picture.
  void add(std::span<const Eigen::Vector3f> points, double margin, float record,
           ProxyMesh& mesh) const;

  /// The square around a ball.
  void add(const BoundingBall& ball, float record, ProxyMesh& mesh) const;

  /// The radius of a ball on the picture, in pixels; infinite if the eye is in it.
  double pixels(const BoundingBall& ball) const;

 private:
  /// The polygon that reaches so far from the middle in every `step`-th of 16 directions, all
  /// turned by `turn` sixteenths.
  void add_polygon(std::span<const float> reach, std::size_t step, float record, ProxyMesh& mesh,
                   std::size_t turn = 0) const;

  Eigen::Matrix<float, 3, 4> to_picture_;  // x, y in pixels from the middle, times depth; depth
  Eigen::Vector3d eye_;
  double width_, height_;
  double focal_;  // pixels of a length 1 at depth 1
};

/// Whether some point of a face may turn its outer side to the eye. The points lie on its wall; the
/// face lies within `margin` of their hull.
bool may_face(const HalfSpace& wall, std::span<const Eigen::Vector3f> points, double margin,
              const Vector3& eye);

}  // namespace tripus::viewer
