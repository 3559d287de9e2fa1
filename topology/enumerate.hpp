#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "base/stop.hpp"
#include "topology/gluings.hpp"
#include "topology/triangulation.hpp"

namespace tripus::topology {

/// Which triangulations an enumeration is about, by their vertex links.
enum class LinkChoice {
  kGeodesic,  ///< every link has negative Euler characteristic: genus >= 2 if orientable
  kMixed,     ///< such links, and tori or Klein bottles, at least one of each
  kCusped,    ///< every link is a torus or a Klein bottle
};
/// "geodesic", "mixed", "cusped".
std::string_view to_string(LinkChoice links);
/// Whether the links are such.
bool has_links(const Triangulation& triangulation, LinkChoice links);

/// Whether an enumeration is about orientable triangulations.
enum class Orientability { kOrientable, kNonOrientable, kBoth };

/// What an enumeration is about.
struct EnumerationChoice {
  EnumerationChoice(LinkChoice wanted_links,
                    Orientability wanted_orientability = Orientability::kOrientable)
      : links(wanted_links), orientability(wanted_orientability) {}
  LinkChoice links;
  Orientability orientability;
};
/// Whether a triangulation is such.
bool is_chosen(const Triangulation& triangulation, const EnumerationChoice& choice);

/// The most tetrahedra: 7 have some 2.5e9 triangulations, each more 70 times as many.
inline constexpr std::size_t kMaxEnumerated = 12;

/// A beginning of gluings: everything that begins so is one piece of an enumeration. In the order
/// in which a search meets the faces, what each is glued to.
struct EnumerationPiece {
  std::vector<std::uint16_t> symbols;
};

/// The pieces of an enumeration, in their order: each triangulation with so many tetrahedra belongs
/// to exactly one of them. There are some thousands, of very different sizes; for up to 2
/// tetrahedra a few. Throws InvalidInput unless 1 <= tetrahedra <= kMaxEnumerated.
std::vector<EnumerationPiece> enumeration_pieces(std::size_t tetrahedra,
                                                 const EnumerationChoice& choice);

/// Calls `take` for each connected triangulation of a piece, one of each class of isomorphic ones
/// (mirror images are isomorphic), in a fixed order; `symmetries` is the number of its
/// automorphisms, those that reverse an orientation included. No edge is glued to itself the other
/// way round: that is no manifold. Nothing is kept: the memory is
/// a constant. Ends early if `stop` is set. Returns how many there were.
///
/// A search glues face after face and keeps the gluings that are the least among all their
/// labellings, as far as these are determined yet: orderly generation. Sources: R. C. Read, Every
/// one a winner, Ann. Discrete Math. 2 (1978); for triangulations by their face pairings and with
/// pruning on edges: B. A. Burton, Face pairing graphs and 3-manifold enumeration,
/// math/0307382. docs/census.md.
std::uint64_t enumerate(
    std::size_t tetrahedra, const EnumerationChoice& choice, const EnumerationPiece& piece,
    const std::function<void(const Gluings& gluings, unsigned symmetries)>& take,
    const Stop& stop = {});

}  // namespace tripus::topology
