#include "topology/covers/transitive_actions.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "base/stop.hpp"

namespace tripus::topology {
namespace {

using Sheet = std::uint32_t;
constexpr Sheet kUnknown = std::numeric_limits<Sheet>::max();

/// Column 2 g of the table is generator g, column 2 g + 1 its inverse.
std::size_t column_of(Letter letter) {
  return 2 * generator_of(letter) + static_cast<std::size_t>(letter < 0);
}
std::size_t inverse_of(std::size_t column) { return column ^ 1; }

/// A table of images, partly known, with all that the relators imply.
class ActionTable {
 public:
  ActionTable(const Presentation& presentation, std::size_t degree)
      : columns_(2 * presentation.generator_count),
        images_(columns_ * degree, kUnknown),
        rotations_(columns_),
        number_(degree),
        sheet_(degree) {
    for (const Word& relator : presentation.relators) {
      const std::size_t start = letters_.size();
      for (int copy = 0; copy < 2; ++copy)
        for (const Letter letter : relator)
          letters_.push_back(static_cast<std::uint32_t>(column_of(letter)));
      for (std::size_t i = 0; i < relator.size(); ++i)
        rotations_[letters_[start + i]].push_back({start + i, relator.size()});
    }
  }

  std::size_t slot_count() const { return columns_ * sheets_; }
  std::size_t sheets() const { return sheets_; }
  std::size_t known() const { return trail_.size(); }
  Sheet image(std::size_t sheet, std::size_t column) const {
    return images_[sheet * columns_ + column];
  }

  /// The first unknown image from this slot on, or slot_count().
  std::size_t next_unknown(std::size_t slot) const {
    while (slot < slot_count() && images_[slot] != kUnknown) ++slot;
    return slot;
  }

  /// Sets an image, which may be the first sheet without a number, and follows the relators. False
  /// if they contradict it, or it is taken; the table is then to be wound back.
  bool set(std::size_t slot, Sheet value) {
    const std::size_t column = slot % columns_;
    if (value == sheets_) {
      ++sheets_;
    } else if (image(value, inverse_of(column)) != kUnknown) {
      return false;
    }
    std::size_t next = trail_.size();
    record(static_cast<Sheet>(slot / columns_), column, value);
    for (; next < trail_.size(); ++next) {
      const std::size_t known = trail_[next];
      const auto sheet = static_cast<Sheet>(known / columns_);
      if (!follow_relators(sheet, known % columns_) ||
          !follow_relators(images_[known], inverse_of(known % columns_)))
        return false;
    }
    return true;
  }

  void wind_back(std::size_t known, std::size_t sheets) {
    while (trail_.size() > known) {
      const std::size_t slot = trail_.back();
      trail_.pop_back();
      const std::size_t column = slot % columns_;
      images_[images_[slot] * columns_ + inverse_of(column)] = kUnknown;
      images_[slot] = kUnknown;
    }
    sheets_ = sheets;
  }

  /// Whether no other choice of sheet 0 gives a smaller table, as far as it is known.
  bool is_first() {
    symmetries_ = 1;
    for (Sheet base = 1; base < sheets_; ++base) {
      const Order order = compare(base);
      if (order == Order::kSmaller) return false;
      if (order == Order::kEqual) ++symmetries_;
    }
    return true;
  }

  /// Of a complete table that is first.
  TransitiveAction action() const {
    TransitiveAction action;
    action.degree = sheets_;
    action.deck_group_order = symmetries_;
    action.images.resize(columns_ / 2, std::vector<Sheet>(sheets_));
    for (std::size_t g = 0; g < action.images.size(); ++g)
      for (std::size_t k = 0; k < sheets_; ++k) action.images[g][k] = image(k, 2 * g);
    return action;
  }

 private:
  struct Rotation {
    std::size_t start;  // into letters_, where every relator stands twice
    std::size_t length;
  };
  enum class Order : std::uint8_t { kSmaller, kEqual, kOpen };

  void record(Sheet sheet, std::size_t column, Sheet value) {
    images_[sheet * columns_ + column] = value;
    images_[value * columns_ + inverse_of(column)] = sheet;
    trail_.push_back(sheet * columns_ + column);
  }

  bool follow_relators(Sheet sheet, std::size_t column) {
    for (const Rotation& rotation : rotations_[column])
      if (!follow(sheet, rotation)) return false;
    return true;
  }

  /// Follows a relator from both ends. Where one image is missing in the middle it is known now.
  bool follow(Sheet start, const Rotation& rotation) {
    const std::uint32_t* const word = letters_.data() + rotation.start;
    std::size_t first = 0;
    Sheet front = start;
    for (; first < rotation.length; ++first) {
      const Sheet next = image(front, word[first]);
      if (next == kUnknown) break;
      front = next;
    }
    std::size_t last = rotation.length;
    Sheet back = start;
    for (; last > first; --last) {
      const Sheet next = image(back, inverse_of(word[last - 1]));
      if (next == kUnknown) break;
      back = next;
    }
    if (last == first) return front == back;
    if (last == first + 1) record(front, word[first], back);
    return true;
  }

