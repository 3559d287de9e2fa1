#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "meshing/tube/detail/vector3.hpp"

namespace tripus::meshing::tube {

/// A triangle or tetrahedron with the names of its corners.
template <std::size_t N>
struct Simplex {
  std::array<std::uint32_t, N> names;
  std::array<Point, N> points;

  Bounds bounds() const {
    Bounds result;
    for (const Point& p : points) result.add(p);
    return result;
  }
};

/// Whether a tetrahedron and a triangle meet in nothing but the corners, or the edge, that they
/// have in common by name. May say no where they only come close (never says yes wrongly, but for
/// rounding far below tolerance::kSweepClearance).
bool meet_in_common_face_only(const Simplex<4>& tetrahedron, const Simplex<3>& triangle);

/// A closed surface that can only be changed by motions in which it never meets itself, so that
/// every change is an isotopy: what it bounds stays the same piece of space up to deformation.
///
/// A vertex u moves to a place p on a straight line. Each triangle u a b of its star sweeps out the
/// tetrahedron u p a b; none of these may meet another triangle outside of common corners. The star
/// itself stays embedded because, seen along the sum of its normals (which the ring around it
/// fixes), its triangles keep their side and go once around u all the time.
class GuardedSurface {
 public:
  /// More triangles at one vertex are refused.
  static constexpr std::size_t kMostInStar = 20;

  /// Takes a closed, oriented manifold without self-intersections, with few triangles at each
  /// vertex. Throws InternalError if a vertex has more than kMostInStar.
  explicit GuardedSurface(SurfaceMesh mesh);

  std::size_t triangle_count() const { return alive_; }
  std::size_t point_count() const { return points_.size(); }
  const Point& point(std::uint32_t v) const { return points_[v]; }
  const Triangle& triangle(std::uint32_t t) const { return triangles_[t]; }
  std::span<const std::uint32_t> star(std::uint32_t v) const {
    return {stars_[v].triangles.data(), stars_[v].count};
  }
  bool adjacent(std::uint32_t u, std::uint32_t v) const;

  /// Moves a vertex if that is an isotopy. `least_quality`: no triangle of the star may become
  /// worse than this, or than the worst one there was, whichever is less.
  bool move(std::uint32_t u, const Point& to, double least_quality);

  /// Moves u onto its neighbour v and merges them, if that is an isotopy; u is gone then.
  bool collapse(std::uint32_t u, std::uint32_t v, double least_quality);

  /// What is left, points renumbered in their order.
  SurfaceMesh mesh() const;

 private:
  struct Star {
    std::array<std::uint32_t, kMostInStar> triangles;
    std::uint32_t count = 0;
  };
  /// An edge a b of the ring around a vertex, in the order of its triangle.
  struct RingEdge {
    std::uint32_t a, b;
  };

  std::span<const RingEdge> ring_of(std::uint32_t u);
  bool star_stays_embedded(std::uint32_t u, const Point& to, std::uint32_t merged,
                           double least_quality);
  bool sweep_is_clear(std::uint32_t u, const Point& to, std::uint32_t merged);
  bool link_allows(std::uint32_t u, std::uint32_t v);
  void drop_from_star(std::uint32_t v, std::uint32_t t);
  void collect_near(const Bounds& bounds, std::uint32_t u);

  // The triangles by the cells of a uniform grid that their boxes meet.
  void make_grid();
  template <class Visit>
  void for_cells(const Bounds& bounds, Visit&& visit) const;
  Bounds bounds_of(std::uint32_t t) const;
  void insert(std::uint32_t t);
  void remove(std::uint32_t t);

  std::vector<Point> points_;
  std::vector<Triangle> triangles_;
  std::vector<bool> dead_;
  std::vector<Star> stars_;
  std::size_t alive_ = 0;

  Bounds bounds_;
  double cell_ = 1;
  std::array<std::size_t, 3> cells_{};
  std::vector<std::vector<std::uint32_t>> grid_;

  // Scratch space.
  std::array<RingEdge, kMostInStar> ring_;
  std::vector<std::uint32_t> near_;
  std::vector<std::uint32_t> seen_;
  std::uint32_t now_ = 0;
};

}  // namespace tripus::meshing::tube
