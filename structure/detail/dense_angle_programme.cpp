#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include <fmt/format.h>

#include "base/error.hpp"
#include "structure/detail/angle_programme.hpp"
#include "structure/detail/rational_system.hpp"

// AngleProgramme where GLPK is not there: the simplex method on a dense table, in doubles or in
// fractions. Every row has an auxiliary variable, its right side minus its sum: >= 0 for an
// inequality, 0 for an equality. With all angles - m and m at 0 these are the right sides, which
// are not negative: there the method starts. m enters first and stays, being free; then the
// auxiliary variables of equalities are brought to 0, then m to its maximum.

namespace tripus::structure::detail {
namespace {

/// Beyond, a dense table is too large and too slow.
constexpr std::size_t kMostTetrahedraOfTable = 300;

/// Steps after which the rule of Bland chooses, which never goes in circles.
constexpr int kGreedyTableSteps = 400;

constexpr std::size_t kNoPlace = static_cast<std::size_t>(-1);

/// Below this an entry of a table of doubles is 0: they begin as small whole numbers.
template <class Number>
bool is_positive(const Number& x) {
  if constexpr (std::is_same_v<Number, double>) {
    return x > 1e-9;
  } else {
    return x > 0;
  }
}
template <class Number>
bool is_negative(const Number& x) {
  return is_positive(Number(-x));
}
template <class Number>
double size_of(const Number& x) {
  if constexpr (std::is_same_v<Number, double>) {
    return std::fabs(x);
  } else {
    return std::fabs(to_double(x));
  }
}

/// A row of the programme: the columns with coefficient 1, the coefficient of m, the right side.
struct ProgrammeRow {
  std::vector<std::size_t> columns;
  int margin = 0;
  bool is_equality = false;
  bool is_live = true;  ///< not of a parabolic edge class
};

}  // namespace
}  // namespace tripus::structure::detail

/// What stands in the place of GLPK's object of this name.
struct glp_prob {
  std::vector<tripus::structure::detail::ProgrammeRow> rows;  // edge classes, then vertices
  std::vector<bool> is_zero;                                  // [6 T] corners on parabolic edges
  std::vector<double> right_side;
  std::vector<tripus::BigRational> exact_right_side;
  // The optimum.
  std::vector<double> value;          // [6 T + 1]
  std::vector<double> multiplier;     // of the rows
  std::vector<bool> is_basic_row;     // its auxiliary variable is not at 0 for being nonbasic
  std::vector<bool> is_basic_column;  // [6 T + 1]
};

namespace tripus::structure::detail {
namespace {

template <class Number>
class DenseTable {
 public:
  DenseTable(const glp_prob& programme, const std::vector<Number>& right_side,
             std::chrono::steady_clock::time_point deadline)
      : programme_(programme),
        deadline_(deadline),
        rows_(programme.rows.size()),
        margin_(programme.is_zero.size()),
        width_(margin_ + 1 + rows_),
        table_(rows_ * width_),
        right_(right_side),
        basic_(rows_),
        is_basic_(width_, false) {
    for (std::size_t r = 0; r < rows_; ++r) {
      const ProgrammeRow& row = programme.rows[r];
      if (row.is_live) {
        for (const std::size_t c : row.columns) at(r, c) = 1;
        at(r, margin_) = row.margin;
      }
      at(r, margin_ + 1 + r) = 1;
      basic_[r] = margin_ + 1 + r;
      is_basic_[basic_[r]] = true;
    }
  }

  bool solve() {
    const std::size_t first = leaving(margin_);
    if (first == kNoPlace) return false;
    pivot(first, margin_);
    margin_row_ = first;
    return run(true) && is_feasible() && run(false);
  }

  void write(glp_prob& out) const {
    out.value.assign(margin_ + 1, 0);
    out.is_basic_column.assign(margin_ + 1, false);
    out.is_basic_row.assign(rows_, false);
    for (std::size_t r = 0; r < rows_; ++r) {
      if (basic_[r] <= margin_) {
        out.value[basic_[r]] = as_double(right_[r]);
        out.is_basic_column[basic_[r]] = true;
      } else {
        out.is_basic_row[basic_[r] - margin_ - 1] = true;
      }
    }
    out.multiplier.assign(rows_, 0);
    for (std::size_t r = 0; r < rows_; ++r)
      if (!is_basic_[margin_ + 1 + r])
        out.multiplier[r] = as_double(at(margin_row_, margin_ + 1 + r));
  }

