#pragma once

#include "geometry/detail/elementary.hpp"
#include "geometry/edge_frames.hpp"

/// The kernel of one truncated tetrahedron from its Gram matrix, docs/theory.md section 2, written
/// once for all widths.
///
/// Which of the algebraically equal forms of the determinant and the cofactors is used decides the
/// accuracy. Here every sum has terms of one sign, but for three places where a subtraction is the
/// geometry itself: the Heron term of the determinant (it vanishes where the tetrahedron goes
/// flat), the opposite edge's term in the cofactor (it vanishes at a right angle), and the diagonal
/// of the Jacobian. The error is then that of a relative change of the lengths by a few ulp.
///
/// A Gram matrix may be given scaled, G -> S G S, which changes no angle: then the diagonal is
/// s_i^2 instead of 1 and the sinh and cosh of edge ij carry the factor s_i s_j.
namespace tripus::geometry {
namespace {

/// Diagonal of an unscaled Gram matrix: a factor 1 that costs nothing.
struct UnitDiagonal {
  struct One {
    template <class Real>
    friend Real operator*(One, Real x) {
      return x;
    }
    friend double operator*(One, One) { return 1.0; }
  };
  One operator[](int) const { return {}; }
};

/// The products of the cosh, and of the sinh, at the three pairs of opposite edges 01,23; 02,13;
/// 03,12. Pairs with the same two lengths must have exactly the same products: on triangulations
/// with few edge classes that is common, and then long thin tetrahedra lie exactly on the ridge
/// between two ways to be flat, where a difference of rounding errors decides everything.
template <class Real>
struct OppositeProducts {
  Real c[3];
  Real s[3];
};

template <class Real>
inline OppositeProducts<Real> opposite_products(const Real* c, const Real* s) {
  return {{c[0] * c[5], c[1] * c[4], c[2] * c[3]}, {s[0] * s[5], s[1] * s[4], s[2] * s[3]}};
}

/// cosh(l_ij - l_kl) at a pair of opposite edges, scaled, from c = cosh and s = sinh of l_ij, l_kl.
/// The difference of products is taken as (cosh^2 + sinh^2) / (sum of products): no cancellation.
template <int E, class Real, class Diagonal>
inline Real cosh_of_difference(const Real* c, const Real* s, const Diagonal& d, Real p,
                               Real sigma) {
  constexpr EdgeFrame f = kEdgeFrames[E];
  const Real squares =
      d[f.k] * (d[f.l] * (c[E] * c[E])) + d[f.i] * (d[f.j] * (s[5 - E] * s[5 - E]));
  // It never exceeds the product of the cosh; a scaled product may underflow to 0.
  return p > broadcast<Real>(0.0) ? minimum(squares / (p + sigma), p) : p;
}

/// -det G, docs/theory.md (48): all terms are positive but for one subtraction in the Heron term of
/// the products of sinh, which is taken in its stable order, largest product first.
template <class Real, class Diagonal>
inline Real minus_determinant(const Real* c, const Real* s, const Diagonal& d,
                              const OppositeProducts<Real>& products) {
  const auto& [p, q, r] = products.c;
  const auto& [sp, sq, sr] = products.s;
  const Real kp = cosh_of_difference<0>(c, s, d, p, sp);
  const Real kq = cosh_of_difference<1>(c, s, d, q, sq);
  const Real kr = cosh_of_difference<2>(c, s, d, r, sr);
  const Real faces = d[3] * (c[0] * c[1] * c[3]) + d[2] * (c[0] * c[2] * c[4]) +
                     d[1] * (c[1] * c[2] * c[5]) + d[0] * (c[3] * c[4] * c[5]);
  const Real mixed = (p * kq + sq * kp) + (p * kr + sr * kp) + (q * kr + sr * kq);
  const Real largest = maximum(maximum(sp, sq), sr);
  const Real least = minimum(minimum(sp, sq), sr);
  const Real middle = maximum(minimum(sp, sq), minimum(maximum(sp, sq), sr));
  const Real excess = (largest - middle) - least;
  const Real one = broadcast<Real>(1.0);
  return (2.0 * (d[0] * (d[1] * (d[2] * (d[3] * one))) + faces + mixed) + 4.0 * (middle * least)) -
         excess * excess;
}

/// -c_ll > 0: the principal minor of the face ijk opposite l, with its sign turned.
template <int L, class Real, class Diagonal>
inline Real minus_face_minor(const Real* c, const Real* s, const Diagonal& d) {
  constexpr int i = L == 0 ? 1 : 0, j = L <= 1 ? 2 : 1, k = L <= 2 ? 3 : 2;
  const Real ij = c[kEdgeBetween[i][j]], ik = c[kEdgeBetween[i][k]], jk = c[kEdgeBetween[j][k]];
  const Real s_ij = s[kEdgeBetween[i][j]];
  return 2.0 * (ij * ik * jk) + d[i] * (jk * jk) + d[j] * (ik * ik) + d[k] * (s_ij * s_ij);
}

/// The cofactor c_kl that goes with edge e = ij, docs/theory.md (7). Where the product of the cosh
/// of another pair is about as large as that of ij and kl, -a_kl s_ij^2 is split so that the two
/// are subtracted from each other.
template <int E, class Real, class Diagonal>
inline Real edge_cofactor(const Real* c, const Real* s, const Diagonal& d,
                          const OppositeProducts<Real>& products) {
  constexpr EdgeFrame f = kEdgeFrames[E];
  constexpr int own = E < 3 ? E : 5 - E, one = (own + 1) % 3, two = (own + 2) % 3;
  const Real ik = c[kEdgeBetween[f.i][f.k]], il = c[kEdgeBetween[f.i][f.l]];
  const Real jk = c[kEdgeBetween[f.j][f.k]], jl = c[kEdgeBetween[f.j][f.l]];
  const Real same = products.c[own];
  const Real large = maximum(products.c[one], products.c[two]);
  const Real small = minimum(products.c[one], products.c[two]);
  const Real around = d[f.j] * (ik * il) + d[f.i] * (jk * jl);
  const Real apart = (c[E] * (large + small) + around) - c[5 - E] * (s[E] * s[E]);
  const Real close = c[E] * ((large - same) + small) + (around + d[f.i] * (d[f.j] * c[5 - E]));
  return ((large > 0.5 * same) & (large < 2.0 * same)) ? close : apart;
}

/// What the Jacobian needs of one tetrahedron.
template <class Real>
struct GramTerms {
  Real inverse_root;  ///< 1 / sqrt(-det G), 0 where the tetrahedron is flat
  Real ratio[4];      ///< 1 / -c_ll
  Real cofactor[6];   ///< c_kl at edge ij
};

/// d theta_ij / d l_ij, docs/theory.md: Jacobian, diagonal.
template <int E, class Real, class Diagonal>
inline Real jacobian_diagonal(const Real* c, const Diagonal& d,
                              const OppositeProducts<Real>& products, const GramTerms<Real>& g) {
  constexpr EdgeFrame f = kEdgeFrames[E];
  const Real ik = c[kEdgeBetween[f.i][f.k]], il = c[kEdgeBetween[f.i][f.l]];
  const Real jk = c[kEdgeBetween[f.j][f.k]], jl = c[kEdgeBetween[f.j][f.l]];
  constexpr int own = E < 3 ? E : 5 - E, one = (own + 1) % 3, two = (own + 2) % 3;
  const Real p = products.c[own], q = products.c[one], r = products.c[two];
  const Real along_l = (d[f.l] * c[E] + il * jl) * g.ratio[f.k];
  const Real along_k = (d[f.k] * c[E] + ik * jk) * g.ratio[f.l];
  return (((p - q) + (p - r)) + g.cofactor[E] * (along_l + along_k)) * g.inverse_root;
}

/// d theta_A / d l_B for two different edges.
template <int A, int B, class Real>
inline Real jacobian_off_diagonal(const Real* s, const GramTerms<Real>& g) {
  const Real scale = (s[A] * s[B]) * g.inverse_root;
  if constexpr (A + B == 5) {
    return scale;
  } else {
    // A = ij and B = ik share the vertex i; l is the vertex outside their face, and the cofactor
    // c_il belongs to the edge jk.
    constexpr EdgeFrame a = kEdgeFrames[A], b = kEdgeFrames[B];
    constexpr int i = (a.i == b.i || a.i == b.j) ? a.i : a.j;
    constexpr int j = a.i + a.j - i, k = b.i + b.j - i, l = 6 - i - j - k;
    return -scale * (g.cofactor[kEdgeBetween[j][k]] * g.ratio[l]);
  }
}

template <int A, int B, class Real, class Diagonal>
inline Real jacobian_entry(const Real* c, const Real* s, const Diagonal& d,
                           const OppositeProducts<Real>& products, const GramTerms<Real>& g) {
  if constexpr (A == B) {
    return jacobian_diagonal<A>(c, d, products, g);
  } else {
    return jacobian_off_diagonal<A, B>(s, g);
  }
}

/// Calls f<A, B>() for the 21 pairs A <= B.
template <class F, int... Pairs>
inline void for_packed_pairs(F&& f, std::integer_sequence<int, Pairs...>) {
  (
      [&] {
        constexpr int a = Pairs / 6, b = Pairs % 6;
        if constexpr (a <= b) f.template operator()<a, b>();
      }(),
      ...);
}

/// Where an entry of the Jacobian is larger than this, the tetrahedron is so near to a flat one
/// that sums of entries, such as those over an edge class, have no digits left.
inline constexpr double kLargestJacobian = 1e8;

/// Dihedral angles theta [6], and their Jacobian [21] (packed upper triangle) unless null, from
/// the scaled cosh c [6], sinh s [6], diagonal d and products. Flat tetrahedra get their extended
/// angles, exactly 0 or pi. The Jacobian is zero for them and beyond kLargestJacobian.
/// Returns -det G, scaled: positive exactly for true truncated tetrahedra.
template <class Real, class Diagonal>
inline Real gram_kernel(const Real* c, const Real* s, const Diagonal& d,
                        const OppositeProducts<Real>& products, Real* theta, Real* jacobian) {
  const Real zero = broadcast<Real>(0.0);
  const Real det = minus_determinant(c, s, d, products);
  const Real root = square_root(maximum(det, zero));

  GramTerms<Real> g;
  [&]<int... E>(std::integer_sequence<int, E...>) {
    ((g.cofactor[E] = edge_cofactor<E>(c, s, d, products)), ...);
    ((theta[E] = upper_atan2(root * s[E], g.cofactor[E])), ...);
  }
  (std::make_integer_sequence<int, 6>{});
  if (jacobian == nullptr) return det;

  g.inverse_root = det > zero ? 1.0 / root : zero;
  g.ratio[0] = 1.0 / minus_face_minor<0>(c, s, d);
  g.ratio[1] = 1.0 / minus_face_minor<1>(c, s, d);
  g.ratio[2] = 1.0 / minus_face_minor<2>(c, s, d);
  g.ratio[3] = 1.0 / minus_face_minor<3>(c, s, d);
  for_packed_pairs(
      [&]<int A, int B>() {
        jacobian[packed_index(A, B)] = jacobian_entry<A, B>(c, s, d, products, g);
      },
      std::make_integer_sequence<int, 36>{});
  // The matrix is positive definite: its largest entry lies on the diagonal.
  const Real largest =
      maximum(maximum(maximum(jacobian[packed_index(0, 0)], jacobian[packed_index(1, 1)]),
                      maximum(jacobian[packed_index(2, 2)], jacobian[packed_index(3, 3)])),
              maximum(jacobian[packed_index(4, 4)], jacobian[packed_index(5, 5)]));
  const Real limit = broadcast<Real>(kLargestJacobian);
  for (int q = 0; q < 21; ++q) jacobian[q] = largest < limit ? jacobian[q] : zero;
  return det;
}

}  // namespace
}  // namespace tripus::geometry
