#include "meshing/detail/two_choices.hpp"

#include <algorithm>

namespace tripus::meshing::detail {
namespace {

constexpr std::uint32_t kNew = UINT32_MAX;

/// Tarjan's strong components, without recursion. They come in the order in which nothing leads
/// from an earlier one to a later one.
class StrongComponents {
 public:
  explicit StrongComponents(const std::vector<std::vector<std::uint32_t>>& next)
      : next_(next), number_(next.size(), kNew), low_(next.size()), component_(next.size(), kNew) {
    for (std::uint32_t v = 0; v < next.size(); ++v)
      if (number_[v] == kNew) visit(v);
  }
  std::uint32_t of(std::uint32_t v) const { return component_[v]; }

 private:
  struct Frame {
    std::uint32_t at;
    std::size_t done;
  };

  void enter(std::uint32_t v) {
    number_[v] = low_[v] = count_++;
    open_.push_back(v);
    path_.push_back({v, 0});
  }
  void visit(std::uint32_t start) {
    enter(start);
    while (!path_.empty()) {
      const std::uint32_t v = path_.back().at;
      if (path_.back().done < next_[v].size()) {
        const std::uint32_t w = next_[v][path_.back().done++];
        if (number_[w] == kNew) {
          enter(w);
        } else if (component_[w] == kNew) {
          low_[v] = std::min(low_[v], number_[w]);
        }
        continue;
      }
      path_.pop_back();
      if (!path_.empty()) low_[path_.back().at] = std::min(low_[path_.back().at], low_[v]);
      if (low_[v] == number_[v]) close(v);
    }
  }
  void close(std::uint32_t root) {
    std::uint32_t v = kNew;
    do {
      v = open_.back();
      open_.pop_back();
      component_[v] = components_;
    } while (v != root);
    ++components_;
  }

  const std::vector<std::vector<std::uint32_t>>& next_;
  std::vector<std::uint32_t> number_, low_, component_, open_;
  std::vector<Frame> path_;
  std::uint32_t count_ = 0, components_ = 0;
};

}  // namespace

std::optional<std::vector<std::uint8_t>> TwoChoices::answers() const {
  const StrongComponents components(implied_);
  std::vector<std::uint8_t> chosen(implied_.size() / 2);
  for (std::uint32_t q = 0; q < chosen.size(); ++q) {
    const std::uint32_t no = components.of(2 * q), yes = components.of(2 * q + 1);
    if (no == yes) return std::nullopt;
    // What comes first follows from the other, and does not lead to it.
    chosen[q] = yes < no ? 1 : 0;
  }
  return chosen;
}

}  // namespace tripus::meshing::detail
