#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "base/error.hpp"
#include "embedding/detail/mean_point.hpp"
#include "embedding/tessellate.hpp"

namespace tripus::embedding {
namespace {

using PointNumber = std::uint32_t;

class ShapeBuilder {
 public:
  explicit ShapeBuilder(const HyperboloidTetrahedron& tetrahedron) : tetrahedron_(tetrahedron) {}

  CellShape build(int subdivisions) {
    PointNumber corner[4][4] = {};  // of the edge ij at vertex i
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        if (i != j) corner[i][j] = add(geometry::corner(tetrahedron_, i, j));
    for (int i = 0; i < 4; ++i) {
      const int j = i == 0 ? 1 : 0, k = i <= 1 ? 2 : 1, l = 6 - i - j - k;
      add_hexagon(
          i, {corner[j][k], corner[k][j], corner[k][l], corner[l][k], corner[l][j], corner[j][l]});
      add_patch(4 + i, tetrahedron_.vertices[static_cast<std::size_t>(i)],
                {corner[i][j], corner[i][k], corner[i][l]});
    }
    for (int n = 0; n < subdivisions; ++n) subdivide();
    return std::move(shape_);
  }

 private:
  using Triangle = std::array<PointNumber, 3>;

  PointNumber add(const Vector4& point) {
    shape_.points.push_back(point);
    return static_cast<PointNumber>(shape_.points.size() - 1);
  }

  void add_hexagon(int face, const std::array<PointNumber, 6>& corners) {
    Vector4 sum = Vector4::Zero();
    for (const PointNumber corner : corners) sum += shape_.points[corner];
    const PointNumber centre = add(detail::mean_point(sum, 6));
    for (std::size_t n = 0; n < 6; ++n)
      add_patch(face, tetrahedron_.faces[static_cast<std::size_t>(face)],
                {centre, corners[n], corners[(n + 1) % 6]});
  }

  /// Turned so that it runs counter-clockwise seen from outside, where the plane's normal points:
  /// in the Klein ball, whose origin is inside.
  void add_patch(int side, const Vector4& outward, Triangle triangle) {
    const auto place = [&](std::size_t n) {
      return geometry::to_model(Model::kKleinBall, shape_.points[triangle[n]]);
    };
    const Vector3 normal = (place(1) - place(0)).cross(place(2) - place(0));
    if (normal.dot(outward.head<3>()) < 0) std::swap(triangle[1], triangle[2]);
    shape_.triangles.push_back(triangle);
    shape_.sides.push_back(static_cast<std::uint8_t>(side));
  }

  /// Cuts every triangle into four. Middles of sides are made once, for both triangles there.
  void subdivide() {
    std::unordered_map<std::uint64_t, PointNumber> middles;
    middles.reserve(3 * shape_.triangles.size() / 2);
    const auto middle_of = [&](PointNumber a, PointNumber b) {
      const std::uint64_t key = std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
      const auto [place, is_new] = middles.try_emplace(key, 0);
      if (is_new) place->second = add(detail::mean_point(shape_.points[a] + shape_.points[b], 2));
      return place->second;
    };
    std::vector<Triangle> triangles;
    std::vector<std::uint8_t> sides;
    triangles.reserve(4 * shape_.triangles.size());
    sides.reserve(4 * shape_.triangles.size());
    for (std::size_t n = 0; n < shape_.triangles.size(); ++n) {
      const auto [a, b, c] = shape_.triangles[n];
      const PointNumber ab = middle_of(a, b), bc = middle_of(b, c), ca = middle_of(c, a);
      triangles.insert(triangles.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
      sides.insert(sides.end(), 4, shape_.sides[n]);
    }
    shape_.triangles = std::move(triangles);
    shape_.sides = std::move(sides);
  }

  const HyperboloidTetrahedron& tetrahedron_;
  CellShape shape_;
};

}  // namespace

CellShape cell_shape(const HyperboloidTetrahedron& tetrahedron, int subdivisions) {
  if (subdivisions < 0 || subdivisions > kMostSubdivisions) {
    throw InvalidInput(fmt::format("a cell can be subdivided 0 to {} times, and not {} times",
                                   kMostSubdivisions, subdivisions));
  }
  return ShapeBuilder(tetrahedron).build(subdivisions);
}

}  // namespace tripus::embedding
