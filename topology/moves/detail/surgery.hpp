#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "topology/edge_walk.hpp"
#include "topology/moves/detail/local.hpp"
#include "topology/moves/moves.hpp"

namespace tripus::topology::detail {

/// The replacement of some tetrahedra by others, planned first and then carried out. Every face of
/// a removed tetrahedron is one of
///   inner    forgotten with its tetrahedra,
///   carried  it becomes a face of a new tetrahedron, which takes over its gluing,
///   flat     it is merged with another removed face: what lay behind the two is glued together.
/// Outer faces may be glued to each other in any way. A chain of flat faces that closes up with
/// nothing behind it is *sealed*; then the plan must not be carried out.
class Surgery {
 public:
  explicit Surgery(const Gluings& gluings) : gluings_(&gluings) {}

  void remove(TetrahedronIndex t) { removed_.push_back(t); }
  /// A handle of a new tetrahedron: 0, 1, ...
  int add() { return added_++; }
  /// Vertex i of removed tetrahedron t becomes vertex q(i) of the new one, for face f.
  void carry(TetrahedronIndex t, int f, int fresh, Perm4 q) {
    ports_.push_back({t, f, false, static_cast<TetrahedronIndex>(fresh), q});
  }
  /// Face f of t is laid upon face q(f) of other, both removed; call once for the two.
  void flatten(TetrahedronIndex t, int f, TetrahedronIndex other, Perm4 q);
  /// Glues two new tetrahedra.
  void join(int fresh, int f, int other, Perm4 q) { joins_.push_back({fresh, f, other, q}); }

  bool is_sealed() const;
  /// On the table that it was planned for.
  MoveChange apply(Gluings& gluings) const;

  struct Glue {
    TetrahedronIndex t;
    int f;
    TetrahedronIndex other;
    Perm4 map;
  };
  using Glues = SmallList<Glue, 24>;
  /// The gluings that carry it out, where handle k is the tetrahedron numbers[k].
  Glues glues(std::span<const TetrahedronIndex> numbers) const;

 private:
  struct Port {
    TetrahedronIndex t;
    int f;
    bool flat;
    TetrahedronIndex to;  // new handle, or removed tetrahedron
    Perm4 map;
  };
  struct Join {
    int fresh, f, other;
    Perm4 map;
  };
  /// A face of a surviving or of a new tetrahedron (then t is the handle), with the labels of the
  /// face where the way began carried to it by `map`.
  struct End {
    bool fresh;
    TetrahedronIndex t;
    Perm4 map;
  };
  const Port* port(TetrahedronIndex t, int f) const;
  End follow(TetrahedronIndex t, int f) const;

  const Gluings* gluings_;
  SmallList<TetrahedronIndex, 4> removed_;
  int added_ = 0;
  SmallList<Port, 12> ports_;
  SmallList<Join, 8> joins_;
};

/// The points of a ball at the four vertices of a tetrahedron in it.
using Points = std::array<int, 4>;

struct Piece {
  TetrahedronIndex t;
  Points points;
};

/// Corner i of n around an edge: points 0 and 1 are the ends of the edge, 2 .. n + 1 follow one
/// another around it.
inline Piece piece_around(const EdgeWalk& corner, std::size_t i, std::size_t n) {
  Piece piece{static_cast<TetrahedronIndex>(corner.t), {}};
  piece.points[static_cast<std::size_t>(corner.a)] = 0;
  piece.points[static_cast<std::size_t>(corner.b)] = 1;
  piece.points[static_cast<std::size_t>(corner.c)] = static_cast<int>(2 + i);
  piece.points[static_cast<std::size_t>(corner.d)] = static_cast<int>(2 + (i + 1) % n);
  return piece;
}

/// What a move replaces by what. Faces of `old` that contain every point of `core` are inside.
struct MoveBall {
  SmallList<Piece, 4> old;
  unsigned core = 0;
  SmallList<Points, 4> fresh;
};

/// The N distinct tetrahedra around an edge of valence N.
template <std::size_t N>
MoveBall ball_around(const Gluings& gluings, const Move& move) {
  std::array<EdgeWalk, N> corners{};
  collect_corners(gluings, move.tetrahedron, move.place, corners);
  MoveBall ball;
  ball.core = 0b11;
  for (std::size_t i = 0; i < N; ++i) ball.old.push_back(piece_around(corners[i], i, N));
  return ball;
}

constexpr unsigned point_mask(const Points& points) {
  unsigned mask = 0;
  for (const int point : points) mask |= 1u << point;
  return mask;
}
/// The vertex at the given point, which must be there.
int vertex_at(const Points& points, int point);
/// The edge between two points.
int edge_at(const Points& points, int first, int second);

/// The surgery that replaces the pieces of a ball. Of the outer faces of `old`, each is carried to
/// the face of `fresh` with the same points, or laid upon the other old face with the same points.
/// Faces of `fresh` that are left over are joined in pairs. `fresh` may come back with two vertices
/// swapped, so that oriented tables stay oriented.
Surgery plan_ball(const Gluings& gluings, MoveBall& ball);

}  // namespace tripus::topology::detail
