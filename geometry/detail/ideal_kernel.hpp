#pragma once

#include "geometry/detail/gram_kernel.hpp"

/// The kernel of one tetrahedron whose vertices are all ideal, docs/theory.md (83), written once
/// for all widths. Its link triangles are similar, so that three sides say everything: half the
/// arithmetic of the kernel for any kind of vertex, and no range of lengths needs another one.
namespace tripus::geometry {
namespace {

/// Dihedral angles theta [6], and their Jacobian [21] (packed upper triangle) unless null, from the
/// lengths l [6], which are finite. Flat tetrahedra get their extended angles, exactly 0 or pi.
/// The Jacobian is zero for them and beyond kLargestJacobian, as in gram_kernel.
/// Returns a number that is positive exactly for tetrahedra that are not flat.
template <class Real>
inline Real ideal_kernel(const Real* l, Real* theta, Real* jacobian) {
  const Real zero = broadcast<Real>(0.0);
  const Real one = broadcast<Real>(1.0);
  // Halves first: the sum of two lengths may be too large for a double. Opposite pairs with the
  // same two lengths get the same sides.
  Real half[3];
  for (int k = 0; k < 3; ++k) half[k] = 0.5 * l[k] + 0.5 * l[5 - k];
  const Real longest = maximum(maximum(half[0], half[1]), half[2]);
  // The sides of the link triangle in units of the longest, exp(-2 q), and what is missing to 1.
  // Beyond the limit a side is 1e-152: whether the triangle is flat does not change any more.
  Real side[3], missing[3];
  for (int k = 0; k < 3; ++k) {
    const Real q = minimum(0.5 * (longest - half[k]), broadcast<Real>(175.0));
    const SinhCosh<Real> h = sinh_cosh(q);
    const Real root = 1.0 / (h.cosh + h.sinh);
    side[k] = root * root;
    missing[k] = 2.0 * (h.sinh * root);
  }
  const Real middle =
      maximum(minimum(side[0], side[1]), minimum(maximum(side[0], side[1]), side[2]));
  const Real least = minimum(minimum(side[0], side[1]), side[2]);
  const Real gap = maximum(minimum(missing[0], missing[1]),
                           minimum(maximum(missing[0], missing[1]), missing[2]));  // 1 - middle
  // Four times the area, by Heron's formula in Kahan's order.
  const Real excess = least - gap;
  const Real sum = least + middle;
  const Real area = square_root((1.0 + sum) * (1.0 + (middle - least))) *
                    square_root(maximum(excess, zero) * (least + gap));
  // b^2 + c^2 - a^2 at each angle.
  const Real largest_cosine = least * least - gap * (1.0 + middle);
  const Real middle_cosine = least * least + gap * (1.0 + middle);
  const Real least_cosine = 1.0 + (middle - least) * sum;
  Real cosine[3];
  for (int k = 0; k < 3; ++k) {
    const Real smaller = side[k] < middle ? least_cosine : middle_cosine;
    cosine[k] = side[k] < one ? smaller : largest_cosine;
    theta[k] = theta[5 - k] = upper_atan2(area, cosine[k]);
  }
  if (jacobian == nullptr) return excess;

  // d theta_k / d l of its own edges is a^2 / 4A, of the others minus half a cotangent.
  const Real inverse = excess > zero ? 1.0 / area : zero;
  const Real kept = inverse < broadcast<Real>(kLargestJacobian) ? inverse : zero;
  Real own[3], other[3];  // other[k]: between the two pairs that are not k
  for (int k = 0; k < 3; ++k) {
    own[k] = (side[k] * side[k]) * kept;
    other[k] = -0.5 * (cosine[k] * kept);
  }
  for (int i = 0; i < 6; ++i)
    for (int j = i; j < 6; ++j) {
      const int a = i < 3 ? i : 5 - i, b = j < 3 ? j : 5 - j;
      jacobian[packed_index(i, j)] = a == b ? own[a] : other[3 - a - b];
    }
  return excess;
}

}  // namespace
}  // namespace tripus::geometry
