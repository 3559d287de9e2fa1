#include "geometry/truncated_tetrahedron.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "geometry/batch.hpp"
#include "geometry/detail/angle_gram.hpp"
#include "geometry/detail/gram_kernel.hpp"
#include "geometry/detail/kernel_answer.hpp"
#include "geometry/detail/scaled_gram.hpp"
#include "geometry/detail/scaled_kernel.hpp"

namespace tripus::geometry {
namespace {

ScaledGram scaled_gram(const double* l) {
  // A quarter of the lengths, so that sums of them cannot overflow.
  double quarter[6];
  std::transform(l, l + 6, quarter, [](double x) { return x / 4; });
  const Exponents u = scaling_exponents(quarter);
  ScaledGram g;
  for (std::size_t i = 0; i < 4; ++i) g.d[i] = std::exp(-8 * u[i]);
  for (int e = 0; e < 6; ++e) {
    const EdgeFrame& f = kEdgeFrames[e];
    const double u_i = u[static_cast<std::size_t>(f.i)], u_j = u[static_cast<std::size_t>(f.j)];
    if (l[e] <= 1) {
      const double factor = std::exp(-4 * (u_i + u_j));
      g.s[e] = std::sinh(l[e]) * factor;
      g.c[e] = std::cosh(l[e]) * factor;
    } else {
      const double leading = std::exp(4 * ((quarter[e] - u_i) - u_j)) / 2;
      g.s[e] = -leading * std::expm1(-2 * l[e]);
      g.c[e] = leading * (1 + std::exp(-2 * l[e]));
    }
  }
  const double total = u[0] + u[1] + u[2] + u[3];
  for (int e = 0; e < 3; ++e) {
    const double leading = std::exp(4 * ((quarter[e] + quarter[5 - e]) - total)) / 4;
    g.products.c[e] = leading * ((1 + std::exp(-2 * l[e])) * (1 + std::exp(-2 * l[5 - e])));
    g.products.s[e] = leading * (std::expm1(-2 * l[e]) * std::expm1(-2 * l[5 - e]));
  }
  return g;
}

/// One tetrahedron by the scaled Gram matrix; l >= 0, any size. Returns -det G, scaled, or the
/// least positive number where it underflows.
double scaled_kernel(const double* l, double* theta, double* jacobian) {
  double packed[kPackedJacobian];
  const double det = scaled_gram_kernel(scaled_gram(l), theta, packed);
  for (int e = 0; e < 6; ++e)
    if (!(l[e] > 0)) packed[packed_index(e, e)] = 0;
  if (jacobian != nullptr) std::copy(packed, packed + kPackedJacobian, jacobian);
  return det;
}

/// The unscaled route, in the same operations as the batched kernels.
double unscaled_kernel(const double* l, double* theta, double* jacobian) {
  double c[6], s[6];
  for (int e = 0; e < 6; ++e) {
    const SinhCosh<double> h = sinh_cosh(l[e]);
    s[e] = h.sinh;
    c[e] = h.cosh;
  }
  const double det = gram_kernel(c, s, UnitDiagonal{}, opposite_products(c, s), theta, jacobian);
  if (jacobian != nullptr) {
    for (int e = 0; e < 6; ++e)
      if (!(s[e] > 0)) jacobian[packed_index(e, e)] = 0;
  }
  return det;
}

}  // namespace

std::size_t scaled_angles_of_lane(const double* lengths, double* theta, double* jacobian) {
  double l[6], angle[6], packed[kPackedJacobian];
  for (std::size_t e = 0; e < 6; ++e) l[e] = std::max(lengths[kLanes * e], 0.0);
  const double det = scaled_kernel(l, angle, jacobian == nullptr ? nullptr : packed);
  for (std::size_t e = 0; e < 6; ++e) theta[kLanes * e] = angle[e];
  if (jacobian != nullptr)
    for (std::size_t q = 0; q < kPackedJacobian; ++q) jacobian[kLanes * q] = packed[q];
  return det > 0 ? 0 : 1;
}

TetrahedronKind extended_dihedral_angles(std::span<const double, 6> l, std::span<double, 6> theta,
                                         std::span<double> jacobian) {
  double clamped[6], packed[kPackedJacobian];
  std::transform(l.begin(), l.end(), clamped, [](double x) { return std::max(x, 0.0); });
  const bool huge = *std::max_element(clamped, clamped + 6) > kUnscaledLimit;
  double* wanted = jacobian.empty() ? nullptr : packed;
  const double det = huge ? scaled_kernel(clamped, theta.data(), wanted)
                          : unscaled_kernel(clamped, theta.data(), wanted);
  unpack_jacobian(packed, jacobian);
  return kind_of(det, theta.data());
}

TetrahedronKind dihedral_angles(std::span<const double, 6> l, std::span<double, 6> theta,
                                std::span<double> jacobian) {
  for (std::size_t e = 0; e < 6; ++e) {
    if (!std::isfinite(l[e]) || l[e] <= 0) {
      throw InvalidInput("edge length " + std::to_string(e) + " of the tetrahedron is " +
                         std::to_string(l[e]) + "; lengths are finite and greater than 0");
    }
  }
  return extended_dihedral_angles(l, theta, jacobian);
}

bool lengths_from_angles(std::span<const double, 6> theta, std::span<double, 6> l) {
  double minor[4];
  for (std::size_t v = 0; v < 4; ++v) {
    minor[v] = angle_vertex_minor(theta, kEdgesAtVertex[v]);
    if (!(minor[v] > 0)) return false;
  }
  const double det = angle_gram_minus_det(theta);
  if (!(det > 0)) return false;
  const double root = std::sqrt(det);
  for (int e = 0; e < 6; ++e) {
    const EdgeFrame& f = kEdgeFrames[e];
    l[static_cast<std::size_t>(e)] = std::asinh(
        root * std::sin(theta[static_cast<std::size_t>(e)]) / std::sqrt(minor[f.i] * minor[f.j]));
  }
  return true;
}

}  // namespace tripus::geometry
