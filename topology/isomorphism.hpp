#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/stop.hpp"
#include "topology/gluings.hpp"

namespace tripus::topology {

/// A relabelling of T tetrahedra: tetrahedron t becomes tetrahedron_images[t], and its vertex v
/// becomes vertex perms[t](v) there.
struct Isomorphism {
  std::vector<TetrahedronIndex> tetrahedron_images;  ///< [T] a permutation of 0..T-1
  std::vector<Perm4> perms;                          ///< [T]

  friend bool operator==(const Isomorphism&, const Isomorphism&) = default;
};

/// The same triangulation with new labels.
/// Throws InvalidInput if the isomorphism is not one of T tetrahedra.
Gluings relabelled(const Gluings& gluings, const Isomorphism& isomorphism);

/// A relabelling drawn uniformly with the given seed; the same on every platform.
Isomorphism random_isomorphism(std::size_t tetrahedron_count, std::uint64_t seed);
Gluings random_relabelling(const Gluings& gluings, std::uint64_t seed);

/// An isomorphism from `from` to `to` if there is one. Either may be disconnected.
/// Cost: 24 T starting frames, each abandoned at the first face that does not fit.
std::optional<Isomorphism> find_isomorphism(const Gluings& from, const Gluings& to);

inline bool is_isomorphic(const Gluings& from, const Gluings& to) {
  return find_isomorphism(from, to).has_value();
}

/// All isomorphisms, at most 24 T of them, in the order of the image of frame (tetrahedron 0,
/// 0123). With from == to this is the automorphism group, the identity included.
/// Throws InvalidInput if `from` is empty or not connected; Stopped, polling `stop`.
std::vector<Isomorphism> all_isomorphisms(const Gluings& from, const Gluings& to,
                                          const Stop& stop = {});

}  // namespace tripus::topology
