#pragma once

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

#include "topology/gluings.hpp"

namespace tripus::topology::detail {

/// Face f of tetrahedron t, which is flattened, and the face on which it is laid.
struct Port {
  TetrahedronIndex t;
  int f;
  TetrahedronIndex other;
  Perm4 map;  ///< labels of t to those of other
  /// The near side of its merged face, and the labels of t there, for the vertices of face f.
  TetrahedronIndex near = kNoTetrahedron;
  Perm4 to_near = {};
  /// From the frame of the near side to that of t, as a number of the group.
  std::uint32_t to_frame = 0;
};

/// What a step flattens. Each flattened tetrahedron has two faces (a 2-0 at an edge: twice two)
/// that are laid upon those of others, in chains, until the ends of a chain, which are faces of
/// tetrahedra that stay, are glued together in the table after the step: the *merged face* of the
/// chain. Of its two sides the *near* one is that with the smaller number.
class Flattening {
 public:
  /// For tables with so many slots; there are no ports then.
  void reset(std::size_t slot_count);
  /// Forgets the ports. O(ports).
  void clear();
  void lay(TetrahedronIndex t, int f, TetrahedronIndex other, const Perm4& map) {
    ports_.push_back({t, f, other, map});
  }
  /// Follows the chains in the table before the step: sets `near` and `to_near` of every port.
  void find_near(const Gluings& before);

  std::vector<Port>& ports() { return ports_; }
  /// The port at face f of tetrahedron t, or null; after find_near.
  const Port* port(TetrahedronIndex t, int f) const;

 private:
  std::tuple<TetrahedronIndex, Perm4> chain_end(const Gluings& before, TetrahedronIndex t, int f,
                                                Perm4 map) const;

  std::vector<Port> ports_;
  std::vector<std::uint32_t> port_of_;  // by slot 4 t + f: 0 none, else port + 1
};

}  // namespace tripus::topology::detail
