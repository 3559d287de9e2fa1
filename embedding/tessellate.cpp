#include "embedding/tessellate.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <fmt/format.h>

#include "base/error.hpp"

namespace tripus::embedding {
namespace {

/// Distance of a point from the line through two others.
double distance_to_line(const Vector3& point, const Vector3& start, const Vector3& end) {
  const Vector3 along = end - start;
  const double length = along.norm();
  return length > 0 ? (point - start).cross(along).norm() / length : (point - start).norm();
}

Vector3 placed(Model model, const Matrix4& isometry, const Vector4& point) {
  return geometry::to_model(model, geometry::on_hyperboloid(isometry * point));
}

double diameter(const std::vector<Vector3>& points) {
  Eigen::AlignedBox3d box;
  for (const Vector3& point : points) box.extend(point);
  return box.diagonal().norm();
}

}  // namespace

Tessellation::Tessellation(const Embedding& embedding, std::span<const Cell> cells,
                           const TessellationOptions& options)
    : embedding_(embedding), cells_(cells), options_(options) {
  if (!(options.error > 0) || !std::isfinite(options.error))
    throw InvalidInput("the error of a tessellation must be a number greater than 0");
  shapes_.resize(embedding.tetrahedra.size());
  subdivisions_.reserve(cells.size());
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (c > 0 && is_stopped()) {
      cells_ = cells.first(c);
      options_.stop = {};  // it has ended this; the cells that are left are whole
      break;
    }
    int n = 0;
    const HyperboloidTetrahedron& tetrahedron = embedding.tetrahedra[cells[c].tetrahedron];
    const bool flat = options.model == Model::kKleinBall && tetrahedron.parabolic_edges == 0 &&
                      std::ranges::none_of(tetrahedron.diagonal, [](double d) { return d == 0; });
    while (!flat && largest_deviation(cells[c], n) > options.error) {
      if (++n > kMostSubdivisions) {
        throw InvalidInput(fmt::format(
            "cell {} cannot be drawn with an error of {}: it would be subdivided more than {} "
            "times; allow a larger error",
            c, options.error, kMostSubdivisions));
      }
    }
    subdivisions_.push_back(static_cast<std::uint8_t>(n));
    const std::size_t patches = patch_count(tetrahedron);
    point_count_ += embedding::point_count(n, patches);
    triangle_count_ += embedding::triangle_count(n, patches);
  }
}

const CellShape& Tessellation::shape(std::uint32_t tetrahedron, int subdivisions) const {
  CellShape& shape = shapes_[tetrahedron][static_cast<std::size_t>(subdivisions)];
  if (shape.points.empty()) shape = cell_shape(embedding_.tetrahedra[tetrahedron], subdivisions);
  return shape;
}

/// The largest distance of the true middle of a side from the flat one, and of the true middle of a
/// triangle from the flat one; relative to the cell where that is large.
double Tessellation::largest_deviation(const Cell& cell, int subdivisions) const {
  const CellShape& s = shape(cell.tetrahedron, subdivisions);
  const HyperboloidTetrahedron& tetrahedron = embedding_.tetrahedra[cell.tetrahedron];
  const auto true_middle = [&](std::span<const std::uint32_t> numbers) {
    return placed(options_.model, cell.isometry, s.middle(tetrahedron, numbers));
  };
  std::vector<Vector3> places;
  places.reserve(s.points.size());
  for (const Vector4& point : s.points)
    places.push_back(placed(options_.model, cell.isometry, point));
  double largest = 0;
  for (const auto& [a, b, c] : s.triangles) {
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      if (from > to) continue;  // the other triangle at this side
      const Vector3 truth = true_middle(std::array{from, to});
      largest = std::max(largest, distance_to_line(truth, places[from], places[to]));
    }
    const Vector3 truth = true_middle(std::array{a, b, c});
    const Vector3 normal = (places[b] - places[a]).cross(places[c] - places[a]);
    if (normal.norm() > 0)
      largest = std::max(largest, std::abs((truth - places[a]).dot(normal.normalized())));
  }
  const bool relative = options_.model == Model::kUpperHalfSpace;
  return relative ? largest / std::max(1.0, diameter(places)) : largest;
}

