#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "structure/proof/digits.hpp"
#include "structure/proof/proof.hpp"

namespace tripus::structure {

enum class ProvedSign : std::int8_t { kNegative = -1, kUnknown = 0, kPositive = 1, kZero = 2 };

/// The number field in which tilt sums were shown to be 0. Everything holds in exact arithmetic
/// modulo the polynomial, and can be checked with any system that knows rational polynomials.
struct ExactField {
  /// factor * the product of sqrt D of these tetrahedra, D = -det G.
  struct Root {
    std::string factor;
    std::vector<std::size_t> of;
  };
  std::string polynomial;         ///< "x^2-3*x+1"
  DecimalInterval root;           ///< there is a root between these: x below
  std::vector<std::string> gram;  ///< [E] -G_ij as polynomials in x; 1 at a pin of each cusp
  std::vector<Root> roots;        ///< [T] sqrt D; of {t} itself where it is no such product
  /// [V] sqrt(A / A_v) as polynomials in x, A_v the area of the horosphere at a cusp and A that of
  /// the first; 1 elsewhere. Empty without cusps, and where they are not in the field.
  std::vector<std::string> horospheres;
};

/// A face of a tetrahedron.
struct FaceOfTetrahedron {
  std::size_t tetrahedron = 0;
  int face = 0;
};

struct TiltSigns {
  std::vector<std::array<ProvedSign, 4>> sign;  ///< [T x 4], the same from both sides of a face
  std::optional<ExactField> field;              ///< set if some sum is shown to be 0
};

struct TiltOptions {
  bool exact = true;     ///< whether to look for a number field where enclosures contain 0
  int most_degree = 24;  ///< of that field
};

/// Signs of the tilt sums of all faces at a proved metric. What the enclosures do not tell, in
/// doubles' lengths and again in lengths of 50 digits, may be 0: then the metric is looked for in a
/// number field of small degree, and a sum is kZero if it is 0 there. Unknown is what is left.
/// With cusps: of horospheres of one area that shrink, as docs/canonical.md (T7).
///   proof  of this triangulation, proved, claim kMetric
/// Source: docs/theory.md (99), (102), (103).
TiltSigns tilt_signs(const topology::Triangulation& triangulation, const Proof& proof,
                     const TiltOptions& options = {}, const Context& context = {});

}  // namespace tripus::structure
