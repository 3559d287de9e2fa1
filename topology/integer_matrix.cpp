#include "topology/detail/integer_matrix.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <queue>
#include <tuple>
#include <utility>

#include "base/stop.hpp"
#include "topology/detail/minors.hpp"

// First, pivots +-1 are eliminated on sparse rows of 64-bit integers, with every product checked: a
// pivot whose elimination would overflow is put aside. Then the same with long integers, as long as
// the digits of all entries together stay what they were: so the strips of rows that large covers
// leave merge in pairs. Minors of the few rows left give their rank and a multiple of all invariant
// factors, and modulo that they go through the textbook algorithm.

namespace tripus::topology::detail {
namespace {

/// x -= factor * y; false, with x unchanged, if that overflows.
bool subtract_product(std::int64_t& x, std::int64_t factor, std::int64_t y) {
  std::int64_t product = 0;
  std::int64_t difference = 0;
  if (__builtin_mul_overflow(factor, y, &product) ||
      __builtin_sub_overflow(x, product, &difference) || difference == INT64_MIN)
    return false;
  x = difference;
  return true;
}

bool subtract_product(BigInteger& x, const BigInteger& factor, const BigInteger& y) {
  x -= factor * y;
  return true;
}

template <class Integer>
bool is_unit(const Integer& x) {
  return x == 1 || x == -1;
}

std::int64_t divisor_of(std::int64_t x, std::int64_t y) { return std::gcd(x, y); }
BigInteger divisor_of(const BigInteger& x, const BigInteger& y) { return gcd(x, y); }

/// Digits, in bits, of all entries.
std::size_t digits_of(const SparseRow<BigInteger>& row) {
  std::size_t sum = 0;
  for (const auto& entry : row) sum += binary_digits(entry.value);
  return sum;
}
std::size_t digits_of(const SparseRow<std::int64_t>&) { return 0; }  // bounded by themselves

/// old - factor * row, or nothing on overflow.
template <class Integer>
std::optional<SparseRow<Integer>> difference(const SparseRow<Integer>& old, const Integer& factor,
                                             const SparseRow<Integer>& row) {
  SparseRow<Integer> merged;
  merged.reserve(old.size() + row.size());
  auto x = old.begin();
  for (const auto& y : row) {
    while (x != old.end() && x->column < y.column) merged.push_back(*x++);
    Entry<Integer> sum{y.column, 0};
    if (x != old.end() && x->column == y.column) sum.value = (x++)->value;
    if (!subtract_product(sum.value, factor, y.value)) return std::nullopt;
    if (sum.value != 0) merged.push_back(std::move(sum));
  }
  merged.insert(merged.end(), x, old.end());
  return merged;
}

template <class Integer>
class UnitEliminator {
 public:
  UnitEliminator(std::vector<SparseRow<Integer>> rows, std::size_t column_count, const Stop& stop)
      : stop_(stop), rows_(std::move(rows)), rows_of_(column_count), count_(column_count, 0) {
    for (std::uint32_t r = 0; r < rows_.size(); ++r) {
      for (const auto& entry : rows_[r]) add_to_column(entry.column, r);
    }
    for (std::uint32_t r = 0; r < rows_.size(); ++r) queue_row(r);
    for (const auto& row : rows_) digits_ += digits_of(row);
    // Two rows and columns that go one after the other make more on the way.
    most_digits_ = 2 * digits_;
  }

  /// Eliminates unit pivots until there is none, and returns their number.
  std::size_t run() {
    std::size_t pivots = 0;
    for (std::uint32_t column = 0; column < count_.size(); ++column)
      if (count_[column] == 1) single_.push_back(column);
    while (true) {
      throw_if_stopped(stop_);
      pivots += remove_free_rows();
      if (waiting_.empty()) break;
      const auto [queued_cost, tie, r] = waiting_.top();
      waiting_.pop();
      const auto* pivot = cheapest_unit(rows_[r]);
      if (!pivot) continue;
      const std::size_t cost = fill(r, *pivot);
      if (cost > queued_cost) {  // it became dearer since it was queued
        waiting_.emplace(cost, shuffled(r), r);
      } else if (eliminate(r, pivot->column)) {
        ++pivots;
      }
    }
    return pivots;
  }

  std::vector<SparseRow<Integer>> take_rows() {
    std::erase_if(rows_, [](const auto& row) { return row.empty(); });
    return std::move(rows_);
  }

 private:
  void add_to_column(std::uint32_t column, std::uint32_t row) {
    rows_of_[column].push_back(row);
    ++count_[column];
  }

