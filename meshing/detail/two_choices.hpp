#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace tripus::meshing::detail {

/// Questions with two answers each, and pairs of answers that exclude each other: whether there are
/// answers to all questions of which no two do. Exact, in linear time (2-satisfiability).
class TwoChoices {
 public:
  /// An answer: 2 q + a for answer a (0 or 1) to question q.
  using Answer = std::uint32_t;

  explicit TwoChoices(std::size_t questions) : implied_(2 * questions) {}

  /// An answer may exclude itself.
  void exclude(Answer a, Answer b) {
    implied_[a].push_back(b ^ 1);
    if (a != b) implied_[b].push_back(a ^ 1);
  }

  /// An answer, 0 or 1, to each question; nothing if there are none.
  /// Source: B. Aspvall, M. Plass, R. Tarjan, A linear-time algorithm for testing the truth of
  /// certain quantified Boolean formulas (1979).
  std::optional<std::vector<std::uint8_t>> answers() const;

 private:
  std::vector<std::vector<Answer>> implied_;  ///< answers that follow from each
};

}  // namespace tripus::meshing::detail
