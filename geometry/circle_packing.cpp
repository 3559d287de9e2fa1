#include "geometry/circle_packing.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <Eigen/LU>

#include "base/error.hpp"
#include "geometry/detail/angle_gram.hpp"
#include "geometry/truncated_tetrahedron.hpp"

namespace tripus::geometry {
namespace {

// As in hyperboloid_tetrahedron.cpp: computed in the widest type and rounded once. The paper's
// place is not centred, so its coordinates can be large, and each of their digits counts.
using Wide = long double;
using WideComplex = std::complex<Wide>;

struct WideCircle {
  Wide curvature;
  WideComplex weighted_centre;
  Wide co_curvature;
};

/// The scalar product of two vectors of the plane.
template <class Real>
Real inner(const std::complex<Real>& u, const std::complex<Real>& v) {
  return u.real() * v.real() + u.imag() * v.imag();
}

Wide product(const WideCircle& p, const WideCircle& q) {
  return inner(p.weighted_centre, q.weighted_centre) -
         (p.curvature * q.co_curvature + p.co_curvature * q.curvature) / 2;
}

WideCircle scaled(const WideCircle& circle, Wide factor) {
  return {factor * circle.curvature, factor * circle.weighted_centre, factor * circle.co_curvature};
}

Circle rounded(const WideCircle& circle) {
  return {static_cast<double>(circle.curvature), Complex(circle.weighted_centre),
          static_cast<double>(circle.co_curvature)};
}

/// The circle orthogonal to a line through 0 with direction `along`, to f3 and to f4: (68). Its
/// centre lies on the line, so one number along it is all.
WideCircle orthogonal_to_three(const WideComplex& along, const WideCircle& f3,
                               const WideCircle& f4) {
  const Wide x3 = inner(f3.weighted_centre, along);
  const Wide a4 = inner(f4.weighted_centre, along);
  const Wide curvature = 2 * (a4 - x3 * f4.curvature);
  const Wide centre = f4.co_curvature - f3.co_curvature * f4.curvature;
  const Wide co_curvature = 2 * centre * x3 - curvature * f3.co_curvature;
  const Wide norm = std::sqrt(centre * centre - curvature * co_curvature);
  return scaled({curvature, centre * along, co_curvature}, 1 / norm);
}

void require_angles(std::span<const double, 6> theta) {
  std::array<double, 6> lengths{};
  if (lengths_from_angles(theta, lengths)) return;
  std::string list;
  for (const double angle : theta) list += (list.empty() ? "" : " ") + std::to_string(angle);
  throw InvalidInput("the dihedral angles " + list +
                     " are not those of a truncated tetrahedron: each must be greater than 0, and "
                     "the three at every vertex must sum to less than pi");
}

}  // namespace

Vector4 plane_of(const Circle& circle) {
  return {circle.weighted_centre.real(), circle.weighted_centre.imag(),
          (circle.co_curvature - circle.curvature) / 2,
          (circle.co_curvature + circle.curvature) / 2};
}

Circle circle_of(const Vector4& plane) {
  return {plane[3] - plane[2], {plane[0], plane[1]}, plane[3] + plane[2]};
}

CirclePacking circle_packing(std::span<const double, 6> theta) {
  require_angles(theta);
  // The paper's t1..t6: the faces f1 f2, f2 f3, f1 f3, f3 f4, f1 f4, f2 f4 meet at the edges
  // 23, 03, 13, 01, 12, 02.
  const Wide t1 = theta[5], t2 = theta[2], t3 = theta[4];
  const Wide t4 = theta[0], t5 = theta[3], t6 = theta[1];
  const Wide sine = std::sin(t1);
  const WideComplex direction = std::polar(Wide(1), t1);
  const WideComplex c3((std::cos(t1) * std::cos(t3) + std::cos(t2)) / sine, std::cos(t3));
  const WideComplex c4((std::cos(t5) * std::cos(t1) + std::cos(t6)) / sine, std::cos(t5));
  // |c3|^2 - 1 and |c4|^2 - 1 = -c are minors of the Gram matrix of the faces, and the root is that
  // of its determinant: (67). These forms keep their digits near ideal vertices and flat shapes.
  const Wide q = angle_vertex_minor<Wide>(theta, kEdgesAtVertex[3]) / (sine * sine);
  const Wide k = angle_vertex_minor<Wide>(theta, kEdgesAtVertex[2]) / (sine * sine);
  const Wide u = std::cos(t4) + inner(c3, c4);
  const Wide root = std::sqrt(angle_gram_minus_det<Wide>(theta)) / sine;
  const Wide radius = q / (u + root);

  const WideComplex i(0, 1);
  const std::array<WideCircle, 4> faces{
      {{0, -i, 0}, {0, i * direction, 0}, {1, c3, q}, {1 / radius, c4, radius * k}}};
  const std::array<WideCircle, 4> vertices{
      {orthogonal_to_three(direction, faces[2], faces[3]),
       orthogonal_to_three({1, 0}, faces[2], faces[3]),
       {1 / (radius * std::sqrt(k)), 0, -radius * std::sqrt(k)},
       {-1 / std::sqrt(q), 0, std::sqrt(q)}}};
  CirclePacking packing;
  for (std::size_t n = 0; n < 4; ++n) {
    packing.faces[n] = rounded(faces[n]);
    // The pole of a truncation lies on the inner side of the face opposite to it.
    const Wide sign = product(vertices[n], faces[n]) < 0 ? 1 : -1;
    packing.vertices[n] = rounded(scaled(vertices[n], sign));
  }
  return packing;
}

double intersection_angle(const Circle& first, const Circle& second) {
  if (first.is_line() && second.is_line())
    return std::acos(-inner(first.weighted_centre, second.weighted_centre));
  if (first.is_line() || second.is_line()) {
    const Circle& line = first.is_line() ? first : second;
    const Circle& circle = first.is_line() ? second : first;
    const double beyond =
        inner(circle.centre(), line.weighted_centre) - line.co_curvature / 2;  // of the line
    return std::acos(std::clamp(-beyond * circle.curvature, -1.0, 1.0));
  }
  const double r = 1 / first.curvature, s = 1 / second.curvature;
  const double distance = std::abs(first.centre() - second.centre());
  const double cosine = ((distance - r) * (distance + r) - s * s) / (2 * r * s);
  return std::acos(std::clamp(cosine, -1.0, 1.0));
}

HyperboloidTetrahedron to_hyperboloid(const CirclePacking& packing) {
  HyperboloidTetrahedron tetrahedron;
  for (std::size_t i = 0; i < 4; ++i) {
    tetrahedron.vertices[i] = plane_of(packing.vertices[i]);
    tetrahedron.faces[i] = plane_of(packing.faces[i]);
  }
  return tetrahedron;
}

CirclePacking circles_of(const HyperboloidTetrahedron& tetrahedron) {
  CirclePacking packing;
  for (std::size_t i = 0; i < 4; ++i) {
    packing.vertices[i] = circle_of(tetrahedron.vertices[i]);
    packing.faces[i] = circle_of(tetrahedron.faces[i]);
  }
  return packing;
}

Matrix4 isometry_between(const HyperboloidTetrahedron& from, const HyperboloidTetrahedron& to) {
  Matrix4 start, end;
  for (int i = 0; i < 4; ++i) {
    const auto n = static_cast<std::size_t>(i);
    // Both scaled alike, so that long and short vectors meet as equals.
    const double size = from.vertices[n].norm();
    start.col(i) = from.vertices[n] / size;
    end.col(i) = to.vertices[n] / size;
  }
  return start.transpose().partialPivLu().solve(end.transpose()).transpose();
}

CirclePacking mirrored(const CirclePacking& packing) {
  CirclePacking image = packing;
  for (auto* circles : {&image.faces, &image.vertices})
    for (Circle& circle : *circles) circle.weighted_centre = std::conj(circle.weighted_centre);
  return image;
}

Circle apply(const MoebiusMap& map, const Circle& circle) {
  // M H M* for the Hermitian matrix H with rows (co-curvature, weighted centre) and (its conjugate,
  // curvature): scales only multiply, so circles of very different sizes keep their digits.
  const Complex u = map.reverses ? std::conj(circle.weighted_centre) : circle.weighted_centre;
  const double k = circle.curvature, k2 = circle.co_curvature;
  const Complex top_left = map.a * k2 + map.b * std::conj(u), top_right = map.a * u + map.b * k;
  const Complex low_left = map.c * k2 + map.d * std::conj(u), low_right = map.c * u + map.d * k;
  return {(low_left * std::conj(map.c) + low_right * std::conj(map.d)).real(),
          top_left * std::conj(map.c) + top_right * std::conj(map.d),
          (top_left * std::conj(map.a) + top_right * std::conj(map.b)).real()};
}

}  // namespace tripus::geometry
