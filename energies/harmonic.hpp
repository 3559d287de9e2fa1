#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "energies/element_pattern.hpp"
#include "geometry/hyperbolic_space.hpp"
#include "solver/problem.hpp"

namespace tripus::energies {

/// Points a and b of a mesh that share an edge: f_b is carried beside f_a by an isometry.
struct HarmonicEdge {
  std::uint32_t a = 0, b = 0;
  std::uint32_t isometry = 0;  ///< index into the list of isometries
  double weight = 1;           ///< finite; the energy is convex if all are positive
};

class HarmonicEnergy;

/// The harmonic energy at one map: a value of its own, in the charts that there were.
class HarmonicAt final : public solver::Evaluation {
 public:
  explicit HarmonicAt(const HarmonicEnergy& energy);

  bool is_of(const HarmonicEnergy& energy) const { return energy_ == &energy; }
  std::span<const double> gradient() const override { return gradient_; }
  double value() const override { return value_; }
  void hessian_values(std::span<double> values) const override;
  void hessian_times(std::span<const double> v, std::span<double> Hv) const override;
  void hessian_diagonal_blocks(std::size_t block_size, std::span<double> blocks) const override;

 private:
  friend class HarmonicEnergy;
  using Vector4 = geometry::Vector4;

  struct Place {
    Vector4 point;
    std::array<Vector4, 3> tangent;  // derivatives by u
    double time;                     // sqrt(1 + |u|^2)
  };
  bool move_to(std::span<const double> x, solver::Order order);
  void place(std::span<const double> x);
  template <class Add>
  void for_entries(Add&& add) const;

  const HarmonicEnergy* energy_;
  double value_ = 0;
  std::vector<double> gradient_;
  std::vector<Place> places_;                    // [V]
  std::vector<geometry::Vector3> u_;             // [V]
  std::vector<std::array<double, 9>> diagonal_;  // [V] blocks of the Hessian
  std::vector<std::array<double, 9>> across_;    // [edges] rows of a, columns of b
  std::vector<double> bend_;              // [V] sum of w phi' times -<base point, other point>
  mutable std::vector<double> in_, out_;  // [3 V] of hessian_times
};

/// The harmonic energy of an equivariant map into hyperbolic space,
///     E(f) = 1/2 sum over edges ab of w_ab d(f_a, g_ab f_b)^2,
/// for positive weights convex along geodesics, and strictly so if its minimiser is no geodesic or
/// point. Points may be held to planes (those of the geodesic boundary), in which they slide.
///
/// The variables are charts around base points: f_v = B_v (u, sqrt(1 + |u|^2)) with an isometry B_v
/// that takes the origin to the base point of v, and u of three numbers, or of two in the plane.
/// This covers all of space, gradient and Hessian are exact everywhere, and at u = 0 the Hessian is
/// that of the hyperbolic metric: for positive weights positive semidefinite, with eigenvalues 1
/// along an edge and d coth d across it. `recentre` moves the base points there. Off u = 0 the
/// Hessian in the chart may be indefinite, as charts bend. Source: docs/parameterise.md (P2) to
/// (P4).
class HarmonicEnergy final : public solver::Problem {
 public:
  using Matrix4 = geometry::Matrix4;
  using Vector4 = geometry::Vector4;

  /// isometries  what HarmonicEdge::isometry counts; the first is the identity
  /// points      [V] of the hyperboloid, to begin with
  /// poles       [V] unit spacelike; the zero vector for points that are free. Points are taken to
  ///             the nearest point of their plane.
  /// Throws InvalidInput, naming the place, for indices out of range, weights that are not
  /// finite, and lists of different lengths.
  HarmonicEnergy(std::vector<HarmonicEdge> edges, std::vector<Matrix4> isometries,
                 std::span<const Vector4> points, std::span<const Vector4> poles);

  std::size_t dimension() const override { return first_.back(); }
  bool evaluate(std::span<const double> x, solver::Order order,
                std::unique_ptr<solver::Evaluation>& into) const override;
  const solver::SparsityPattern& hessian_pattern() const override;

  std::size_t point_count() const { return first_.size() - 1; }
  /// First variable of a point; it has two in a plane and three otherwise.
  std::size_t first_variable(std::size_t v) const { return first_[v]; }
  bool is_free(std::size_t v) const { return first_[v + 1] - first_[v] == 3; }
  /// The isometry that takes the plane z = 0 to the plane of a point that is not free.
  const Matrix4& plane(std::size_t v) const { return planes_[v]; }
  std::span<const HarmonicEdge> edges() const { return edges_; }
  std::span<const Matrix4> isometries() const { return isometries_; }

  /// The points of the hyperboloid [V] at x.
  std::vector<Vector4> points(std::span<const double> x) const;
  /// Makes the points at x the base points; they are at 0 then.
  void recentre(std::span<const double> x);
  /// Makes these points [V] the base points, or the nearest ones of their planes.
  void rebase(std::span<const Vector4> points);

 private:
  friend class HarmonicAt;
  std::size_t width(std::size_t v) const { return first_[v + 1] - first_[v]; }

  std::vector<HarmonicEdge> edges_;
  std::vector<Matrix4> isometries_;
  std::vector<std::uint32_t> first_;  // [V + 1]
  std::vector<Matrix4> planes_;  // [V] takes the plane z = 0 to that of v; the identity if free
  std::vector<geometry::Vector3> base_;  // [V] in that frame, spatial coordinates
  std::vector<Matrix4> frames_;          // [V] B
  LazyElementPattern pattern_;
};

/// The derivatives of phi(c) = (arcosh c)^2 / 2 at c = cosh d: d / sinh d, and
/// (1 - d coth d) / sinh^2 d; both keep their digits at d = 0.
std::array<double, 2> half_square_derivatives(double d);

}  // namespace tripus::energies