 private:
  static double as_double(const Number& x) {
    if constexpr (std::is_same_v<Number, double>) {
      return x;
    } else {
      return to_double(x);
    }
  }
  Number& at(std::size_t r, std::size_t c) { return table_[r * width_ + c]; }
  const Number& at(std::size_t r, std::size_t c) const { return table_[r * width_ + c]; }

  /// Whether a variable is the auxiliary one of an equality, which has to be 0.
  bool has_to_vanish(std::size_t variable) const {
    return variable > margin_ && programme_.rows[variable - margin_ - 1].is_equality;
  }
  bool may_enter(std::size_t variable) const {
    if (is_basic_[variable] || variable == margin_) return false;
    return variable < margin_ ? !programme_.is_zero[variable] : !has_to_vanish(variable);
  }

  /// What increasing each variable takes off the sum of those that have to vanish, or adds to m.
  std::vector<Number> gains(bool first_phase) const {
    std::vector<Number> gain(width_);
    if (!first_phase) {
      for (std::size_t c = 0; c < width_; ++c) gain[c] = -at(margin_row_, c);
      return gain;
    }
    for (std::size_t r = 0; r < rows_; ++r) {
      if (!has_to_vanish(basic_[r])) continue;
      for (std::size_t c = 0; c < width_; ++c)
        if (at(r, c) != 0) gain[c] += at(r, c);
    }
    return gain;
  }

  std::size_t entering(bool first_phase, bool greedy) const {
    const std::vector<Number> gain = gains(first_phase);
    std::size_t best = kNoPlace;
    for (std::size_t c = 0; c < width_; ++c) {
      if (!may_enter(c) || !is_positive(gain[c])) continue;
      if (best == kNoPlace || gain[c] > gain[best]) best = c;
      if (!greedy) return c;
    }
    return best;
  }

  /// The row whose variable reaches 0 first as variable c grows.
  std::size_t leaving(std::size_t c) const {
    std::size_t best = kNoPlace;
    Number least{};
    for (std::size_t r = 0; r < rows_; ++r) {
      if (basic_[r] == margin_) continue;
      const bool is_stuck = has_to_vanish(basic_[r]) && !is_positive(right_[r]);
      if (is_stuck && (is_positive(at(r, c)) || is_negative(at(r, c)))) return r;
      if (!is_positive(at(r, c))) continue;
      const Number ratio = right_[r] / at(r, c);
      const bool is_less = best == kNoPlace || is_positive(Number(least - ratio));
      const bool is_same = !is_less && !is_positive(Number(ratio - least));
      if (!is_less && !(is_same && basic_[r] < basic_[best])) continue;
      best = r;
      least = ratio;
    }
    return best;
  }

  void pivot(std::size_t row, std::size_t column) {
    const Number inverse = Number(1) / at(row, column);
    std::vector<std::size_t> filled;
    for (std::size_t c = 0; c < width_; ++c) {
      if (at(row, c) == 0) continue;
      at(row, c) *= inverse;
      filled.push_back(c);
    }
    right_[row] *= inverse;
    for (std::size_t r = 0; r < rows_; ++r) {
      if (r == row || at(r, column) == 0) continue;
      const Number factor = at(r, column);
      for (const std::size_t c : filled) at(r, c) -= factor * at(row, c);
      at(r, column) = 0;
      right_[r] -= factor * right_[row];
    }
    is_basic_[basic_[row]] = false;
    is_basic_[column] = true;
    basic_[row] = column;
  }

  bool run(bool first_phase) {
    for (int steps = 0;; ++steps) {
      if (std::chrono::steady_clock::now() >= deadline_) return false;
      const std::size_t c = entering(first_phase, steps < kGreedyTableSteps);
      if (c == kNoPlace) return true;
      const std::size_t r = leaving(c);
      if (r == kNoPlace || steps > 50 * static_cast<int>(width_)) return false;
      pivot(r, c);
    }
  }

  bool is_feasible() const {
    for (std::size_t r = 0; r < rows_; ++r)
      if (has_to_vanish(basic_[r]) && is_positive(right_[r])) return false;
    return true;
  }

