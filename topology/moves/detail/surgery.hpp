#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "topology/edge_walk.hpp"
#include "topology/moves/moves.hpp"

namespace tripus::topology::detail {

inline bool has_open_face(const Gluings& gluings, std::size_t t) {
  for (int f = 0; f < 4; ++f)
    if (gluings.is_open(t, f)) return true;
  return false;
}

/// Whether two positions are the same corner in the same direction.
inline bool is_same_corner(const EdgeWalk& first, const EdgeWalk& second) {
  return first.t == second.t && first.a == second.a && first.b == second.b;
}

/// The corners around an edge in the order of the walk, if there are exactly N of them, in N
/// distinct tetrahedra without open faces.
template <std::size_t N>
MoveRefusal collect_corners(const Gluings& gluings, std::size_t t, int edge,
                            std::array<EdgeWalk, N>& corners) {
  auto walk = EdgeWalk::start(t, edge);
  for (std::size_t i = 0; i < N; ++i) {
    if (i > 0 && is_same_corner(walk, corners[0])) return MoveRefusal::kWrongValence;
    if (has_open_face(gluings, walk.t)) return MoveRefusal::kOpenFace;
    corners[i] = walk;
    walk.step(gluings);
  }
  if (!is_same_corner(walk, corners[0])) return MoveRefusal::kWrongValence;
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t j = i + 1; j < N; ++j)
      if (corners[i].t == corners[j].t) return MoveRefusal::kNotDistinct;
  return MoveRefusal::kNone;
}

/// The valence of the edge along which the walk stands; 0 if it meets an open face. O(valence).
std::size_t valence(const Gluings& gluings, const EdgeWalk& start);

/// Whether two edges are one edge class. Open faces end the walk, which may then miss it.
/// O(valence).
bool is_same_edge(const Gluings& gluings, std::size_t t, int edge, std::size_t other,
                  int other_edge);

/// For moves at faces, edges, vertices or tetrahedra: each once, with choices 0 .. choices - 1.
void face_candidates(const Triangulation& triangulation, MoveKind kind, std::vector<Move>& moves);
void edge_candidates(const Triangulation& triangulation, MoveKind kind, int choices,
                     std::vector<Move>& moves);
void vertex_candidates(const Triangulation& triangulation, MoveKind kind, std::vector<Move>& moves);

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

// One function a kind, each at the end of the file that holds the move. The table in moves.cpp
// lists them; refusal and apply may assume that tetrahedron, place and choice are in range.
MoveInfo two_three_info();
MoveInfo three_two_info();
MoveInfo four_four_info();
MoveInfo two_zero_edge_info();
MoveInfo zero_two_edge_info();
MoveInfo two_zero_vertex_info();
MoveInfo zero_two_face_info();
MoveInfo two_one_info();
MoveInfo one_two_info();
MoveInfo one_four_info();
MoveInfo four_one_info();

/// The conditions of a 2-0 at an edge, but for the opposite edges being distinct.
MoveRefusal refuse_pillow(const Gluings& gluings, const Move& move);
/// The conditions of a 2-1, but for the edges to be merged being distinct.
MoveRefusal refuse_fold(const Gluings& gluings, const Move& move);

}  // namespace tripus::topology::detail