  /// Numbers the sheets anew from the given one, and compares as far as both tables are known.
  Order compare(Sheet base) {
    std::ranges::fill(number_, kUnknown);
    number_[base] = 0;
    sheet_[0] = base;
    Sheet count = 1;
    for (std::size_t row = 0; row < sheets_; ++row) {
      if (row == count) return Order::kOpen;
      for (std::size_t column = 0; column < columns_; ++column) {
        const Sheet mine = image(row, column);
        const Sheet other = image(sheet_[row], column);
        if (mine == kUnknown || other == kUnknown) return Order::kOpen;
        if (number_[other] == kUnknown) {
          number_[other] = count;
          sheet_[count++] = other;
        }
        if (number_[other] != mine) return number_[other] < mine ? Order::kSmaller : Order::kOpen;
      }
    }
    return Order::kEqual;
  }

  std::size_t columns_;
  std::size_t sheets_ = 1;
  std::size_t symmetries_ = 1;
  std::vector<Sheet> images_;                     // [d x columns]
  std::vector<std::size_t> trail_;                // slots in the order in which they became known
  std::vector<std::uint32_t> letters_;            // columns
  std::vector<std::vector<Rotation>> rotations_;  // [columns] by their first letter
  std::vector<Sheet> number_;                     // [d] of compare
  std::vector<Sheet> sheet_;                      // [d]
};

/// A slot at which the search tries one image after another.
struct Choice {
  std::size_t slot;
  Sheet next = 0;
  std::size_t known;  // what there was before
  std::size_t sheets;
};

class ActionSearch {
 public:
  ActionSearch(const Presentation& presentation, std::size_t degree)
      : table_(presentation, degree), degree_(degree) {}

  SearchEnd run(const VisitAction& visit, const Stop& stop) {
    if (!reached(0, visit)) return SearchEnd::kStopped;
    while (!choices_.empty()) {
      if (stop.requested()) return SearchEnd::kStopped;
      Choice& choice = choices_.back();
      table_.wind_back(choice.known, choice.sheets);
      if (choice.next >= std::min(choice.sheets + 1, degree_)) {
        choices_.pop_back();
        continue;
      }
      const std::size_t slot = choice.slot;
      if (!table_.set(slot, choice.next++) || !table_.is_first()) continue;
      if (!reached(slot, visit)) return SearchEnd::kStopped;
    }
    return SearchEnd::kComplete;
  }

 private:
  /// Goes on from the first unknown image, or visits a table that is complete.
  bool reached(std::size_t slot, const VisitAction& visit) {
    const std::size_t next = table_.next_unknown(slot);
    if (next < table_.slot_count()) {
      choices_.push_back({.slot = next, .known = table_.known(), .sheets = table_.sheets()});
      return true;
    }
    return table_.sheets() != degree_ || visit(table_.action());
  }

  ActionTable table_;
  std::size_t degree_;
  std::vector<Choice> choices_;
};

}  // namespace

SearchEnd for_each_transitive_action(const Presentation& presentation, std::size_t degree,
                                     const VisitAction& visit, const Stop& stop) {
  if (degree == 0 || degree > kLargestSearchDegree)
    throw InvalidInput("degree " + std::to_string(degree) +
                       "; all covers are searched for from 1 to " +
                       std::to_string(kLargestSearchDegree) + " sheets");
  return ActionSearch(presentation, degree).run(visit, stop);
}

TransitiveAction extended(const TransitiveAction& action, const ReducedPresentation& reduced) {
  const std::size_t count = reduced.kept.size() + reduced.solved.size();
  TransitiveAction result{action.degree, std::vector<std::vector<Sheet>>(count),
                          action.deck_group_order};
  std::vector<std::vector<Sheet>> inverses(count);
  const auto enter = [&](std::size_t g, std::vector<Sheet> images) {
    inverses[g].resize(images.size());
    for (Sheet k = 0; k < images.size(); ++k) inverses[g][images[k]] = k;
    result.images[g] = std::move(images);
  };
  for (std::size_t i = 0; i < reduced.kept.size(); ++i) enter(reduced.kept[i], action.images[i]);
  for (auto solved = reduced.solved.rbegin(); solved != reduced.solved.rend(); ++solved) {
    std::vector<Sheet> images(action.degree);
    for (Sheet k = 0; k < images.size(); ++k) {
      images[k] = k;
      for (const Letter letter : solved->word)
        images[k] = (letter > 0 ? result.images : inverses)[generator_of(letter)][images[k]];
    }
    enter(solved->generator, std::move(images));
  }
  return result;
}

}  // namespace tripus::topology
