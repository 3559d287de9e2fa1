#pragma once

#include "geometry/edge_frames.hpp"

/// One truncated tetrahedron in numbers that enclose: docs/theory.md section 2 and 3, written once
/// for balls of doubles, packs of them and Arb's balls. The forms are those of
/// detail/gram_kernel.hpp, in which little cancels; where it chooses between two forms of the same
/// polynomial, midpoints decide, and either form encloses.
///
/// A number type N has + - * /, unary -, a double in front of *, `square`, `square_root`,
/// `angle_of` (y, x), `clausen`, `number_pi(N)`, `larger` (a mask, by midpoints) and `select`.
///
/// The vertices are hyperideal, or of the kinds that a diagonal of the Gram matrix says: 1 at a
/// hyperideal vertex, 0 at an ideal one (section 10). Then c and s are -G_ij and its slope (77).
namespace tripus::geometry {

/// The diagonal of hyperideal vertices: a factor 1 that costs nothing.
struct HyperidealDiagonal {
  struct One {
    template <class N>
    friend const N& operator*(One, const N& x) {
      return x;
    }
    friend One operator*(One, One) { return {}; }
    friend double operator*(double x, One) { return x; }
  };
  One operator[](int) const { return {}; }
};

/// Any diagonal of 0 and 1.
struct GramDiagonal {
  double d[4];
  double operator[](int i) const { return d[i]; }
};

/// What the Gram matrix of six lengths gives.
template <class N>
struct GramEnclosure {
  N c[6], s[6];       ///< cosh, sinh of the lengths, or -G_ij and its slope
  N product[3];       ///< of the cosh of opposite edges 01,23; 02,13; 03,12
  N sinh_product[3];  ///< and of the sinh
  N minus_det;        ///< -det G
  N cofactor[6];      ///< c_kl at edge ij
  N minor[4];         ///< p_l = -c_ll
};

/// -det G by theory (48).
template <class N, class Diagonal>
N minus_determinant_of(const GramEnclosure<N>& g, const Diagonal& d) {
  N close[3];  // cosh of the difference of opposite lengths
  for (int e = 0; e < 3; ++e) {
    const EdgeFrame& f = kEdgeFrames[e];
    close[e] = ((d[f.k] * d[f.l]) * square(g.c[e]) + (d[f.i] * d[f.j]) * square(g.s[5 - e])) /
               (g.product[e] + g.sinh_product[e]);
  }
  const N faces = (d[3] * (g.c[0] * g.c[1] * g.c[3]) + d[2] * (g.c[0] * g.c[2] * g.c[4])) +
                  (d[1] * (g.c[1] * g.c[2] * g.c[5]) + d[0] * (g.c[3] * g.c[4] * g.c[5]));
  const N *p = g.product, *s = g.sinh_product;
  const N mixed = ((p[0] * close[1] + s[1] * close[0]) + (p[0] * close[2] + s[2] * close[0])) +
                  (p[1] * close[2] + s[2] * close[1]);
  // The Heron term 4 yz - (x - y - z)^2 with x the largest.
  const auto first = larger(s[0], s[1]);
  const N more = select(first, s[0], s[1]), y = select(first, s[1], s[0]);
  const auto second = larger(more, s[2]);
  const N x = select(second, more, s[2]), z = select(second, s[2], more);
  return (2.0 * (faces + mixed) + number_like(2.0 * ((d[0] * d[1]) * (d[2] * d[3])), x)) +
         (4.0 * (y * z) - square((x - y) - z));
}

template <class N, class Diagonal = HyperidealDiagonal>
GramEnclosure<N> gram_enclosure(const N (&cosh)[6], const N (&sinh)[6], const Diagonal& d = {}) {
  GramEnclosure<N> g;
  for (int e = 0; e < 6; ++e) {
    g.c[e] = cosh[e];
    g.s[e] = sinh[e];
  }
  for (int e = 0; e < 3; ++e) {
    g.product[e] = g.c[e] * g.c[5 - e];
    g.sinh_product[e] = g.s[e] * g.s[5 - e];
  }
  g.minus_det = minus_determinant_of(g, d);
  for (int e = 0; e < 6; ++e) {
    const EdgeFrame& f = kEdgeFrames[e];
    const int own = e < 3 ? e : 5 - e, one = (own + 1) % 3, two = (own + 2) % 3;
    const N around = d[f.j] * (g.c[kEdgeBetween[f.i][f.k]] * g.c[kEdgeBetween[f.i][f.l]]) +
                     d[f.i] * (g.c[kEdgeBetween[f.j][f.k]] * g.c[kEdgeBetween[f.j][f.l]]);
    const N &same = g.product[own], &q = g.product[one], &r = g.product[two];
    const auto first = larger(q, r);
    const N large = select(first, q, r), small = select(first, r, q);
    const N apart = (g.c[e] * (large + small) + around) - g.c[5 - e] * square(g.s[e]);
    const N close = g.c[e] * ((large - same) + small) + (around + (d[f.i] * d[f.j]) * g.c[5 - e]);
    g.cofactor[e] = select(larger(2.0 * large, same), close, apart);
  }
  for (int v = 0; v < 4; ++v) {
    const int i = v == 0 ? 1 : 0, j = v <= 1 ? 2 : 1, k = v <= 2 ? 3 : 2;
    const N &ij = g.c[kEdgeBetween[i][j]], &ik = g.c[kEdgeBetween[i][k]],
            &jk = g.c[kEdgeBetween[j][k]];
    g.minor[v] = 2.0 * (ij * ik * jk) +
                 ((d[i] * square(jk) + d[j] * square(ik)) + d[k] * square(g.s[kEdgeBetween[i][j]]));
  }
  return g;
}

/// Dihedral angles, theory (9); -det G must be > 0.
template <class N>
void angle_enclosures(const GramEnclosure<N>& g, const N& root, N (&theta)[6]) {
  for (int e = 0; e < 6; ++e) theta[e] = angle_of(root * g.s[e], g.cofactor[e]);
}

/// The Jacobian, packed [21], theory (17) to (19); root = sqrt(-det G).
template <class N, class Diagonal = HyperidealDiagonal>
void jacobian_enclosure(const GramEnclosure<N>& g, const N& root, N* jacobian,
                        const Diagonal& d = {}) {
  const N one = number_like(1.0, root);
  const N inverse_root = one / root;
  N ratio[4];
  for (int v = 0; v < 4; ++v) ratio[v] = one / g.minor[v];
  for (int a = 0; a < 6; ++a) {
    const EdgeFrame& f = kEdgeFrames[a];
    const int own = a < 3 ? a : 5 - a, next = (own + 1) % 3, last = (own + 2) % 3;
    const N &ik = g.c[kEdgeBetween[f.i][f.k]], &il = g.c[kEdgeBetween[f.i][f.l]];
    const N &jk = g.c[kEdgeBetween[f.j][f.k]], &jl = g.c[kEdgeBetween[f.j][f.l]];
    const N along =
        (d[f.l] * g.c[a] + il * jl) * ratio[f.k] + (d[f.k] * g.c[a] + ik * jk) * ratio[f.l];
    const N spread = (g.product[own] - g.product[next]) + (g.product[own] - g.product[last]);
    jacobian[packed_index(a, a)] = (spread + g.cofactor[a] * along) * inverse_root;
    for (int b = a + 1; b < 6; ++b) {
      const N scale = (g.s[a] * g.s[b]) * inverse_root;
      if (a + b == 5) {
        jacobian[packed_index(a, b)] = scale;
        continue;
      }
      // a = ij and b = ik share the vertex i, and l is outside their face.
      const EdgeFrame& h = kEdgeFrames[b];
      const int i = (f.i == h.i || f.i == h.j) ? f.i : f.j;
      const int j = f.i + f.j - i, k = h.i + h.j - i, l = 6 - i - j - k;
      jacobian[packed_index(a, b)] = -(scale * (g.cofactor[kEdgeBetween[j][k]] * ratio[l]));
    }
  }
}

template <class N>
struct ComplexEnclosure {
  N re, im;
};
template <class N>
ComplexEnclosure<N> operator*(const ComplexEnclosure<N>& a, const ComplexEnclosure<N>& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
template <class N>
ComplexEnclosure<N> operator+(const ComplexEnclosure<N>& a, const ComplexEnclosure<N>& b) {
  return {a.re + b.re, a.im + b.im};
}

/// Volume, theory (24) and (25). The unit complex numbers of the angles come from the Gram matrix,
/// theory (10), and -det g = D^3 / (p_0 p_1 p_2 p_3).
template <class N>
N volume_enclosure(const GramEnclosure<N>& g, const N& root, const N (&theta)[6]) {
  N inverse[4];
  for (int v = 0; v < 4; ++v) inverse[v] = number_like(1.0, root) / square_root(g.minor[v]);
  ComplexEnclosure<N> unit[6];
  for (int e = 0; e < 6; ++e) {
    const N both = inverse[kEdgeFrames[e].k] * inverse[kEdgeFrames[e].l];
    unit[e] = {g.cofactor[e] * both, (root * g.s[e]) * both};
  }
  const auto &a = unit[0], &b = unit[1], &c = unit[2], &d = unit[5], &e = unit[4], &f = unit[3];
  const auto ad = a * d, be = b * e, cf = c * f;
  const auto denominator = ((ad + be) + (cf + (a * b) * f)) +
                           (((a * c) * e + (b * c) * d) + ((d * e) * f + (ad * be) * cf));
  const N numerator = a.im * d.im + (b.im * e.im + c.im * f.im);
  const N all = (inverse[0] * inverse[1]) * (inverse[2] * inverse[3]);
  const N spread = angle_of((g.minus_det * root) * all, numerator);
  const N pi = number_pi(root);
  const N centre = pi - angle_of(denominator.im, denominator.re);

  const N A = theta[0], B = theta[1], C = theta[2], D = theta[5], E = theta[4], F = theta[3];
  const N plus[3] = {(A + D) + (B + E), (A + D) + (C + F), (B + E) + (C + F)};
  const N minus[4] = {pi + ((A + B) + C), pi + ((A + E) + F), pi + ((B + D) + F),
                      pi + ((C + D) + E)};
  const N low = centre - spread, high = centre + spread;
  N sum = clausen(low) - clausen(high);
  for (const N& x : plus) sum = sum + (clausen(low + x) - clausen(high + x));
  for (const N& x : minus) sum = sum - (clausen(low + x) - clausen(high + x));
  return 0.25 * sum;
}

/// Whether the symmetric matrix A - shift I is positive definite for every member of A, packed
/// [21]: all pivots of its factorisation without roots are. `least` of a pivot is its lower bound.
/// Returns the smallest lower bound of a pivot: > 0 proves it, anything else does not. A pivot that
/// is NaN makes all that follow NaN, and so the result.
template <class N, class Least>
auto smallest_pivot(const N* A, const N& shift, Least least) {
  N work[6][6];
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j <= i; ++j)
      work[i][j] = i == j ? A[packed_index(i, i)] - shift : A[packed_index(j, i)];
  auto smallest = least(work[0][0]);
  for (int k = 0; k < 5; ++k) {
    const N inverse = number_like(1.0, shift) / work[k][k];
    for (int i = k + 1; i < 6; ++i) {
      const N factor = work[i][k] * inverse;
      for (int j = k + 1; j <= i; ++j) work[i][j] = work[i][j] - factor * work[j][k];
    }
    const auto pivot = least(work[k + 1][k + 1]);
    smallest = smallest < pivot ? smallest : pivot;
  }
  return smallest;
}

}  // namespace tripus::geometry
