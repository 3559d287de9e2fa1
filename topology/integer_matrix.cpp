#include "topology/detail/integer_matrix.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <queue>
#include <tuple>
#include <utility>

#include "base/stopped.hpp"

// Three stages. First, pivots +-1 are eliminated on sparse rows of 64-bit integers, with every
// product checked: a pivot whose elimination would overflow is put aside. The few rows left are
// reduced to independent columns and go through the same on big integers. Last, what has no unit
// entry left is small, and goes through the textbook dense algorithm.

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
  UnitEliminator(std::vector<SparseRow<Integer>> rows, std::size_t column_count,
                 const std::atomic<bool>* stop_requested)
      : stop_requested_(stop_requested),
        rows_(std::move(rows)),
        rows_of_(column_count),
        count_(column_count, 0) {
    for (std::uint32_t r = 0; r < rows_.size(); ++r) {
      for (const auto& entry : rows_[r]) add_to_column(entry.column, r);
    }
    for (std::uint32_t r = 0; r < rows_.size(); ++r) queue_row(r);
  }

  /// Eliminates unit pivots until there is none, and returns their number.
  std::size_t run() {
    std::size_t pivots = 0;
    for (std::uint32_t column = 0; column < count_.size(); ++column)
      if (count_[column] == 1) single_.push_back(column);
    while (true) {
      throw_if_stopped(stop_requested_);
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
    using boost::multiprecision::gcd;
    using std::gcd;
    SparseRow<Integer>& row = rows_[r];
    Integer divisor = 0;
    std::uint32_t kept = 0;
    for (const auto& entry : row)
      if (count_[entry.column] == 1) {
        divisor = gcd(divisor, entry.value);
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

  /// False on overflow: then rows were changed by multiples of row r only, which is harmless.
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

  // Fill when queued, tie breaker, row.
  using Waiting = std::tuple<std::size_t, std::uint32_t, std::uint32_t>;
  const std::atomic<bool>* stop_requested_;
  std::vector<SparseRow<Integer>> rows_;
  std::vector<std::vector<std::uint32_t>> rows_of_;  // per column, possibly stale
  std::vector<std::uint32_t> count_;                 // per column, exact
  std::vector<std::uint32_t> single_;                // columns that may have one row only
  std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> waiting_;
};

using DenseMatrix = std::vector<std::vector<BigInteger>>;

DenseMatrix compressed(const std::vector<SparseRow<BigInteger>>& rows) {
  std::vector<std::uint32_t> columns;
  for (const auto& row : rows)
    for (const auto& entry : row) columns.push_back(entry.column);
  std::ranges::sort(columns);
  columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
  DenseMatrix dense(rows.size(), std::vector<BigInteger>(columns.size()));
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (const auto& entry : rows[r]) {
      const auto place = std::ranges::lower_bound(columns, entry.column) - columns.begin();
      dense[r][static_cast<std::size_t>(place)] = entry.value;
    }
  return dense;
}

/// Diagonalises the block from (k, k) on, one entry at a time.
class DenseReducer {
 public:
  DenseReducer(DenseMatrix matrix, const std::atomic<bool>* stop_requested)
      : matrix_(std::move(matrix)), stop_requested_(stop_requested) {}

  std::vector<BigInteger> diagonal() {
    std::vector<BigInteger> result;
    for (; move_least_to_corner(); ++corner_) {
      while (!clear_cross() || !divides_the_rest()) (void)move_least_to_corner();
      result.emplace_back(abs(matrix_[corner_][corner_]));
    }
    return result;
  }

 private:
  std::size_t height() const { return matrix_.size(); }
  std::size_t width() const { return matrix_.empty() ? 0 : matrix_[0].size(); }

  /// False if the block is zero.
  bool move_least_to_corner() {
    std::size_t row = height();
    std::size_t column = 0;
    for (std::size_t i = corner_; i < height(); ++i)
      for (std::size_t j = corner_; j < width(); ++j)
        if (matrix_[i][j] != 0 &&
            (row == height() || abs(matrix_[i][j]) < abs(matrix_[row][column]))) {
          row = i;
          column = j;
        }
    if (row == height()) return false;
    std::swap(matrix_[row], matrix_[corner_]);
    if (column != corner_)
      for (auto& line : matrix_) std::swap(line[column], line[corner_]);
    return true;
  }

  /// Reduces the corner's row and column modulo the corner; true if both vanish.
  bool clear_cross() {
    bool clear = true;
    const auto& top = matrix_[corner_];
    for (std::size_t i = corner_ + 1; i < height(); ++i) {
      throw_if_stopped(stop_requested_);
      const BigInteger factor = matrix_[i][corner_] / top[corner_];
      if (factor != 0)
        for (std::size_t j = corner_; j < width(); ++j) matrix_[i][j] -= factor * top[j];
      clear = clear && matrix_[i][corner_] == 0;
    }
    for (std::size_t j = corner_ + 1; j < width(); ++j) {
      throw_if_stopped(stop_requested_);
      const BigInteger factor = top[j] / top[corner_];
      if (factor != 0)
        for (std::size_t i = corner_; i < height(); ++i)
          matrix_[i][j] -= factor * matrix_[i][corner_];
      clear = clear && top[j] == 0;
    }
    return clear;
  }

  /// Adds a row with an entry that the corner does not divide to the corner's row, if there is
  /// one, so that the next round finds a smaller corner.
  bool divides_the_rest() {
    for (std::size_t i = corner_ + 1; i < height(); ++i)
      for (std::size_t j = corner_ + 1; j < width(); ++j)
        if (matrix_[i][j] % matrix_[corner_][corner_] != 0) {
          for (std::size_t k = corner_; k < width(); ++k) matrix_[corner_][k] += matrix_[i][k];
          // The remainder itself, so that the least entry is smaller than before.
          const BigInteger factor = matrix_[corner_][j] / matrix_[corner_][corner_];
          for (std::size_t k = corner_; k < height(); ++k)
            matrix_[k][j] -= factor * matrix_[k][corner_];
          return false;
        }
    return true;
  }

  DenseMatrix matrix_;
  const std::atomic<bool>* stop_requested_;
  std::size_t corner_ = 0;
};

/// The columns of a few long rows, brought to echelon form one by one: k rows have at most k
/// independent columns. Returns them as rows; the Smith form does not mind the transposition.
std::vector<SparseRow<BigInteger>> independent_columns(
    const std::vector<SparseRow<std::int64_t>>& rows, std::size_t column_count,
    const std::atomic<bool>* stop_requested) {
  std::vector<SparseRow<BigInteger>> columns(column_count);
  for (std::uint32_t r = 0; r < rows.size(); ++r)
    for (const auto& entry : rows[r]) columns[entry.column].push_back({r, entry.value});
  std::vector<SparseRow<BigInteger>> basis(rows.size());  // by first place
  for (SparseRow<BigInteger>& vector : columns)
    while (!vector.empty()) {
      throw_if_stopped(stop_requested);
      SparseRow<BigInteger>& rival = basis[vector.front().column];
      if (rival.empty()) {
        rival = std::move(vector);
        break;
      }
      // One step of Euclid's algorithm on the leading entries.
      const BigInteger factor = vector.front().value / rival.front().value;
      vector = *difference(vector, factor, rival);
      if (!vector.empty() && vector.front().column == rival.front().column)
        std::swap(vector, rival);
    }
  std::erase_if(basis, [](const auto& vector) { return vector.empty(); });
  return basis;
}

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

SmithForm smith_form(std::vector<SparseRow<std::int64_t>> rows, std::size_t column_count,
                     const std::atomic<bool>* stop_requested) {
  SmithForm form;
  UnitEliminator<std::int64_t> small(std::move(rows), column_count, stop_requested);
  form.rank = small.run();
  const auto left = small.take_rows();
  UnitEliminator<BigInteger> big(independent_columns(left, column_count, stop_requested),
                                 left.size(), stop_requested);
  form.rank += big.run();
  for (BigInteger& factor : DenseReducer(compressed(big.take_rows()), stop_requested).diagonal()) {
    ++form.rank;
    if (factor != 1) form.factors.push_back(std::move(factor));
  }
  return form;
}

}  // namespace tripus::topology::detail
