#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "base/stop.hpp"
#include "topology/covers/presentation.hpp"

namespace tripus::topology {

/// The degrees that the search for covers takes. Long before, it has no end: the number of covers
/// grows like a power of the degree's factorial.
inline constexpr std::size_t kLargestSearchDegree = 100;

/// A transitive action of a group on the sheets 0..d-1, from the right.
struct TransitiveAction {
  std::size_t degree = 0;
  /// [generators][d] image of each sheet.
  std::vector<std::vector<std::uint32_t>> images;
  /// Permutations of the sheets that commute with the action: the deck transformations.
  std::size_t deck_group_order = 0;
};

/// Why a search came to its end.
enum class SearchEnd : std::uint8_t {
  kComplete,  ///< everything was visited
  kStopped,   ///< by the visitor or the flag
};

/// Returns false to stop the search.
using VisitAction = std::function<bool(const TransitiveAction&)>;

/// Visits the transitive actions on d sheets up to renumbering of the sheets: one for each
/// conjugacy class of subgroups of index d, d / deck_group_order subgroups in the class.
///
/// C. Sims' low-index search: sheets are numbered in the order in which the table of images,
/// read row by row, first meets them; relators are followed wherever a new image lies on them, and
/// of the d tables with another sheet as number 0 only the smallest goes on. Memory is that of one
/// table. Deterministic. Polls `stop` at every step.
/// Throws InvalidInput if degree is not in 1..kLargestSearchDegree.
/// Source: C. C. Sims, Computation with Finitely Presented Groups (1994), chapter 5.
SearchEnd for_each_transitive_action(const Presentation& presentation, std::size_t degree,
                                     const VisitAction& visit, const Stop& stop = {});

/// The same action by images of the old generators of a reduced presentation.
TransitiveAction extended(const TransitiveAction& action, const ReducedPresentation& reduced);

}  // namespace tripus::topology
