#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "base/stop.hpp"
#include "topology/covers/transitive_actions.hpp"

namespace tripus::topology {

/// What crossing a face of the base, outside of a spanning tree, does to the sheets.
struct SheetPermutation {
  TetrahedronIndex tetrahedron = 0;
  int face = 0;
  std::vector<std::uint32_t> images;  ///< [d]
};

/// A connected cover: tetrahedron t on sheet k has number k T + t and the vertices of t, so the
/// covering map forgets the sheet. Edge valences are those of the base: nothing is branched.
struct Cover {
  Gluings gluings;
  std::size_t degree = 0;
  /// How many deck transformations there are; the cover is regular if as many as sheets.
  std::size_t deck_group_order = 0;
  /// Of a cyclic cover: its class, in the basis of CyclicClasses. Empty otherwise.
  std::vector<std::int64_t> cyclic_class = {};
  /// Of other covers: how generators of the fundamental group permute the sheets. The cover is that
  /// of the subgroup of the loops which begin and end on sheet 0.
  std::vector<SheetPermutation> permutations = {};

  bool is_regular() const { return deck_group_order == degree; }
};

/// Returns false to stop the search.
using VisitCover = std::function<bool(const Cover&)>;

/// Visits all connected covers with `degree` sheets, one of each isomorphism class of covers (maps
/// that keep the base pointwise; two of them may still be homeomorphic). They are made one by one
/// and not kept. Their number grows like a power of degree!: expect up to 7 sheets or so.
/// Polls `stop`.
/// Throws InvalidInput if the base is not connected or the degree is not in
/// 1..kLargestSearchDegree, or gives more than kMaxTetrahedra tetrahedra.
SearchEnd for_each_cover(const Triangulation& base, std::size_t degree, const VisitCover& visit,
                         const Stop& stop = {});

/// Visits all connected covers whose deck group is cyclic of order `degree`, one of each
/// isomorphism class: the classes in Hom(H1, Z/degree) that are onto, up to units.
/// Throws InvalidInput as above, but for any degree >= 1, and Unsupported as CyclicClasses.
SearchEnd for_each_cyclic_cover(const Triangulation& base, std::size_t degree,
                                const VisitCover& visit, const Stop& stop = {});

/// The cyclic cover of one class, given by its values on the basis of CyclicClasses.
/// Throws InvalidInput as CyclicClasses::shifts, and if the class is not onto.
Cover cyclic_cover_of_class(const Triangulation& base, std::size_t degree,
                            std::span<const std::int64_t> values);

/// The orientable cover with two sheets of a non-orientable manifold. Throws InvalidInput if the
/// base is orientable or not connected.
Cover orientable_double_cover(const Triangulation& base);

/// The connected cover on whose sheets the generators of `fundamental_group(base)` act by the
/// permutations [generators][d]. Throws InvalidInput, naming what is wrong, if they are no
/// permutations, no action or not transitive; Stopped. Polls `stop`.
Gluings cover_of_permutations(const Triangulation& base,
                              const std::vector<std::vector<std::uint32_t>>& images,
                              const Stop& stop = {});

/// The cover of an action of the fundamental group.
Gluings cover_of_action(const Gluings& base, const FundamentalGroup& group,
                        const TransitiveAction& action);

}  // namespace tripus::topology
