#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "parameterise/solid.hpp"

namespace tripus::parameterise {

/// What became of one tetrahedron of the mesh: the geodesic one with its four corners' images.
struct CellQuality {
  /// Exact sign in the Klein model; -1: turned over, 0: flat. Always 0 where all corners are held
  /// to one plane of the boundary: what rounding leaves there has no meaning.
  int orientation = 1;
  double volume = 0;  ///< hyperbolic, with that sign
  /// Largest by smallest stretch of the linear map between the corners, at the middle; >= 1.
  double anisotropy = 1;
  /// Hyperbolic by Euclidean volume, divided by the same of the whole: 1 is the mean.
  double volume_ratio = 1;
};

struct Quality {
  std::vector<CellQuality> cells = {};  ///< [T]
  std::size_t inverted = 0;             ///< cells with orientation < 0
  std::size_t flat = 0;
  /// Sum of the signed volumes of the images, and of the balls that the images of boundary spheres
  /// bound: the manifold's, once covered.
  double image_volume = 0;
  double filled_volume = 0;  ///< those balls' part of it
  double manifold_volume = 0;
  double median_anisotropy = 1, worst_anisotropy = 1;  ///< the worst of those not turned over
  double off_boundary = 0;                             ///< largest |<f, pole>| of a boundary point
};

/// points [V], each in its own frame.
Quality quality(MarkedSolid& solid, std::span<const Vector4> points);

/// Volume of the geodesic tetrahedron with these corners on the hyperboloid, positive where they
/// are in positive order in the Klein model. By Gauss' rule after subdivision into small pieces;
/// accuracy some 1e-13 of the volume.
double signed_volume(const std::array<Vector4, 4>& corners);

/// The image of a tetrahedron of the mesh, in its own frame.
std::array<Vector4, 4> image(const MarkedSolid& solid, std::span<const Vector4> points,
                             std::size_t t);

/// The middle of four points of the hyperboloid.
Vector4 middle(const std::array<Vector4, 4>& corners);

/// Where a point of space lies in the manifold.
struct Located {
  std::uint32_t tetrahedron = 0;
  std::array<double, 3> position{};  ///< in the Klein ball, in the frame of that tetrahedron
  double to_boundary = 0;            ///< distance to the nearest truncation of that tetrahedron
};
/// A point in the frame of the fundamental domain.
Located located(const MarkedSolid& solid, const Vector4& point);

}  // namespace tripus::parameterise