std::vector<Vector3> Tessellation::points(std::size_t cell) const {
  const CellShape& s = shape(cells_[cell].tetrahedron, subdivisions_[cell]);
  std::vector<Vector3> places;
  places.reserve(s.points.size());
  for (const Vector4& point : s.points)
    places.push_back(placed(options_.model, cells_[cell].isometry, point));
  return places;
}

std::vector<std::array<std::uint32_t, 3>> Tessellation::triangles(std::size_t cell) const {
  auto triangles = shape(cells_[cell].tetrahedron, subdivisions_[cell]).triangles;
  // A mirror image turns the triangles over.
  if (cells_[cell].isometry.determinant() < 0)
    for (auto& triangle : triangles) std::swap(triangle[1], triangle[2]);
  return triangles;
}

const std::vector<std::uint8_t>& Tessellation::sides(std::size_t cell) const {
  return shape(cells_[cell].tetrahedron, subdivisions_[cell]).sides;
}

namespace {

/// g(q) = int_0^1 s^2 / (1 - s^2 q)^2 ds: the field y g(|y|^2) has the divergence 1 / (1 -
/// |y|^2)^2, the density of hyperbolic volume in the Klein ball. By its series where the closed
/// form is 0 / 0.
double radial_weight(double q) {
  if (q < 1e-3) return 1.0 / 3 + q * (2.0 / 5 + q * (3.0 / 7 + q * (4.0 / 9 + q * (5.0 / 11))));
  const double r = std::sqrt(q);
  return (1 / (1 - q) - std::atanh(r) / r) / (2 * q);
}

/// Radon's rule on a triangle, exact for polynomials of degree 5: the middle, and twice three
/// points with one barycentric coordinate that differs from the other two.
struct RuleOrbit {
  double weight, different;
};
const std::array<RuleOrbit, 2>& radon_orbits() {
  static const double root = std::sqrt(15.0);
  static const std::array<RuleOrbit, 2> orbits{
      {{(155 + root) / 1200, (9 - 2 * root) / 21}, {(155 - root) / 1200, (9 + 2 * root) / 21}}};
  return orbits;
}

}  // namespace

double enclosed_volume(std::span<const Vector3> points,
                       std::span<const std::array<std::uint32_t, 3>> triangles) {
  double volume = 0;
  for (const auto& triangle : triangles) {
    const Vector3 &a = points[triangle[0]], &b = points[triangle[1]], &c = points[triangle[2]];
    const Vector3 middle_point = (a + b + c) / 3;
    double mean = 9.0 / 40 * radial_weight(middle_point.squaredNorm());
    for (const RuleOrbit& orbit : radon_orbits()) {
      for (const std::uint32_t n : triangle) {
        const double same = (1 - orbit.different) / 2;
        const Vector3 place = 3 * same * middle_point + (orbit.different - same) * points[n];
        mean += orbit.weight * radial_weight(place.squaredNorm());
      }
    }
    // The position times the normal is constant on a triangle.
    volume += mean * a.dot((b - a).cross(c - a)) / 2;
  }
  return volume;
}

double triangle_area(const Vector4& a, const Vector4& b, const Vector4& c) {
  // tan(area / 2) = sqrt(-det of the Gram matrix) / (1 - <a,b> - <b,c> - <c,a>), and the
  // determinant in the half-distances h, u = 2 sinh^2 h = -1 - <.,.>, is without large terms.
  const auto u = [](const Vector4& x, const Vector4& y) {
    const Vector4 step = x - y;
    return std::max(geometry::lorentz_product(step, step), 0.0) / 2;
  };
  const double p = u(a, b), q = u(b, c), r = u(c, a);
  const double det = 2 * (p * q + q * r + r * p) - (p * p + q * q + r * r) + 2 * p * q * r;
  return 2 * std::atan2(std::sqrt(std::max(det, 0.0)), 4 + p + q + r);
}

}  // namespace tripus::embedding
