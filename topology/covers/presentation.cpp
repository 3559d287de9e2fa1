#include "topology/covers/presentation.hpp"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <queue>
#include <utility>

#include "base/error.hpp"
#include "topology/detail/relators.hpp"

namespace tripus::topology {
namespace {

/// Relators may grow in all to this many times their length, or to this length if that is more:
/// few generators are worth longer relators to a search, but the work must stay bounded.
constexpr std::size_t kGrowth = 8;
constexpr std::size_t kFreeLength = 1000;

/// Powers of relators are written out, up to this length.
constexpr std::int64_t kLongestRelator = 10'000'000;

void append_reduced(Word& word, Letter letter) {
  if (!word.empty() && word.back() == -letter) {
    word.pop_back();
  } else {
    word.push_back(letter);
  }
}

/// Takes letters off both ends that cancel when the word is closed to a circle.
void reduce_cyclically(Word& word) {
  std::size_t off = 0;
  while (2 * off + 1 < word.size() && word[off] == -word[word.size() - 1 - off]) ++off;
  word.erase(word.end() - static_cast<std::ptrdiff_t>(off), word.end());
  word.erase(word.begin(), word.begin() + static_cast<std::ptrdiff_t>(off));
}

class Rewriter {
 public:
  explicit Rewriter(const Presentation& presentation)
      : relators_(presentation.relators),
        relators_of_(presentation.generator_count),
        count_(presentation.generator_count, 0),
        solved_(presentation.generator_count, false) {
    for (std::size_t r = 0; r < relators_.size(); ++r) enter(r);
    limit_ = std::max(kGrowth * length_, kFreeLength);
  }

  ReducedPresentation run() {
    ReducedPresentation result;
    while (!waiting_.empty()) {
      const auto [length, r] = waiting_.top();
      waiting_.pop();
      if (length != relators_[r].size()) continue;  // it changed, and was queued again
      const auto place = cheapest(relators_[r]);
      if (place == relators_[r].size()) continue;
      const std::size_t generator = generator_of(relators_[r][place]);
      if (length_ + (length - 1) * (count_[generator] - 1) > limit_) continue;
      result.solved.push_back({generator, solve(r, place)});
    }
    return finish(std::move(result));
  }

 private:
  using Queued = std::pair<std::size_t, std::size_t>;  // length, relator

  void enter(std::size_t r) {
    for (const Letter letter : relators_[r]) {
      auto& list = relators_of_[generator_of(letter)];
      if (list.empty() || list.back() != r) list.push_back(r);
      ++count_[generator_of(letter)];
    }
    length_ += relators_[r].size();
    if (!relators_[r].empty()) waiting_.emplace(relators_[r].size(), r);
  }

  void leave(std::size_t r) {
    for (const Letter letter : relators_[r]) --count_[generator_of(letter)];
    length_ -= relators_[r].size();
  }

  /// Place of the generator that occurs once here and least elsewhere; the end if there is none.
  std::size_t cheapest(const Word& relator) const {
    std::vector<std::size_t> generators;
    generators.reserve(relator.size());
    for (const Letter letter : relator) generators.push_back(generator_of(letter));
    std::ranges::sort(generators);
    std::size_t best = relator.size();
    for (std::size_t i = 0; i < relator.size(); ++i) {
      const std::size_t generator = generator_of(relator[i]);
      if (best != relator.size() && count_[generator] >= count_[generator_of(relator[best])])
        continue;
      const auto [first, last] = std::equal_range(generators.begin(), generators.end(), generator);
      if (last - first == 1) best = i;
    }
    return best;
  }

  /// Solves relator r for its letter at the place, and puts the solution in everywhere.
  Word solve(std::size_t r, std::size_t place) {
    Word rest(relators_[r]);
    std::rotate(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(place), rest.end());
    const Letter letter = rest.front();
    rest.erase(rest.begin());
    Word inverse(rest.rbegin(), rest.rend());
    for (Letter& x : inverse) x = -x;
    const Word& value = letter > 0 ? inverse : rest;
    const Word& opposite = letter > 0 ? rest : inverse;
    const std::size_t generator = generator_of(letter);
    leave(r);
    relators_[r].clear();
    solved_[generator] = true;
    const auto affected = std::exchange(relators_of_[generator], {});
    for (const std::size_t other : affected) substitute(other, generator, value, opposite);
    return value;
  }

