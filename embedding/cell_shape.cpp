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
    for (int i = 0; i < 4; ++i) {
      const auto n = static_cast<std::size_t>(i);
      const std::int8_t horosphere = tetrahedron_.is_ideal(n) ? static_cast<std::int8_t>(i)
                                                              : CellShape::kNoHorosphere;
      const int any = i == 0 ? 1 : 0;
      const PointNumber first = add(geometry::corner(tetrahedron_, i, any), horosphere);
      for (int j = 0; j < 4; ++j) {
        if (i == j) continue;
        const bool again = j == any || tetrahedron_.is_finite(n);
        corner[i][j] = again ? first : add(geometry::corner(tetrahedron_, i, j), horosphere);
      }
    }
    for (int i = 0; i < 4; ++i) {
      const int j = i == 0 ? 1 : 0, k = i <= 1 ? 2 : 1, l = 6 - i - j - k;
      add_polygon(
          i, {corner[j][k], corner[k][j], corner[k][l], corner[l][k], corner[l][j], corner[j][l]});
      if (!tetrahedron_.is_finite(static_cast<std::size_t>(i)))
        add_patch(4 + i, {corner[i][j], corner[i][k], corner[i][l]});
    }
    for (int n = 0; n < subdivisions; ++n) subdivide();
    return std::move(shape_);
  }

 private:
  using Triangle = std::array<PointNumber, 3>;

  PointNumber add(const Vector4& point, std::int8_t horosphere) {
    shape_.points.push_back(point);
    shape_.horospheres.push_back(horosphere);
    return static_cast<PointNumber>(shape_.points.size() - 1);
  }

  /// The middle of points of the cell as a new one.
  PointNumber add_middle(std::span<const PointNumber> points) {
    return add(shape_.middle(tetrahedron_, points), shape_.common_horosphere(points));
  }

  /// A face: corners that coincide, at finite vertices, count once.
  void add_polygon(int face, std::vector<PointNumber> corners) {
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    if (corners.front() == corners.back()) corners.pop_back();
    const PointNumber centre = add_middle(corners);
    for (std::size_t n = 0; n < corners.size(); ++n)
      add_patch(face, {centre, corners[n], corners[(n + 1) % corners.size()]});
  }

  /// Turned so that it runs counter-clockwise seen from outside: in the Klein ball, whose origin is
  /// inside, from where the plane's normal or the ideal vertex points.
  void add_patch(int side, Triangle triangle) {
    const auto place = [&](std::size_t n) {
      return geometry::to_model(Model::kKleinBall, shape_.points[triangle[n]]);
    };
    const auto n = static_cast<std::size_t>(side % 4);
    const Vector4& outward = side < 4 ? tetrahedron_.faces[n] : tetrahedron_.vertices[n];
    const Vector3 direction = side >= 4 && tetrahedron_.is_ideal(n)
                                  ? Vector3(outward.head<3>() / outward[3] - place(0))
                                  : Vector3(outward.head<3>());
    const Vector3 normal = (place(1) - place(0)).cross(place(2) - place(0));
    if (normal.dot(direction) < 0) std::swap(triangle[1], triangle[2]);
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
      if (is_new) place->second = add_middle(std::array{a, b});
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

std::int8_t CellShape::common_horosphere(std::span<const std::uint32_t> numbers) const {
  for (const std::uint32_t n : numbers)
    if (horospheres[n] != horospheres[numbers[0]]) return kNoHorosphere;
  return horospheres[numbers[0]];
}

Vector4 CellShape::middle(const HyperboloidTetrahedron& tetrahedron,
                          std::span<const std::uint32_t> numbers) const {
  Vector4 sum = Vector4::Zero();
  for (const std::uint32_t n : numbers) sum += points[n];
  const std::int8_t vertex = common_horosphere(numbers);
  if (vertex == kNoHorosphere) return detail::mean_point(sum, static_cast<int>(numbers.size()));
  return geometry::on_horosphere(sum / static_cast<double>(numbers.size()),
                                 tetrahedron.vertices[static_cast<std::size_t>(vertex)]);
}

CellShape cell_shape(const HyperboloidTetrahedron& tetrahedron, int subdivisions) {
  if (subdivisions < 0 || subdivisions > kMostSubdivisions) {
    throw InvalidInput(fmt::format("a cell can be subdivided 0 to {} times, and not {} times",
                                   kMostSubdivisions, subdivisions));
  }
  return ShapeBuilder(tetrahedron).build(subdivisions);
}

}  // namespace tripus::embedding
