#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "base/stop.hpp"
#include "canonical/decomposition.hpp"

namespace tripus::canonical {

/// The flags of a decomposition in an order that depends on its isomorphism class alone, up to
/// automorphisms.
struct CanonicalOrder {
  std::vector<FlagIndex> flags;       ///< [F] the flags in this order
  std::vector<std::uint32_t> number;  ///< [F] the place of each flag in it
  /// [4 F] the places that the four steps lead to, place by place: equal codes, isomorphic
  /// decompositions. It is the lexicographically least over all flags that an order may begin with.
  /// With cone angles [5 F]: a fifth number for each place, its flag's label.
  std::vector<std::uint32_t> code;
  std::vector<topology::ConeAngle> cone_angles;  ///< what the labels mean; empty: there are none
  /// All flags that begin an order with this code; the first is flags[0]. One for each
  /// automorphism: automorphism k carries flags[0] to starts[k].
  std::vector<FlagIndex> starts;
};

/// Time: a start for each orbit of flags, abandoned where its code becomes larger, and F for each
/// generator of the automorphisms: some F in practice, F^2 at worst.
/// Throws Stopped.
CanonicalOrder canonical_order(const Decomposition& decomposition, const Stop& stop = {});

/// The isometry group of a manifold: the automorphisms of its canonical decomposition.
struct IsometryGroup {
  std::size_t order = 0;
  /// Isometries that keep the orientation; 0 if the manifold has none.
  std::size_t orientation_preserving = 0;
  bool is_amphicheiral = false;  ///< orientable, and some isometry reverses the orientation
  std::string name;              ///< see group_name; empty for groups of more than 1000 elements
  std::map<std::size_t, std::size_t> element_orders;  ///< order to number of elements; likewise
  /// Generators as maps of flags [F], the identity never among them: each is outside of the group
  /// that those before it generate.
  std::vector<std::vector<FlagIndex>> generators;
  /// The same as permutations of the boundary components [V].
  std::vector<std::vector<std::uint32_t>> generators_on_boundary;
};

IsometryGroup isometry_group(const Decomposition& decomposition, const CanonicalOrder& order,
                             std::size_t boundary_component_count);

/// The isomorphism that carries flag order `from` to `to`: [F] images of the flags of `from`.
/// Needs equal codes.
std::vector<FlagIndex> isomorphism(const CanonicalOrder& from, const CanonicalOrder& to);

/// All isomorphisms to a decomposition with this order, one for each of its automorphisms; the
/// first is `isomorphism`. Needs equal codes.
std::vector<std::vector<FlagIndex>> all_isomorphisms(const CanonicalOrder& from,
                                                     const Decomposition& to,
                                                     const CanonicalOrder& to_order);

/// A map of flags as a relabelling: cell c goes to cell_images[c], its vertex v to
/// vertex_images[c][v] there.
struct CellMap {
  std::vector<std::uint32_t> cell_images;
  std::vector<std::vector<std::uint32_t>> vertex_images;
};
CellMap as_cell_map(const Decomposition& from, const Decomposition& to,
                    const std::vector<FlagIndex>& flag_images);

}  // namespace tripus::canonical
