#include "viewer/faces/wall_outline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "geometry/hyperboloid_tetrahedron.hpp"

namespace tripus::viewer {
namespace {

/// The margin may be this part of the wall's radius.
constexpr double kTightness = 0.02;
/// Triangles are halved so often at most.
constexpr int kMostHalvings = 8;

/// A surface that leaves each side of a small triangle by d, as a parabola, leaves the triangle by
/// less than 4/3 d; and a quarter for what is no parabola.
constexpr double kSafety = 1.7;

/// A point on the hyperboloid and in the model.
struct Corner {
  Vector4 x;
  Vector3 p;
};

/// Cuts the triangles of a wall until their sides are nearly straight in the model.
class Cutter {
 public:
  ///   horosphere  its null vector if the wall is one, else null
  Cutter(Model model, double error, const Vector4* horosphere)
      : model_(model), error_(error), horosphere_(horosphere) {}

  /// The middle of so many points with this sum.
  Corner corner(const Vector4& sum, double count = 1) const {
    if (horosphere_ != nullptr && count > 1) {
      const Vector4 x = geometry::on_horosphere(sum / count, *horosphere_);
      return {x, geometry::to_model(model_, x)};
    }
    // Sums of points of the hyperboloid are timelike.
    const Vector4 x = sum / std::sqrt(std::max(-geometry::lorentz_product(sum, sum), 1e-300));
    return {x, geometry::to_model(model_, x)};
  }
  void add(const Corner& corner) { outline.points.push_back(corner.p); }

  /// The corners of the triangle are added already.
  void cut(const Corner& a, const Corner& b, const Corner& c, int halvings = 0) {
    // Across the side that leaves its chord most.
    const std::array<const Corner*, 3> corners{&a, &b, &c};
    std::size_t worst = 0;
    double most = -1;
    Corner middle;
    for (std::size_t k = 0; k < 3; ++k) {
      const Corner &one = *corners[k], &other = *corners[(k + 1) % 3];
      const Corner between = corner(one.x + other.x, 2);
      const double leaves = (between.p - (one.p + other.p) / 2).norm();
      if (leaves > most) {
        most = leaves;
        worst = k;
        middle = between;
      }
    }
    if (most <= error_ || halvings == kMostHalvings) {
      outline.margin = std::max(outline.margin, kSafety * most);
      return;
    }
    add(middle);
    const Corner &one = *corners[worst], &other = *corners[(worst + 1) % 3],
                 &opposite = *corners[(worst + 2) % 3];
    cut(one, middle, opposite, halvings + 1);
    cut(middle, other, opposite, halvings + 1);
  }

  WallOutline outline;

 private:
  Model model_;
  double error_;
  const Vector4* horosphere_;
};

}  // namespace

WallOutline wall_outline(Model model, const SceneCell& cell, std::size_t wall, double detail) {
  if (!has_wall(cell, wall)) return {};
  const std::vector<Vector4> around = corners_of_wall(cell, wall);
  Vector4 sum = Vector4::Zero();
  double radius = 0;
  const Vector3 first = geometry::to_model(model, around[0]);
  for (const Vector4& corner : around) {
    sum += corner;
    radius = std::max(radius, (geometry::to_model(model, corner) - first).norm());
  }
  Cutter cutter(model, std::max(detail, kTightness * radius) / kSafety,
                is_horosphere(cell, wall) ? &wall_vector(cell, wall) : nullptr);
  const Corner middle = cutter.corner(sum, static_cast<double>(around.size()));
  std::vector<Corner> corners;
  for (const Vector4& corner : around) {
    corners.push_back(cutter.corner(corner));
    cutter.add(corners.back());
  }
  if (corners.size() == 3) {
    cutter.cut(corners[0], corners[1], corners[2]);
  } else {
    cutter.add(middle);
    for (std::size_t k = 0; k < corners.size(); ++k)
      cutter.cut(middle, corners[k], corners[(k + 1) % corners.size()]);
  }
  WallOutline& outline = cutter.outline;
  outline.middle = middle.p;
  for (const Vector3& p : outline.points)
    outline.radius = std::max(outline.radius, (p - outline.middle).norm());
  outline.radius += outline.margin;
  return std::move(outline);
}

}  // namespace tripus::viewer
