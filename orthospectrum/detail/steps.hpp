#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "topology/triangulation.hpp"

/// What unfolding needs of a metric, computed once: no frames in space, only Gram matrices.
namespace tripus::orthospectrum::detail {

/// Crossing face f of tetrahedron t. The new vertex w' beyond it is a combination of the four old
/// ones, and so is whatever is linear in them: products with the pole of the base plane, and
/// projections to that plane.
struct Step {
  std::array<double, 4> combination{};   ///< w' = sum combination[i] w_i, i as in t
  std::uint32_t tetrahedron = 0;         ///< beyond the face
  std::array<std::uint8_t, 4> labels{};  ///< vertex i of t is labels[i] there; [f]: the new vertex
};

/// For face f of a tetrahedron the pole, as a combination of w_0..w_3, of the plane beyond the face
/// that has one given distance from the three truncations at the face (from an ideal vertex the
/// product of its horoball): among the planes that keep this distance from them, with the foot
/// within the face, none is nearer to the base plane.
struct Lid {
  bool exists = false;
  std::array<double, 4> combination{};
};

/// The truncation triangle of a vertex i of tetrahedron t that is not ideal, in the projective
/// model of its plane: a point (x, y) of the disc is the direction (x, y, 1). Its three sides lie
/// in the faces of t.
struct Triangle {
  std::array<std::uint8_t, 3> corners{};  ///< the other ends of its edges, ascending
  /// [3] for each corner the projection of that vertex to the plane, (X, Y, Z) with
  /// X^2 + Y^2 - Z^2 = G_jj - G_ij^2 (-sinh^2 l, or -e^(2 l) of an ideal vertex), Z > 0: the middle
  /// of the triangle is at the origin and the corners come counterclockwise.
  std::array<std::array<double, 3>, 3> feet{};
  /// Projection of any v to the plane: (X, Y, Z) = project * (<v, w_j> - G_ij <v, w_i>)_j.
  std::array<std::array<double, 3>, 3> project{};
  std::array<double, 3> gram{};  ///< G_ij at the corners j
};

class Steps {
 public:
  /// Throws InvalidInput, naming the tetrahedron, where the lengths are not those of truncated
  /// tetrahedra.
  Steps(const topology::Triangulation& triangulation, std::span<const double> edge_lengths);

  std::size_t tetrahedron_count() const { return triangles_.size() / 4; }
  const Step& step(std::size_t t, int f) const { return steps_[at(t, f)]; }
  const Triangle& triangle(std::size_t t, int i) const { return triangles_[at(t, i)]; }
  /// Ideal vertices have no truncation: no tile, and no arc ends there.
  bool is_ideal(std::size_t t, int i) const { return cosh_length(t, i, i) == 0; }
  /// For an ideal vertex i some c > 0 with -<v, w_i> >= c for the poles v of all boundary planes:
  /// its horoball -<x, w_i> <= c stays within the tetrahedra around it, and so meets no plane.
  double horoball(std::size_t t, int i) const { return horoballs_[at(t, i)]; }
  /// -<w_i, w_j>: cosh of the length of the edge between the vertices i and j, or what takes its
  /// place where one is ideal (theory (77)); for i = j -1, or 0 where it is ideal.
  double cosh_length(std::size_t t, int i, int j) const {
    return cosh_[16 * t + static_cast<std::size_t>(4 * i + j)];
  }
  /// [T x 4] for planes that keep the distance `shortest` from one another.
  std::vector<Lid> lids(double shortest) const;

 private:
  static std::size_t at(std::size_t t, int i) { return 4 * t + static_cast<std::size_t>(i); }

  std::vector<Step> steps_;          // [T x 4]
  std::vector<Triangle> triangles_;  // [T x 4]
  std::vector<double> cosh_;         // [T x 16]
  std::vector<double> horoballs_;    // [T x 4]
};

}  // namespace tripus::orthospectrum::detail
