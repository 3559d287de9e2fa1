#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "structure/certificate.hpp"
#include "topology/cone_angle.hpp"
#include "topology/triangulation.hpp"

namespace tripus::structure::detail {

/// The exact decision about angle structures of few tetrahedra with hyperideal vertices only and
/// all cone angles 2 pi, in units of pi:
///     the least L such that some angles >= 0 with all edge sums 2 have all vertex sums <= L.
/// L > 1: there is no angle structure. L = 1: there are some, none is strict. L < 1: there are
/// strict ones (a little of 2 / valence at every corner makes them so). Source: docs/theory.md
/// (50'). The simplex method in whole numbers, on a dense table: the entries are minors of a matrix
/// of 0 and 1, kept in doubles, which are exact as long as the numbers are small.
class SmallProgramme {
 public:
  /// Up to so many tetrahedra a dense table is the quickest.
  static constexpr std::size_t kMostTetrahedra = 12;

  /// `flat` [T], or empty for none: tetrahedra that have angle pi at two opposite edges, `flat[t]`
  /// (0, 1, 2) and 5 - flat[t], and 0 at the others; -1 for all the rest. The vertices of flat ones
  /// do not count for L.
  explicit SmallProgramme(const topology::Triangulation& triangulation,
                          std::span<const int> flat = {});

  /// False if numbers grew too large, or after many steps; then nothing is known.
  bool solve();

  // After `solve`.

  /// The sign of L - 1; 1 where the flat tetrahedra leave no angles >= 0 for the others.
  int sign() const { return sign_; }
  /// Where L >= 1: vertex multipliers w, of which certificates are made.
  std::vector<std::array<std::int64_t, 4>> vertex_multipliers() const;
  /// The angles found, of vertex sums <= L; each denotes itself divided by `denominator`.
  std::vector<std::array<std::int64_t, 6>> angles() const;
  std::int64_t denominator() const { return static_cast<std::int64_t>(denominator_); }

  /// Where L <= 1: a tetrahedron, not one of `flat`, that has an angle 0 or a vertex sum pi in
  /// every angle structure, as far as the multipliers tell.
  std::optional<std::size_t> never_true() const;
  /// Whether the angle at a corner of that tetrahedron may be more than 0, as far as they tell.
  bool may_be_positive(std::size_t t, std::size_t edge) const;

 private:
  double& at(std::size_t row, std::size_t column) { return table_[row * width_ + column]; }
  double at(std::size_t row, std::size_t column) const { return table_[row * width_ + column]; }
  bool is_flat(std::size_t t) const { return !flat_.empty() && flat_[t] >= 0; }
  std::vector<double> edge_sums(const topology::Triangulation& triangulation) const;
  void fill(const topology::Triangulation& triangulation, const std::vector<double>& edge_sums);
  void pivot(std::size_t row, std::size_t column);
  bool minimise();

  // Variables: corners 6 t + e, then slacks 6 T + 4 t + v of the vertex sums. Every basic variable
  // is (table[row][0] + sum of table[row][k] * the k-th variable that is 0) / denominator. The last
  // row is L.
  std::vector<int> flat_;  // [T], or empty
  std::size_t tetrahedra_, rows_ = 0, width_ = 0;
  bool impossible_ = false;
  std::vector<char> is_zero_;          // [6 T] corners at edges whose sum the flat ones take up
  std::vector<double> table_;          // [rows + 1][width]
  std::vector<std::size_t> row_of_;    // [10 T] kNowhere if not basic
  std::vector<std::size_t> basic_;     // [rows]
  std::vector<std::size_t> nonbasic_;  // [width], from 1
  double denominator_ = 1;
  int sign_ = 0;
};

/// What is decided about a triangulation of few tetrahedra without looking for a metric, exactly
/// and in microseconds.
struct SmallDecision {
  /// That there is no strict angle structure; if there is none, there is one.
  std::optional<Certificate> certificate;
  /// Whether the co-volume may have a minimiser, with flat tetrahedra, all the same.
  bool may_be_degenerate = false;
};

/// Nothing beyond SmallProgramme::kMostTetrahedra, where some vertex is not hyperideal or some cone
/// angle not 2 pi, and where numbers grow too large: then others must decide. The certificate has
/// not been checked. Certificates of valence 1 and 2 come without a programme; docs/theory.md
/// section 5.
std::optional<SmallDecision> decide_small(const topology::Triangulation& triangulation,
                                          std::span<const topology::ConeAngle> cone_angles);

/// Whether some edge has a valence that no strict angle structure allows: 1 or 2.
bool has_low_valence(const topology::Triangulation& triangulation);

}  // namespace tripus::structure::detail
