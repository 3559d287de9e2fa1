#include "geometry/mixed_tetrahedron.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/batch.hpp"
#include "geometry/detail/gram_kernel.hpp"
#include "geometry/detail/kernel_answer.hpp"
#include "geometry/detail/mixed_kernel.hpp"
#include "geometry/detail/scaled_gram.hpp"
#include "geometry/detail/scaled_kernel.hpp"

namespace tripus::geometry {
namespace {

/// The scaled Gram matrix of hyperideal and ideal vertices. First the horospheres are moved out so
/// far that all lengths at ideal vertices are positive, and the scaling of such a vertex is free:
/// then the exponents are those of positive lengths. Scaled, the entry of an edge with an ideal end
/// has no second exponential.
ScaledGram mixed_scaled_gram(const double* l, const double* diagonal) {
  double quarter[6];
  double longest = 0;
  for (int e = 0; e < 6; ++e) longest = std::max(longest, std::fabs(l[e]) / 4);
  int ideal_ends[6];
  for (int e = 0; e < 6; ++e) {
    const EdgeFrame& f = kEdgeFrames[e];
    const int ends = (diagonal[f.i] == 0) + (diagonal[f.j] == 0);
    ideal_ends[e] = ends;
    quarter[e] = ends > 0 ? l[e] / 4 + 2 * ends * longest : std::max(l[e], 0.0) / 4;
  }
  const Exponents u = scaling_exponents(quarter);
  ScaledGram g;
  for (std::size_t i = 0; i < 4; ++i) g.d[i] = diagonal[i] * std::exp(-8 * u[i]);
  double far[6], near[6];  // factors of the leading term in cosh and sinh
  for (int e = 0; e < 6; ++e) {
    const EdgeFrame& f = kEdgeFrames[e];
    const double u_i = u[static_cast<std::size_t>(f.i)], u_j = u[static_cast<std::size_t>(f.j)];
    const double length = std::max(l[e], 0.0);
    far[e] = ideal_ends[e] > 0 ? ideal_ends[e] : (1 + std::exp(-2 * length)) / 2;
    near[e] = ideal_ends[e] > 0 ? ideal_ends[e] : -std::expm1(-2 * length) / 2;
    const double leading = std::exp(4 * ((quarter[e] - u_i) - u_j));
    g.s[e] = leading * near[e];
    g.c[e] = leading * far[e];
  }
  const double total = u[0] + u[1] + u[2] + u[3];
  for (int e = 0; e < 3; ++e) {
    const double leading = std::exp(4 * ((quarter[e] + quarter[5 - e]) - total));
    g.products.c[e] = leading * (far[e] * far[5 - e]);
    g.products.s[e] = leading * (near[e] * near[5 - e]);
  }
  return g;
}

double mixed_scaled_kernel(const double* l, const double* diagonal, double* theta, double* packed) {
  const ScaledGram g = mixed_scaled_gram(l, diagonal);
  const double det = scaled_gram_kernel(g, theta, packed);
  for (int e = 0; e < 6; ++e)
    if (!(g.s[e] > 0)) packed[packed_index(e, e)] = 0;
  return det;
}

using Wide = long double;

/// Cofactors of a symmetric 4 x 4 matrix, and its determinant.
struct WideCofactors {
  Wide c[4][4];
  Wide det;
};

Wide minor_of(const Wide (&g)[4][4], int row, int column) {
  int r[3], c[3];
  for (int i = 0, k = 0; i < 4; ++i)
    if (i != row) r[k++] = i;
  for (int i = 0, k = 0; i < 4; ++i)
    if (i != column) c[k++] = i;
  return g[r[0]][c[0]] * (g[r[1]][c[1]] * g[r[2]][c[2]] - g[r[1]][c[2]] * g[r[2]][c[1]]) -
         g[r[0]][c[1]] * (g[r[1]][c[0]] * g[r[2]][c[2]] - g[r[1]][c[2]] * g[r[2]][c[0]]) +
         g[r[0]][c[2]] * (g[r[1]][c[0]] * g[r[2]][c[1]] - g[r[1]][c[1]] * g[r[2]][c[0]]);
}

WideCofactors wide_cofactors(const Wide (&g)[4][4]) {
  WideCofactors result;
  for (int i = 0; i < 4; ++i)
    for (int j = i; j < 4; ++j)
      result.c[i][j] = result.c[j][i] = ((i + j) % 2 == 0 ? 1 : -1) * minor_of(g, i, j);
  result.det = 0;
  for (int j = 0; j < 4; ++j) result.det += g[0][j] * result.c[0][j];
  return result;
}

}  // namespace

std::size_t mixed_scaled_angles_of_lane(const double* lengths, const double* diagonal,
                                        double* theta, double* jacobian) {
  double l[6], d[4], angle[6], packed[kPackedJacobian];
  for (std::size_t e = 0; e < 6; ++e) l[e] = lengths[kLanes * e];
  for (std::size_t v = 0; v < 4; ++v) d[v] = diagonal[kLanes * v];
  const double det = mixed_scaled_kernel(l, d, angle, packed);
  for (std::size_t e = 0; e < 6; ++e) theta[kLanes * e] = angle[e];
  if (jacobian != nullptr)
    for (std::size_t q = 0; q < kPackedJacobian; ++q) jacobian[kLanes * q] = packed[q];
  return det > 0 ? 0 : 1;
}

GramEntry gram_entry(double l, double d_i, double d_j) {
  if (d_i == 0 && d_j == 0) return {2 * std::exp(l), 2 * std::exp(l)};
  if (d_i == 0 || d_j == 0) return {std::exp(l), std::exp(l)};
  if (d_i == d_j) return {std::cosh(l), std::sinh(l)};
  return {std::sinh(l), std::cosh(l)};
}

TetrahedronKind mixed_dihedral_angles(std::span<const double, 6> l,
                                      std::span<const double, 4> diagonal,
                                      std::span<double, 6> theta, std::span<double> jacobian) {
  double packed[kPackedJacobian], c[6], s[6];
  const double det = mixed_edges(l.data(), diagonal.data(), c, s)
                         ? mixed_scaled_kernel(l.data(), diagonal.data(), theta.data(), packed)
                         : mixed_gram_kernel(c, s, diagonal.data(), theta.data(), packed);
  unpack_jacobian(packed, jacobian);
  return kind_of(det, theta.data());
}

bool general_dihedral_angles(std::span<const double, 6> l, std::span<const double, 4> diagonal,
                             std::span<double, 6> theta, std::span<double> jacobian) {
  std::fill(theta.begin(), theta.end(), 0.0);
  std::fill(jacobian.begin(), jacobian.end(), 0.0);
  Wide g[4][4], s[6];
  for (std::size_t i = 0; i < 4; ++i) g[i][i] = diagonal[i];
  for (std::size_t e = 0; e < 6; ++e) {
    const EdgeFrame& f = kEdgeFrames[e];
    const double d_i = diagonal[static_cast<std::size_t>(f.i)];
    const double d_j = diagonal[static_cast<std::size_t>(f.j)];
    const Wide x = l[e];
    const bool same = d_i == d_j, ideal = d_i == 0 || d_j == 0;
    if (same && !ideal && !(x >= 0)) return false;
    const Wide exponential = (same ? 2 : 1) * std::exp(x);
    g[f.i][f.j] = g[f.j][f.i] = ideal ? -exponential : same ? -std::cosh(x) : -std::sinh(x);
    s[e] = ideal ? exponential : same ? std::sinh(x) : std::cosh(x);
  }
  const WideCofactors m = wide_cofactors(g);
  if (!(m.det < 0)) return false;
  for (int v = 0; v < 4; ++v)
    if (!(m.c[v][v] < 0)) return false;
  const Wide root = std::sqrt(-m.det);
  for (int e = 0; e < 6; ++e) {
    const EdgeFrame& f = kEdgeFrames[e];
    theta[static_cast<std::size_t>(e)] =
        static_cast<double>(std::atan2(root * s[e], m.c[f.k][f.l]));
  }
  if (jacobian.empty()) return true;
  const Wide cube = root * root * root;
  for (int e = 0; e < 6; ++e) {
    const EdgeFrame& f = kEdgeFrames[e];
    if (!(s[e] > 0)) continue;  // a parabolic edge: its angle stays 0
    for (int o = 0; o < 6; ++o) {
      const auto [a, b, unused_k, unused_l] = kEdgeFrames[o];
      const Wide bracket = m.c[f.k][a] * m.c[f.l][b] + m.c[f.k][b] * m.c[f.l][a] -
                           m.c[f.k][f.l] * (m.c[f.k][a] * m.c[f.k][b] / m.c[f.k][f.k] +
                                            m.c[f.l][a] * m.c[f.l][b] / m.c[f.l][f.l]);
      jacobian[static_cast<std::size_t>(6 * e + o)] =
          static_cast<double>(s[o] / (s[e] * cube) * bracket);
    }
  }
  return true;
}

}  // namespace tripus::geometry
