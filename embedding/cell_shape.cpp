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
    add_corners();
    for (int f = 0; f < 4; ++f) {
      const auto [i, j, k] = others(f);
      add_polygon(f, {corner_[i][j][f], corner_[j][i][f], corner_[j][k][f], corner_[k][j][f],
                      corner_[k][i][f], corner_[i][k][f]});
    }
    for (int i = 0; i < 4; ++i) {
      if (tetrahedron_.is_finite(static_cast<std::size_t>(i))) continue;
      const auto [j, k, l] = others(i);
      add_polygon(4 + i, {corner_[i][j][l], corner_[i][k][l], corner_[i][k][j], corner_[i][l][j],
                          corner_[i][l][k], corner_[i][j][k]});
    }
    for (std::size_t e = 0; e < 6; ++e) {
      if (!tetrahedron_.is_parabolic(e)) continue;
      const int i = topology::kEdgeEnds[e][0], j = topology::kEdgeEnds[e][1];
      const int k = topology::kEdgeEnds[5 - e][0], l = topology::kEdgeEnds[5 - e][1];
      add_polygon(8 + static_cast<int>(e),
                  {corner_[i][j][k], corner_[i][j][l], corner_[j][i][l], corner_[j][i][k]});
    }
    for (int n = 0; n < subdivisions; ++n) subdivide();
    return std::move(shape_);
  }

 private:
  using Triangle = std::array<PointNumber, 3>;

  static std::array<int, 3> others(int f) {
    return {f == 0 ? 1 : 0, f <= 1 ? 2 : 1, f <= 2 ? 3 : 2};
  }

  /// The corners of edge ij at vertex i. Beside a parabolic edge there is one in each face.
  void add_corners() {
    for (int i = 0; i < 4; ++i) {
      const auto n = static_cast<std::size_t>(i);
      PointNumber first = 0;
      bool is_first = true;
      for (const int j : others(i)) {
        const auto e = static_cast<std::size_t>(topology::kEdgeNumber[n][std::size_t(j)]);
        const bool again = tetrahedron_.is_finite(n) && !is_first;
        if (!tetrahedron_.is_parabolic(e) && !again)
          first = add(geometry::corner(tetrahedron_, i, j), tetrahedron_.is_ideal(n)
                                                                ? static_cast<std::int8_t>(i)
                                                                : CellShape::kNoHorosphere);
        is_first = false;
        for (const int f : others(i)) {
          if (f == j) continue;
          corner_[i][j][f] = tetrahedron_.is_parabolic(e)
                                 ? add(geometry::parabolic_corner(tetrahedron_, i, j, f),
                                       static_cast<std::int8_t>(4 + e))
                                 : first;
        }
      }
    }
  }

  PointNumber add(const Vector4& point, std::int8_t horosphere) {
    shape_.points.push_back(point);
    shape_.horospheres.push_back(horosphere);
    return static_cast<PointNumber>(shape_.points.size() - 1);
  }

  /// The middle of points of the cell as a new one.
  PointNumber add_middle(std::span<const PointNumber> points) {
    return add(shape_.middle(tetrahedron_, points), shape_.common_horosphere(points));
  }

  /// A polygon whose corners go around it; those that coincide count once.
  void add_polygon(int side, std::vector<PointNumber> corners) {
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    if (corners.front() == corners.back()) corners.pop_back();
    if (side >= 4 && corners.size() == 3) {
      add_patch(side, {corners[0], corners[1], corners[2]});
      return;
    }
    const PointNumber centre = add_middle(corners);
    for (std::size_t n = 0; n < corners.size(); ++n)
      add_patch(side, {centre, corners[n], corners[(n + 1) % corners.size()]});
  }

  /// Turned so that it runs counter-clockwise seen from outside: in the Klein ball, whose origin is
  /// inside, from where the plane's normal or the ideal point lies.
  void add_patch(int side, Triangle triangle) {
    const auto place = [&](std::size_t n) {
      return geometry::to_model(Model::kKleinBall, shape_.points[triangle[n]]);
    };
    const auto n = static_cast<std::size_t>(side);
    const Vector4 outward = n < 4   ? tetrahedron_.faces[n]
                            : n < 8 ? tetrahedron_.vertices[n - 4]
                                    : tetrahedron_.parabolic_point(n - 8);
    const bool is_ideal = n >= 8 || (n >= 4 && tetrahedron_.is_ideal(n - 4));
    const Vector3 direction =
        is_ideal ? Vector3(outward.head<3>() / outward[3] - place(0)) : Vector3(outward.head<3>());
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
  PointNumber corner_[4][4][4] = {};  ///< i, j, f: of edge ij at vertex i in face f
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
  const auto n = static_cast<std::size_t>(vertex);
  return geometry::on_horosphere(
      sum / static_cast<double>(numbers.size()),
      n < 4 ? tetrahedron.vertices[n] : tetrahedron.parabolic_point(n - 4));
}

std::size_t patch_count(const HyperboloidTetrahedron& tetrahedron) {
  std::size_t patches = 4 * 6;
  for (std::size_t v = 0; v < 4; ++v) {
    std::size_t corners = 3;
    for (std::size_t w = 0; w < 4; ++w)
      corners += v != w && tetrahedron.is_parabolic(std::size_t(topology::kEdgeNumber[v][w]));
    if (tetrahedron.is_finite(v))
      patches -= 3;  // a corner less in each face at the vertex
    else
      patches += corners == 3 ? 1 : corners;
  }
  for (std::size_t e = 0; e < 6; ++e) patches += tetrahedron.is_parabolic(e) ? 4 : 0;
  return patches;
}

CellShape cell_shape(const HyperboloidTetrahedron& tetrahedron, int subdivisions) {
  if (subdivisions < 0 || subdivisions > kMostSubdivisions) {
    throw InvalidInput(fmt::format("a cell can be subdivided 0 to {} times, and not {} times",
                                   kMostSubdivisions, subdivisions));
  }
  return ShapeBuilder(tetrahedron).build(subdivisions);
}

}  // namespace tripus::embedding
