#include "topology/covers/cover_homology.hpp"

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "topology/detail/smith_form.hpp"

namespace tripus::topology {
namespace {

using Sheet = std::uint32_t;
constexpr std::uint32_t kInTree = std::numeric_limits<std::uint32_t>::max();

/// Column of each arrow (generator, sheet it starts from) that is not in a spanning tree.
struct Arrows {
  std::vector<std::uint32_t> column;  // [generators x d]
  std::uint32_t count = 0;
};

Arrows number_arrows(const TransitiveAction& action,
                     const std::vector<std::vector<Sheet>>& inverses) {
  const std::size_t degree = action.degree;
  Arrows arrows{std::vector<std::uint32_t>(action.images.size() * degree, 0)};
  std::vector<Sheet> reached{0};
  std::vector<bool> met(degree, false);
  met[0] = true;
  const auto reach = [&](std::size_t arrow, Sheet sheet) {
    if (met[sheet]) return;
    met[sheet] = true;
    arrows.column[arrow] = kInTree;
    reached.push_back(sheet);
  };
  for (std::size_t i = 0; i < reached.size(); ++i)
    for (std::size_t g = 0; g < action.images.size(); ++g) {
      const Sheet sheet = reached[i];
      reach(g * degree + sheet, action.images[g][sheet]);
      reach(g * degree + inverses[g][sheet], inverses[g][sheet]);
    }
  for (std::uint32_t& column : arrows.column)
    if (column != kInTree) column = arrows.count++;
  return arrows;
}

}  // namespace

AbelianGroup first_homology(const Presentation& presentation, const TransitiveAction& action) {
  const std::size_t degree = action.degree;
  std::vector<std::vector<Sheet>> inverses(action.images.size(), std::vector<Sheet>(degree));
  for (std::size_t g = 0; g < inverses.size(); ++g)
    for (Sheet k = 0; k < degree; ++k) inverses[g][action.images[g][k]] = k;
  const Arrows arrows = number_arrows(action, inverses);
  std::vector<detail::SparseRow<std::int64_t>> rows;
  rows.reserve(presentation.relators.size() * degree);
  for (const Word& relator : presentation.relators)
    for (Sheet start = 0; start < degree; ++start) {
      detail::SparseRow<std::int64_t> row;
      Sheet sheet = start;
      for (const Letter letter : relator) {
        const std::size_t g = generator_of(letter);
        if (letter < 0) sheet = inverses[g][sheet];
        const std::uint32_t column = arrows.column[g * degree + sheet];
        if (column != kInTree) row.push_back({column, letter > 0 ? 1 : -1});
        if (letter > 0) sheet = action.images[g][sheet];
      }
      rows.push_back(detail::collected(std::move(row)));
    }
  const detail::SmithForm form = detail::smith_form(std::move(rows), arrows.count);
  AbelianGroup group;
  group.rank = arrows.count - form.rank;
  for (const auto& factor : form.factors) group.invariant_factors.push_back(to_decimal(factor));
  return group;
}

CoverHomology cover_homology(const Triangulation& triangulation, std::size_t degree) {
  const Presentation presentation =
      reduced(fundamental_group(triangulation).presentation).presentation;
  CoverHomology result;
  for_each_transitive_action(presentation, degree, [&](const TransitiveAction& action) {
    ++result[to_string(first_homology(presentation, action))];
    return true;
  });
  return result;
}

}  // namespace tripus::topology
