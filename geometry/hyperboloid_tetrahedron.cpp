#include "geometry/hyperboloid_tetrahedron.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <Eigen/Dense>

#include "base/error.hpp"
#include "geometry/mixed_tetrahedron.hpp"
#include "geometry/truncated_tetrahedron.hpp"

namespace tripus::geometry {
namespace {

// Everything is computed in the widest type of the machine and rounded once: the digits that the
// shape costs (a nearly flat or a very long tetrahedron) are then mostly the spare ones.
using Wide = long double;
using WideVector = Eigen::Matrix<Wide, 4, 1>;
using WideMatrix = Eigen::Matrix<Wide, 4, 4>;

constexpr int kEnds[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};

/// docs/theory.md (77), in the widest type.
Wide gram_entry_of(Wide l, double d_i, double d_j) {
  if (d_i == 0 || d_j == 0) return (d_i == d_j ? -2 : -1) * std::exp(l);
  return d_i == d_j ? -std::cosh(l) : -std::sinh(l);
}

WideMatrix gram_matrix(std::span<const double, 6> l, std::span<const double, 4> diagonal) {
  WideMatrix gram;
  for (int i = 0; i < 4; ++i) gram(i, i) = diagonal[static_cast<std::size_t>(i)];
  for (std::size_t e = 0; e < 6; ++e) {
    const int i = kEnds[e][0], j = kEnds[e][1];
    gram(i, j) = gram(j, i) = gram_entry_of(Wide(l[e]), diagonal[static_cast<std::size_t>(i)],
                                            diagonal[static_cast<std::size_t>(j)]);
  }
  return gram;
}

/// Weights s > 0 with s_i sum_j |G_ij| s_j near 1 for every i: after scaling, no entry exceeds 1
/// and no row is small. The iteration need not converge, but it must treat all labels alike.
WideVector balancing_weights(const WideMatrix& gram) {
  constexpr int kRounds = 40;
  const WideMatrix size = gram.cwiseAbs();
  WideVector weights = WideVector::Ones();
  for (int round = 0; round < kRounds; ++round)
    weights = weights.cwiseQuotient(size * weights).cwiseSqrt().eval();
  return weights;
}

/// Turns space about the origin: v_3 up, v_0 over the positive x axis, the determinant
/// of the sign that is asked for.
WideMatrix standing_rotation(const WideMatrix& vertices, int orientation) {
  using Wide3 = Eigen::Matrix<Wide, 3, 1>;
  const Wide3 up = vertices.col(3).head<3>().normalized();
  Wide3 right = vertices.col(0).head<3>();
  right -= right.dot(up) * up;
  if (right.norm() < std::sqrt(std::numeric_limits<Wide>::epsilon())) right = up.unitOrthogonal();
  right.normalize();
  Wide3 back = up.cross(right);
  // The rotation (right, back, up) keeps the sign of the determinant.
  if (vertices.determinant() * orientation < 0) back = -back;
  WideMatrix rotation = WideMatrix::Identity();
  rotation.row(0).head<3>() = right;
  rotation.row(1).head<3>() = back;
  rotation.row(2).head<3>() = up;
  return rotation;
}

void require_tetrahedron(std::span<const double, 6> l, std::span<const double, 4> diagonal) {
  const bool truncated = std::ranges::all_of(diagonal, [](double d) { return d > 0; }) &&
                         std::ranges::none_of(l, [](double x) { return x == 0; });
  std::array<double, 6> theta{};
  for (std::size_t e = 0; e < 6; ++e) {
    if (l[e] > kLongestEmbeddedEdge) {
      throw Unsupported("edge " + std::to_string(e) + " has the length " + std::to_string(l[e]) +
                        "; coordinates of edges longer than " +
                        std::to_string(static_cast<int>(kLongestEmbeddedEdge)) +
                        " do not fit into floating-point numbers");
    }
    const double i = diagonal[static_cast<std::size_t>(kEnds[e][0])];
    const double j = diagonal[static_cast<std::size_t>(kEnds[e][1])];
    if (truncated || i == 0 || j == 0 || l[e] > 0) continue;
    if (i * j < 0)
      throw Unsupported("edge " + std::to_string(e) +
                        ": the finite vertex lies beyond the truncating plane");
  }
  if (truncated ? dihedral_angles(l, theta) != TetrahedronKind::kTruncated
                : !general_dihedral_angles(l, diagonal, theta))
    throw InvalidInput(truncated ? "the six lengths are not those of a truncated tetrahedron: it "
                                   "is flat"
                                 : "the six lengths are not those of a tetrahedron with such "
                                   "vertices, or it is flat");
}

}  // namespace

HyperboloidTetrahedron hyperboloid_tetrahedron(std::span<const double, 6> l, int orientation) {
  return hyperboloid_tetrahedron(l, HyperboloidTetrahedron{}.diagonal, orientation);
}

HyperboloidTetrahedron hyperboloid_tetrahedron(std::span<const double, 6> l,
                                               std::span<const double, 4> diagonal,
                                               int orientation) {
  require_tetrahedron(l, diagonal);
  const WideMatrix gram = gram_matrix(l, diagonal);
  const WideVector weights = balancing_weights(gram);
  const WideMatrix scaled = weights.asDiagonal() * gram * weights.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<WideMatrix> solver(scaled);
  // Eigenvalues come in increasing order: the negative one, which belongs to time, first.
  const WideVector& values = solver.eigenvalues();
  if (!(values[0] < 0 && values[1] > 4 * std::numeric_limits<Wide>::epsilon()))
    throw InvalidInput("the tetrahedron is so nearly flat that it cannot be placed in space");
  WideMatrix frame;  // columns: the scaled vertices
  WideMatrix dual;   // columns: the vectors with product 1 with their vertex, 0 with the others
  for (int axis = 0; axis < 4; ++axis) {
    const int from = (axis + 1) % 4;
    const Wide root = std::sqrt(std::abs(values[from]));
    frame.row(axis) = root * solver.eigenvectors().col(from).transpose();
    dual.row(axis) = solver.eigenvectors().col(from).transpose() / (axis == 3 ? -root : root);
  }
  if (frame(3, 0) < 0) {
    frame.row(3) *= -1;
    dual.row(3) *= -1;
  }
  const WideMatrix rotation = standing_rotation(frame, orientation);
  frame = (rotation * frame).eval();
  dual = (rotation * dual).eval();
  HyperboloidTetrahedron result;
  std::ranges::copy(diagonal, result.diagonal.begin());
  for (std::size_t e = 0; e < 6; ++e)
    if (l[e] == 0 && diagonal[static_cast<std::size_t>(kEnds[e][0])] > 0 &&
        diagonal[static_cast<std::size_t>(kEnds[e][1])] > 0)
      result.parabolic_edges |= static_cast<std::uint8_t>(1u << e);
  for (int i = 0; i < 4; ++i) {
    const auto n = static_cast<std::size_t>(i);
    result.vertices[n] = (frame.col(i) / weights[i]).cast<double>();
    const WideVector w = dual.col(i);
    const Wide norm = std::sqrt(w.head<3>().squaredNorm() - w[3] * w[3]);
    result.faces[n] = (-w / norm).cast<double>();
  }
  return result;
}

Vector4 corner(const HyperboloidTetrahedron& tetrahedron, int i, int j) {
  const WideVector v = tetrahedron.vertices[static_cast<std::size_t>(i)].cast<Wide>();
  const WideVector w = tetrahedron.vertices[static_cast<std::size_t>(j)].cast<Wide>();
  const Wide product = v.head<3>().dot(w.head<3>()) - v[3] * w[3];
  const double d_i = tetrahedron.diagonal[static_cast<std::size_t>(i)];
  const double d_j = tetrahedron.diagonal[static_cast<std::size_t>(j)];
  if (d_i < 0) return tetrahedron.vertices[static_cast<std::size_t>(i)];
  if (d_i == 0) {
    const Wide b = -1 / product;  // x = a v + b w with <x, v> = -1 and <x, x> = -1
    return on_hyperboloid(((1 + b * b * d_j) / 2 * v + b * w).cast<double>());
  }
  const WideVector along = w - product * v;
  // s of docs/theory.md (77); the factors keep its digits for short edges.
  const Wide s =
      d_j > 0 ? std::sqrt((product - 1) * (product + 1)) : std::sqrt(product * product - d_j);
  return on_hyperboloid((along / s).cast<double>());
}

Vector4 HyperboloidTetrahedron::parabolic_point(std::size_t e) const {
  return parabolic_scale * (vertices[static_cast<std::size_t>(kEnds[e][0])] +
                            vertices[static_cast<std::size_t>(kEnds[e][1])]);
}

Vector4 parabolic_corner(const HyperboloidTetrahedron& tetrahedron, int i, int j, int f) {
  const Vector4& v = tetrahedron.vertices[static_cast<std::size_t>(i)];
  const Vector4& n = tetrahedron.faces[static_cast<std::size_t>(f)];
  const Vector4 p =
      tetrahedron.parabolic_scale * (v + tetrahedron.vertices[static_cast<std::size_t>(j)]);
  // x = a p + b q in the plane of p and q, which is orthogonal to v and n.
  const Vector4 q = origin() - lorentz_product(origin(), v) * v - lorentz_product(origin(), n) * n;
  const double b = -1 / lorentz_product(p, q);
  return on_hyperboloid((1 + b * b * lorentz_product(q, q)) / 2 * p + b * q);
}

Vector4 on_horosphere(const Vector4& m, const Vector4& v) {
  return on_hyperboloid(m + (lorentz_product(m, m) + 1) / 2 * v);
}

}  // namespace tripus::geometry