  const glp_prob& programme_;
  std::chrono::steady_clock::time_point deadline_;
  std::size_t rows_, margin_, width_;  // columns: corners, m, auxiliary variables
  std::vector<Number> table_, right_;
  std::vector<std::size_t> basic_;
  std::vector<bool> is_basic_;
  std::size_t margin_row_ = 0;
};

}  // namespace

std::size_t most_tetrahedra_decided() { return kMostTetrahedraOfTable; }

AngleProgramme::AngleProgramme(const topology::Triangulation& triangulation,
                               std::span<const topology::ConeAngle> cone_angles)
    : owns_environment_(false),
      old_term_out_(0),
      constraints_(triangulation, cone_angles),
      corner_count_(6 * triangulation.tetrahedron_count()),
      edge_count_(triangulation.edge_count()),
      programme_(new glp_prob) {
  if (triangulation.tetrahedron_count() > kMostTetrahedraOfTable) {
    delete programme_;
    throw Unsupported(
        fmt::format("whether {} tetrahedra have an angle structure is decided here up to {} only: "
                    "ask the program "
                    "(tripus solve)",
                    triangulation.tetrahedron_count(), kMostTetrahedraOfTable));
  }
  add_columns();
  add_rows(triangulation);
}

AngleProgramme::~AngleProgramme() { delete programme_; }

void AngleProgramme::add_columns() { programme_->is_zero.assign(corner_count_, false); }

void AngleProgramme::add_rows(const topology::Triangulation& triangulation) {
  for (std::size_t e = 0; e < edge_count_; ++e) {
    ProgrammeRow row;
    row.is_live = !constraints_.parabolic[e];
    row.is_equality = row.is_live;
    for (const auto corner : triangulation.corners(e)) {
      const std::size_t c = 6 * corner.tetrahedron() + static_cast<std::size_t>(corner.edge());
      row.columns.push_back(c);
      if (!row.is_live) programme_->is_zero[c] = true;
      ++row.margin;
    }
    programme_->rows.push_back(std::move(row));
    programme_->right_side.push_back(constraints_.edge_sum[e]);
    programme_->exact_right_side.push_back(constraints_.exact_sum.empty()
                                               ? Rational(constraints_.edge_sum[e])
                                               : constraints_.exact_sum[e]);
  }
  for (std::size_t v = 0; v < 4 * triangulation.tetrahedron_count(); ++v) {
    ProgrammeRow row;
    row.is_equality = constraints_.ideal[v];
    for (const int edge : topology::kEdgeNumber[v % 4]) {
      if (edge < 0) continue;
      if (!constraints_.parabolic[triangulation.edge_class(v / 4, edge)])
        row.columns.push_back(6 * (v / 4) + static_cast<std::size_t>(edge));
    }
    // Three angles and, where the sum may be less than pi, the gap itself.
    row.margin = constraints_.corners[v] + (constraints_.ideal[v] ? 0 : 1);
    programme_->rows.push_back(std::move(row));
    programme_->right_side.push_back(1);
    programme_->exact_right_side.emplace_back(1);
  }
}

void AngleProgramme::limit_time(double seconds) {
  constexpr double kLongestLimit = 1e8;  // three years
  if (!(seconds < kLongestLimit)) return;
  deadline_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                 std::chrono::duration<double>(std::max(seconds, 0.0)));
}

bool AngleProgramme::solve() {
  DenseTable<double> table(*programme_, programme_->right_side, deadline_);
  if (!table.solve()) return false;
  table.write(*programme_);
  return true;
}

bool AngleProgramme::solve_exactly() {
  DenseTable<Rational> table(*programme_, programme_->exact_right_side, deadline_);
  if (!table.solve()) return false;
  table.write(*programme_);
  return true;
}

double AngleProgramme::margin() const { return programme_->value[corner_count_]; }

std::vector<double> AngleProgramme::angles() const {
  std::vector<double> found(corner_count_);
  for (std::size_t c = 0; c < corner_count_; ++c)
    if (!programme_->is_zero[c]) found[c] = programme_->value[c] + margin();
  return found;
}

std::vector<double> AngleProgramme::vertex_multipliers() const {
  return {programme_->multiplier.begin() + static_cast<std::ptrdiff_t>(edge_count_),
          programme_->multiplier.end()};
}

AngleProgramme::Basis AngleProgramme::basis() const {
  Basis found;
  for (std::size_t r = 0; r < programme_->rows.size(); ++r)
    if (!programme_->is_basic_row[r]) found.rows.push_back(r);
  for (std::size_t c = 0; c <= corner_count_; ++c)
    if (programme_->is_basic_column[c]) found.columns.push_back(c);
  return found;
}

}  // namespace tripus::structure::detail
