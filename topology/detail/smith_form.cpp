#include "topology/detail/smith_form.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <queue>
#include <tuple>
#include <utility>

#include "base/stop.hpp"

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
    digits_ -= digits_of(row);
    std::erase_if(row, [&](const auto& entry) {
      const bool gone = count_[entry.column] == 1 && entry.column != kept;
      if (gone) count_[entry.column] = 0;
      return gone;
    });
    std::ranges::lower_bound(row, kept, {}, &Entry<Integer>::column)->value = divisor;
    digits_ += digits_of(row);
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
  std::vector<BigInteger> factors = diagonal_modulo(left, column_count, multiple, stop);
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