  /// Columns that meet one row only: operations among them replace their entries by their greatest
  /// common divisor and zeros. If that is a unit it is a pivot without any fill, however long the
  /// row; removing the row leaves others alone in turn. In covers this cascade does nearly all.
  std::size_t remove_free_rows() {
    std::size_t removed = 0;
    while (!single_.empty()) {
      const std::uint32_t column = single_.back();
      single_.pop_back();
      if (count_[column] != 1) continue;
      const auto r = std::ranges::find_if(
          rows_of_[column], [&](std::uint32_t row) { return find(rows_[row], column); });
      if (!merge_private_columns(*r)) continue;
      drop_row(*r);
      ++removed;
    }
    return removed;
  }

  /// True if the divisor is a unit.
  bool merge_private_columns(std::uint32_t r) {
    SparseRow<Integer>& row = rows_[r];
    Integer divisor = 0;
    std::uint32_t kept = 0;
    for (const auto& entry : row)
      if (count_[entry.column] == 1) {
        divisor = divisor_of(divisor, entry.value);
        kept = entry.column;
      }
    const std::size_t old_size = row.size();
    std::erase_if(row, [&](const auto& entry) {
      const bool gone = count_[entry.column] == 1 && entry.column != kept;
      if (gone) count_[entry.column] = 0;
      return gone;
    });
    std::ranges::lower_bound(row, kept, {}, &Entry<Integer>::column)->value = divisor;
    if (is_unit(divisor)) return true;
    if (row.size() != old_size) queue_row(r);
    return false;
  }

  void leave_column(std::uint32_t column) {
    if (--count_[column] == 1) single_.push_back(column);
  }

  void drop_row(std::uint32_t r) {
    digits_ -= digits_of(rows_[r]);
    for (const auto& entry : rows_[r]) leave_column(entry.column);
    SparseRow<Integer>().swap(rows_[r]);
  }

  /// The unit entry in the emptiest column, which makes the least fill.
  const Entry<Integer>* cheapest_unit(const SparseRow<Integer>& row) const {
    const Entry<Integer>* best = nullptr;
    for (const auto& entry : row)
      if (is_unit(entry.value) && (!best || count_[entry.column] < count_[best->column]))
        best = &entry;
    return best;
  }

  /// Markowitz's bound on the entries that the pivot makes.
  std::size_t fill(std::uint32_t r, const Entry<Integer>& pivot) const {
    return (rows_[r].size() - 1) * (count_[pivot.column] - 1);
  }
  void queue_row(std::uint32_t r) {
    if (const auto* pivot = cheapest_unit(rows_[r]))
      waiting_.emplace(fill(r, *pivot), shuffled(r), r);
  }

  static const Entry<Integer>* find(const SparseRow<Integer>& row, std::uint32_t column) {
    const auto place = std::ranges::lower_bound(row, column, {}, &Entry<Integer>::column);
    return place != row.end() && place->column == column ? &*place : nullptr;
  }

  /// False on overflow, or where there would be too many digits: then rows were changed by
  /// multiples of row r only, which is harmless.
  bool eliminate(std::uint32_t r, std::uint32_t column) {
    const SparseRow<Integer> pivot_row = rows_[r];
    const Integer pivot = find(pivot_row, column)->value;
    const auto members = rows_of_[column];  // may hold rows that have lost the column
    for (const std::uint32_t other : members) {
      const auto* entry = other == r ? nullptr : find(rows_[other], column);
      if (entry && !subtract(other, Integer(entry->value * pivot), pivot_row)) return false;
    }
    drop_row(r);
    std::vector<std::uint32_t>().swap(rows_of_[column]);
    return true;
  }

  bool subtract(std::uint32_t target, const Integer& factor, const SparseRow<Integer>& row) {
    auto merged = difference(rows_[target], factor, row);
    if (!merged) return false;
    const std::size_t digits = digits_ - digits_of(rows_[target]) + digits_of(*merged);
    if (digits > most_digits_) return false;
    digits_ = digits;
    replace(target, std::move(*merged));
    return true;
  }

  void replace(std::uint32_t target, SparseRow<Integer> merged) {
    const SparseRow<Integer>& old = rows_[target];
    for (const auto& entry : old)
      if (!find(merged, entry.column)) leave_column(entry.column);
    for (const auto& entry : merged)
      if (!find(old, entry.column)) add_to_column(entry.column, target);
    rows_[target] = std::move(merged);
    queue_row(target);
  }

  /// Ties are broken in a scattered order: one after another along a strip, rows would pile up into
  /// a single long one, where scattered ones merge in pairs.
  static std::uint32_t shuffled(std::uint32_t r) { return r * 2654435761u; }

