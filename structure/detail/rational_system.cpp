#include "structure/detail/rational_system.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <queue>

// Bases of the angle programme are nearly triangular: most pivots are the only entry of their
// column or row, and cost nothing. The rest is eliminated cheapest first, by Markowitz's count.

namespace tripus::structure::detail {
namespace {

struct Entry {
  std::uint32_t unknown;
  Rational value;  // not 0
};
using Row = std::vector<Entry>;  // unknowns ascending

class Elimination {
 public:
  explicit Elimination(const RationalSystem& system)
      : rows_(system.rows.size()),
        right_side_(system.right_side),
        rows_with_(system.rows.size()),
        count_(system.rows.size(), 0) {
    for (std::uint32_t r = 0; r < rows_.size(); ++r) {
      for (const auto& [unknown, coefficient] : system.rows[r]) {
        rows_[r].push_back({static_cast<std::uint32_t>(unknown), Rational(coefficient)});
        rows_with_[unknown].push_back(r);
        ++count_[unknown];
      }
      std::ranges::sort(rows_[r], {}, &Entry::unknown);
      queue(r);
    }
    for (std::uint32_t unknown = 0; unknown < count_.size(); ++unknown)
      if (count_[unknown] == 1) lonely_.push_back(unknown);
    active_.assign(rows_.size(), true);
  }

  std::optional<std::vector<Rational>> run() {
    while (pivots_.size() < rows_.size())
      if (!take_lonely_unknown() && !take_cheapest()) return std::nullopt;
    return back_substituted();
  }

 private:
  using Queued = std::pair<std::size_t, std::uint32_t>;  // cost, row

  const Entry* find(std::uint32_t r, std::uint32_t unknown) const {
    const auto place = std::ranges::lower_bound(rows_[r], unknown, {}, &Entry::unknown);
    return place != rows_[r].end() && place->unknown == unknown ? &*place : nullptr;
  }
  const Entry* rarest(std::uint32_t r) const {
    if (rows_[r].empty()) return nullptr;
    return &*std::ranges::min_element(rows_[r], {},
                                      [&](const Entry& x) { return count_[x.unknown]; });
  }
  std::size_t cost(std::uint32_t r) const {
    const Entry* entry = rarest(r);
    return entry == nullptr ? 0 : (rows_[r].size() - 1) * (count_[entry->unknown] - 1);
  }
  void queue(std::uint32_t r) { waiting_.emplace(cost(r), r); }

  /// Retires row r, which determines `unknown` once all later pivots are known.
  void record(std::uint32_t r, std::uint32_t unknown) {
    pivots_.emplace_back(r, unknown);
    active_[r] = false;
    for (const Entry& entry : rows_[r]) leave(entry.unknown);
  }
  void leave(std::uint32_t unknown) {
    if (--count_[unknown] == 1) lonely_.push_back(unknown);
  }

  bool take_lonely_unknown() {
    while (!lonely_.empty()) {
      const std::uint32_t unknown = lonely_.back();
      lonely_.pop_back();
      if (count_[unknown] != 1) continue;
      for (const std::uint32_t r : rows_with_[unknown]) {
        if (!active_[r] || find(r, unknown) == nullptr) continue;
        record(r, unknown);
        return true;
      }
    }
    return false;
  }

  /// False where an active row is empty: the matrix is singular.
  bool take_cheapest() {
    while (!waiting_.empty()) {
      const auto [queued_cost, r] = waiting_.top();
      waiting_.pop();
      if (!active_[r]) continue;
      if (rows_[r].empty()) return false;
      if (cost(r) > queued_cost) {  // it became dearer since it was queued
        queue(r);
        continue;
      }
      eliminate(r, rarest(r)->unknown);
      return true;
    }
    return false;
  }

  void eliminate(std::uint32_t r, std::uint32_t unknown) {
    const Rational pivot = find(r, unknown)->value;
    const std::vector<std::uint32_t> others = rows_with_[unknown];
    for (const std::uint32_t other : others) {
      if (other == r || !active_[other]) continue;
      const Entry* entry = find(other, unknown);
      if (entry == nullptr) continue;
      const Rational factor = entry->value / pivot;
      subtract(other, factor, r);
      right_side_[other] -= factor * right_side_[r];
      queue(other);
    }
    record(r, unknown);
  }

  /// Row `other` -= factor * row r; keeps the columns' lists up to date.
  void subtract(std::uint32_t other, const Rational& factor, std::uint32_t r) {
    Row merged;
    Row& old = rows_[other];
    merged.reserve(old.size() + rows_[r].size());
    auto x = old.begin();
    for (const Entry& y : rows_[r]) {
      while (x != old.end() && x->unknown < y.unknown) merged.push_back(std::move(*x++));
      if (x != old.end() && x->unknown == y.unknown) {
        x->value -= factor * y.value;
        if (x->value != 0) {
          merged.push_back(std::move(*x));
        } else {
          leave(y.unknown);
        }
        ++x;
      } else {
        merged.push_back({y.unknown, -factor * y.value});
        rows_with_[y.unknown].push_back(other);
        ++count_[y.unknown];
      }
    }
    std::move(x, old.end(), std::back_inserter(merged));
    old = std::move(merged);
  }

  std::vector<Rational> back_substituted() const {
    std::vector<Rational> solution(rows_.size());
    // Clang 14 does not compile std::views::reverse. NOLINTNEXTLINE(modernize-loop-convert)
    for (auto pivot = pivots_.rbegin(); pivot != pivots_.rend(); ++pivot) {
      const auto [r, unknown] = *pivot;
      Rational rest = right_side_[r];
      const Rational* divisor = nullptr;
      for (const Entry& entry : rows_[r]) {
        if (entry.unknown == unknown) {
          divisor = &entry.value;
        } else if (solution[entry.unknown] != 0) {
          rest -= entry.value * solution[entry.unknown];
        }
      }
      solution[unknown] = rest / *divisor;
    }
    return solution;
  }

  std::vector<Row> rows_;
  std::vector<Rational> right_side_;
  std::vector<std::vector<std::uint32_t>> rows_with_;  // of each unknown; may name rows it has left
  std::vector<std::size_t> count_;                     // active rows with the unknown
  std::vector<bool> active_;
  std::vector<std::uint32_t> lonely_;
  std::priority_queue<Queued, std::vector<Queued>, std::greater<>> waiting_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pivots_;  // row, unknown
};

}  // namespace

std::optional<std::vector<Rational>> solve(const RationalSystem& system) {
  return Elimination(system).run();
}

}  // namespace tripus::structure::detail
