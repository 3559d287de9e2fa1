#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "topology/perm4.hpp"

namespace tripus::topology {

/// Index of a tetrahedron; kNoTetrahedron marks an open face.
using TetrahedronIndex = std::uint32_t;
inline constexpr TetrahedronIndex kNoTetrahedron = 0xffffffffu;

/// The raw gluing table of T tetrahedra, as files give it and as moves edit it: 20 bytes a
/// tetrahedron, no invariants beyond "glue and unglue keep both sides consistent".
///
/// Face f of tetrahedron t goes to tetrahedron neighbour(t, f) by gluing(t, f) = p: vertex i of t
/// goes to vertex p(i), and the image face is p(f).
class Gluings {
 public:
  Gluings() = default;
  explicit Gluings(std::size_t tetrahedron_count)
      : neighbours_(4 * tetrahedron_count, kNoTetrahedron), perms_(4 * tetrahedron_count) {}

  std::size_t tetrahedron_count() const { return perms_.size() / 4; }

  TetrahedronIndex neighbour(std::size_t t, int f) const { return neighbours_[slot(t, f)]; }
  Perm4 gluing(std::size_t t, int f) const { return perms_[slot(t, f)]; }
  bool is_open(std::size_t t, int f) const { return neighbour(t, f) == kNoTetrahedron; }

  /// Sets one side only: for parsers, which check consistency afterwards.
  void set_one_side(std::size_t t, int f, TetrahedronIndex other, Perm4 p) {
    neighbours_[slot(t, f)] = other;
    perms_[slot(t, f)] = p;
  }
  /// Sets both sides.
  void glue(std::size_t t, int f, TetrahedronIndex other, Perm4 p) {
    set_one_side(t, f, other, p);
    set_one_side(other, p(f), static_cast<TetrahedronIndex>(t), p.inverse());
  }

  friend bool operator==(const Gluings&, const Gluings&) = default;

 private:
  static std::size_t slot(std::size_t t, int f) { return 4 * t + static_cast<std::size_t>(f); }

  std::vector<TetrahedronIndex> neighbours_;  // [T x 4]
  std::vector<Perm4> perms_;                  // [T x 4]
};

}  // namespace tripus::topology