  std::size_t digits_ = 0, most_digits_ = 0;  // of all rows: now, and at most
  // Fill when queued, tie breaker, row.
  using Waiting = std::tuple<std::size_t, std::uint32_t, std::uint32_t>;
  Stop stop_;
  std::vector<SparseRow<Integer>> rows_;
  std::vector<std::vector<std::uint32_t>> rows_of_;  // per column, possibly stale
  std::vector<std::uint32_t> count_;                 // per column, exact
  std::vector<std::uint32_t> single_;                // columns that may have one row only
  std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> waiting_;
};

using Vector = std::vector<BigInteger>;

/// x - factor * y modulo m, from the place `first` on; in [0, m).
void subtract(Vector& x, const BigInteger& factor, const Vector& y, std::size_t first,
              const BigInteger& m) {
  for (std::size_t i = first; i < x.size(); ++i) {
    if (y[i] == 0) continue;
    x[i] = (x[i] - factor * y[i]) % m;
    if (x[i] < 0) x[i] += m;
  }
}

/// At most k vectors that generate, modulo m, what the columns of k rows generate. Brought to
/// echelon form one by one, as there may be many more columns than rows.
template <class Integer>
std::vector<Vector> generating_columns(const std::vector<SparseRow<Integer>>& rows,
                                       std::size_t column_count, const BigInteger& m,
                                       const Stop& stop) {
  std::vector<SparseRow<Integer>> columns(column_count);
  for (std::uint32_t r = 0; r < rows.size(); ++r)
    for (const auto& entry : rows[r]) columns[entry.column].push_back({r, entry.value});
  std::vector<Vector> basis(rows.size());  // by first place
  for (const SparseRow<Integer>& column : columns) {
    throw_if_stopped(stop);
    Vector vector(rows.size());
    for (const auto& entry : column) vector[entry.column] = ((entry.value % m) + m) % m;
    for (std::size_t first = 0; first < vector.size();) {
      if (vector[first] == 0) {
        ++first;
      } else if (basis[first].empty()) {
        basis[first] = std::move(vector);
        break;
      } else {
        // One step of Euclid's algorithm on the leading entries.
        const BigInteger factor = vector[first] / basis[first][first];
        subtract(vector, factor, basis[first], first, m);
        if (vector[first] != 0) std::swap(vector, basis[first]);
      }
    }
  }
  std::erase_if(basis, [](const Vector& vector) { return vector.empty(); });
  return basis;
}

/// Diagonalises a matrix modulo m, from the block at (corner, corner) on, one entry at a time.
class ModularReducer {
 public:
  ModularReducer(std::vector<Vector> matrix, BigInteger modulus, const Stop& stop)
      : matrix_(std::move(matrix)), m_(std::move(modulus)), stop_(stop) {}

  /// The entries that are not 0 modulo m, divisors of m, each dividing the next.
  Vector diagonal() {
    Vector result;
    for (; move_least_to_corner(); ++corner_) {
      while (!clear_cross() || !divides_the_rest()) (void)move_least_to_corner();
      result.push_back(matrix_[corner_][corner_]);
    }
    return result;
  }

 private:
  std::size_t height() const { return matrix_.size(); }
  std::size_t width() const { return matrix_.empty() ? 0 : matrix_[0].size(); }

  /// Least: with the least common divisor with m, to which it is scaled. False if all are 0.
  bool move_least_to_corner() {
    BigInteger least = 0;
    std::size_t row = 0, column = 0;
    for (std::size_t i = corner_; i < height() && least != 1; ++i)
      for (std::size_t j = corner_; j < width() && least != 1; ++j) {
        if (matrix_[i][j] == 0) continue;
        BigInteger divisor = gcd(matrix_[i][j], m_);
        if (least != 0 && divisor >= least) continue;
        least = std::move(divisor);
        row = i;
        column = j;
      }
    if (least == 0) return false;
    std::swap(matrix_[row], matrix_[corner_]);
    if (column != corner_)
      for (Vector& line : matrix_) std::swap(line[column], line[corner_]);
    scale_corner_to(least);
    return true;
  }

  /// Multiplies the corner's row by a unit modulo m, so that the corner is its divisor with m.
  void scale_corner_to(const BigInteger& divisor) {
    Vector& top = matrix_[corner_];
    const BigInteger part = m_ / divisor;
    BigInteger unit = inverse(top[corner_] / divisor, part);
    while (gcd(unit, m_) != 1) unit += part;
    if (unit != 1)
      for (std::size_t j = corner_; j < width(); ++j) top[j] = top[j] * unit % m_;
  }

