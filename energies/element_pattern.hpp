#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "solver/problem.hpp"

namespace tripus::energies {

/// Marks a local variable that an element does not have.
inline constexpr std::uint32_t kNoVariable = 0xffffffffu;

/// Where the local Hessians of the elements (tetrahedra) of a functional go in the assembled one:
/// Hess = sum over elements of A^T M A, with A the 0/1 matrix that picks the element's variables.
/// Built once, in O(elements).
class ElementPattern {
 public:
  /// variables: [elements x width], entries below `variable_count` or kNoVariable.
  ElementPattern(std::size_t variable_count, std::size_t width,
                 std::span<const std::uint32_t> variables);

  const solver::SparsityPattern& pattern() const { return pattern_; }

  /// Slot in the values array for the local pair q = (i, j), i <= j, of an element, counted row by
  /// row through the upper triangle; -1 where a variable is missing.
  std::int64_t slot(std::size_t element, std::size_t q) const {
    return slots_[element * pairs_ + q];
  }
  /// Local pairs of an element: width (width + 1) / 2.
  std::size_t pair_count() const { return pairs_; }

 private:
  std::size_t pairs_;
  solver::SparsityPattern pattern_;
  std::vector<std::int64_t> slots_;  // [elements x pairs]
};

/// An ElementPattern that is built when it is first asked for, once, whatever the threads. Copies
/// build their own.
class LazyElementPattern {
 public:
  LazyElementPattern() = default;
  LazyElementPattern(const LazyElementPattern&) {}
  LazyElementPattern& operator=(const LazyElementPattern&) = delete;

  template <class Make>
  const ElementPattern& get(Make&& make) const {
    std::call_once(once_, [&] { pattern_.emplace(make()); });
    return *pattern_;
  }

 private:
  mutable std::once_flag once_;
  mutable std::optional<ElementPattern> pattern_;
};

}  // namespace tripus::energies
