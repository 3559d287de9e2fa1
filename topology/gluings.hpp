#pragma once

#include <array>
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

  void reserve(std::size_t tetrahedron_count) {
    neighbours_.reserve(4 * tetrahedron_count);
    perms_.reserve(4 * tetrahedron_count);
  }
  /// Grows (new tetrahedra have four open faces) or shrinks (the caller has unglued what goes).
  void resize(std::size_t tetrahedron_count) {
    neighbours_.resize(4 * tetrahedron_count, kNoTetrahedron);
    perms_.resize(4 * tetrahedron_count);
  }
  /// Takes tetrahedron t out and gives its number to the last one. Nothing may be glued to t any
  /// more, but for t itself.
  void remove_tetrahedron(std::size_t t) {
    const std::size_t last = tetrahedron_count() - 1;
    for (int f = 0; f < 4 && t != last; ++f) {
      const TetrahedronIndex other = neighbour(last, f);
      const Perm4 p = gluing(last, f);
      set_one_side(t, f, other, p);
      if (other != kNoTetrahedron)
        glue(t, f, other == last ? static_cast<TetrahedronIndex>(t) : other, p);
    }
    resize(last);
  }
  /// Bytes held on the heap.
  std::size_t memory_bytes() const {
    return neighbours_.capacity() * sizeof(TetrahedronIndex) + perms_.capacity() * sizeof(Perm4);
  }

  friend bool operator==(const Gluings&, const Gluings&) = default;

 private:
  static std::size_t slot(std::size_t t, int f) { return 4 * t + static_cast<std::size_t>(f); }

  std::vector<TetrahedronIndex> neighbours_;  // [T x 4]
  std::vector<Perm4> perms_;                  // [T x 4]
};

/// Whether open faces are let through by require_consistent.
enum class OpenFaces { kAllowed, kRefused };

/// Throws InvalidInput, naming tetrahedron and face, for: a gluing to a tetrahedron that does not
/// exist, a gluing that is not undone from the other side, a face glued to itself, more than
/// kMaxTetrahedra tetrahedra, and an open face where those are refused.
void require_consistent(const Gluings& gluings, OpenFaces open_faces);

/// EdgeCorner packs a tetrahedron into 28 bits.
inline constexpr std::size_t kMaxTetrahedra = std::size_t{1} << 28;

/// The word p(0)p(1)p(2)p(3), as in "1230".
inline std::array<char, 4> word(Perm4 p) {
  return {static_cast<char>('0' + p(0)), static_cast<char>('0' + p(1)),
          static_cast<char>('0' + p(2)), static_cast<char>('0' + p(3))};
}

}  // namespace tripus::topology