  /// 1/x modulo m, for x and m without a common divisor; 1 if m = 1.
  static BigInteger inverse(const BigInteger& x, const BigInteger& m) {
    BigInteger a = m, b = x % m, of_a = 0, of_b = 1;
    while (b > 1) {
      const BigInteger quotient = a / b;
      a -= quotient * b;
      of_a -= quotient * of_b;
      swap(a, b);
      swap(of_a, of_b);
    }
    if (m == 1) return 1;
    of_b %= m;
    return of_b < 0 ? of_b + m : of_b;
  }

  /// Reduces the corner's row and column modulo the corner; true if both vanish.
  bool clear_cross() {
    bool clear = true;
    const Vector& top = matrix_[corner_];
    const BigInteger corner = top[corner_];
    for (std::size_t i = corner_ + 1; i < height(); ++i) {
      throw_if_stopped(stop_);
      const BigInteger factor = matrix_[i][corner_] / corner;
      if (factor != 0) subtract(matrix_[i], factor, top, corner_, m_);
      clear = clear && matrix_[i][corner_] == 0;
    }
    for (std::size_t j = corner_ + 1; j < width(); ++j) {
      const BigInteger factor = top[j] / corner;
      if (factor == 0) continue;
      for (std::size_t i = corner_; i < height(); ++i) {
        BigInteger& x = matrix_[i][j];
        x = (x - factor * matrix_[i][corner_]) % m_;
        if (x < 0) x += m_;
      }
    }
    for (std::size_t j = corner_ + 1; j < width(); ++j) clear = clear && top[j] == 0;
    return clear;
  }

  /// Adds a row with an entry that the corner does not divide to the corner's row, if there is
  /// one, so that the next round finds a smaller corner.
  bool divides_the_rest() {
    Vector& top = matrix_[corner_];
    for (std::size_t i = corner_ + 1; i < height(); ++i)
      for (std::size_t j = corner_ + 1; j < width(); ++j)
        if (matrix_[i][j] % top[corner_] != 0) {
          subtract(top, BigInteger(-1), matrix_[i], corner_, m_);
          return false;
        }
    return true;
  }

  std::vector<Vector> matrix_;
  BigInteger m_;
  Stop stop_;
  std::size_t corner_ = 0;
};

}  // namespace

SparseRow<std::int64_t> collected(SparseRow<std::int64_t> summands) {
  std::ranges::sort(summands, {}, &Entry<std::int64_t>::column);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < summands.size();) {
    auto sum = summands[i++];
    for (; i < summands.size() && summands[i].column == sum.column; ++i)
      sum.value += summands[i].value;
    if (sum.value != 0) summands[kept++] = sum;
  }
  summands.resize(kept);
  return summands;
}

namespace {

/// Of what has no pivots left, added to what is known.
template <class Integer>
SmithForm completed(SmithForm form, const std::vector<SparseRow<Integer>>& left,
                    std::size_t column_count, const Stop& stop) {
  const auto [rank, multiple] = minors(left, column_count, stop);
  form.rank += rank;
  if (multiple == 1) return form;
  ModularReducer reducer(generating_columns(left, column_count, multiple, stop), multiple, stop);
  Vector factors = reducer.diagonal();
  factors.resize(rank, multiple);  // a factor that is the multiple itself is 0 modulo it
  for (BigInteger& factor : factors)
    if (factor != 1) form.factors.push_back(std::move(factor));
  return form;
}

std::vector<SparseRow<BigInteger>> as_long_integers(
    const std::vector<SparseRow<std::int64_t>>& rows) {
  std::vector<SparseRow<BigInteger>> result(rows.size());
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (const auto& entry : rows[r]) result[r].push_back({entry.column, entry.value});
  return result;
}

bool has_unit(const std::vector<SparseRow<std::int64_t>>& rows) {
  return std::ranges::any_of(rows, [](const auto& row) {
    return std::ranges::any_of(row, [](const auto& entry) { return is_unit(entry.value); });
  });
}

}  // namespace

SmithForm smith_form(std::vector<SparseRow<std::int64_t>> rows, std::size_t column_count,
                     const Stop& stop) {
  SmithForm form;
  UnitEliminator eliminator(std::move(rows), column_count, stop);
  form.rank = eliminator.run();
  const auto left = eliminator.take_rows();
  if (!has_unit(left)) return completed(std::move(form), left, column_count, stop);
  UnitEliminator longer(as_long_integers(left), column_count, stop);
  form.rank += longer.run();
  return completed(std::move(form), longer.take_rows(), column_count, stop);
}

}  // namespace tripus::topology::detail