  void substitute(std::size_t r, std::size_t generator, const Word& value, const Word& opposite) {
    const auto is_it = [generator](Letter letter) { return generator_of(letter) == generator; };
    if (std::ranges::none_of(relators_[r], is_it)) return;  // an old entry of the list
    leave(r);
    Word word;
    for (const Letter letter : relators_[r]) {
      if (!is_it(letter)) {
        append_reduced(word, letter);
        continue;
      }
      for (const Letter part : letter > 0 ? value : opposite) append_reduced(word, part);
    }
    reduce_cyclically(word);
    relators_[r] = std::move(word);
    enter(r);
  }

  ReducedPresentation finish(ReducedPresentation result) {
    std::vector<Letter> number(solved_.size(), 0);
    for (std::size_t g = 0; g < solved_.size(); ++g) {
      if (solved_[g]) continue;
      result.kept.push_back(g);
      number[g] = static_cast<Letter>(result.kept.size());
    }
    result.presentation.generator_count = result.kept.size();
    for (Word& relator : relators_) {
      if (relator.empty()) continue;
      for (Letter& letter : relator)
        letter = letter > 0 ? number[generator_of(letter)] : -number[generator_of(letter)];
      result.presentation.relators.push_back(std::move(relator));
    }
    return result;
  }

  std::vector<Word> relators_;
  std::vector<std::vector<std::size_t>> relators_of_;  // by generator; may hold old entries
  std::vector<std::size_t> count_;                     // letters, by generator
  std::vector<bool> solved_;
  std::size_t length_ = 0;
  std::size_t limit_ = 0;
  std::priority_queue<Queued, std::vector<Queued>, std::greater<>> waiting_;
};

}  // namespace

std::int64_t rotation_order(const ConeAngle& cone_angle) {
  if (!cone_angle.is_rational()) return 0;
  if (cone_angle.numerator() == 1) return 2 * cone_angle.denominator();
  return cone_angle.numerator() == 2 ? cone_angle.denominator() : 0;
}

FundamentalGroup fundamental_group(const Triangulation& triangulation) {
  return orbifold_group(triangulation, {});
}

FundamentalGroup orbifold_group(const Triangulation& triangulation,
                                std::span<const ConeAngle> cone_angles) {
  if (!triangulation.is_connected())
    throw InvalidInput("the triangulation has " + std::to_string(triangulation.component_count()) +
                       " components; take one of them");
  const detail::FaceGenerators generators(triangulation.gluings());
  FundamentalGroup group;
  group.presentation.generator_count = generators.count();
  group.face_letters.resize(4 * triangulation.tetrahedron_count());
  for (std::size_t slot = 0; slot < group.face_letters.size(); ++slot)
    group.face_letters[slot] = generators.code(slot);
  for (std::size_t e = 0; e < triangulation.edge_count(); ++e) {
    Word relator;
    detail::walk_around_edge(triangulation, e, [&](std::size_t slot) {
      if (group.face_letters[slot] != 0) append_reduced(relator, group.face_letters[slot]);
    });
    reduce_cyclically(relator);
    const std::int64_t order = cone_angles.empty() ? 1 : rotation_order(cone_angles[e]);
    if (order > kLongestRelator / std::max<std::int64_t>(1, std::ssize(relator)))
      throw InvalidInput("the cone order " + std::to_string(order) + " of edge class " +
                         std::to_string(e) + " makes its relator longer than " +
                         std::to_string(kLongestRelator) + " letters; give it a smaller order");
    Word power;
    for (std::int64_t n = 0; n < order; ++n)
      power.insert(power.end(), relator.begin(), relator.end());
    if (!power.empty()) group.presentation.relators.push_back(std::move(power));
  }
  return group;
}

ReducedPresentation reduced(const Presentation& presentation) {
  return Rewriter(presentation).run();
}

}  // namespace tripus::topology
