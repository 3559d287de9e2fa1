#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "energies/element_pattern.hpp"
#include "geometry/batch.hpp"
#include "solver/problem.hpp"
#include "topology/cone_angle.hpp"
#include "topology/triangulation.hpp"
#include "topology/vertex_kinds.hpp"

namespace tripus::energies {

class CoVolume;

/// The co-volume functional at given edge lengths: a value of its own.
class CoVolumeAt final : public solver::Evaluation {
 public:
  explicit CoVolumeAt(const CoVolume& energy) : energy_(&energy) {}

  bool is_of(const CoVolume& energy) const { return energy_ == &energy; }
  const CoVolume& energy() const { return *energy_; }
  /// False where the lengths are not finite, and with finite vertices where some tetrahedron is not
  /// a true one. Then nothing below means anything.
  bool is_defined() const { return is_defined_; }
  /// The edge lengths [E].
  std::span<const double> lengths() const { return {memory(), energy_dimension()}; }

  /// -K, the edge curvatures [E].
  std::span<const double> gradient() const override {
    return {memory() + energy_dimension(), energy_dimension()};
  }
  double value() const override;
  void hessian_values(std::span<double> values) const override;
  bool dense_hessian(std::span<double> lower) const override;
  void hessian_times(std::span<const double> v, std::span<double> Hv) const override;
  void hessian_diagonal_blocks(std::size_t block_size, std::span<double> blocks) const override;

  /// Dihedral angles [6] of tetrahedron t.
  std::array<double, 6> dihedral_angles(std::size_t t) const;
  /// Number of flat tetrahedra, and which they are.
  std::size_t flat_count() const { return flat_count_; }
  std::vector<std::size_t> flat_tetrahedra() const;
  /// Sum of the volumes of the tetrahedra.
  double volume() const;
  /// A lower bound of the least eigenvalue of the Hessian, of the second order only: min_e valence
  /// * min_t 1 / |J_t^-1| (Frobenius norm) with the Jacobians J_t of the tetrahedra that are not
  /// flat. It is a bound on all of R^E if there are no flat ones, and 0 where a Jacobian is not
  /// positive definite. Source: docs/theory.md (40), (49).
  double convexity_bound() const;

 private:
  friend class CoVolume;

  void move_to(std::span<const double> x, solver::Order order);
  bool angles(std::size_t first_block, std::size_t count, const double* lengths,
              bool second_derivatives);
  double volume_of(std::span<const double, 6> theta) const;
  bool finite_angles(std::size_t first_block, std::size_t count, const double* lengths,
                     bool second_derivatives);
  void flatten(std::size_t first_block, std::size_t last_block, bool second_derivatives);
  std::size_t energy_dimension() const;
  double* memory() { return many_.empty() ? few_.data() : many_.data(); }
  const double* memory() const { return many_.empty() ? few_.data() : many_.data(); }
  double* theta_block(std::size_t b) { return memory() + theta_ + 6 * geometry::kLanes * b; }
  const double* theta_block(std::size_t b) const {
    return memory() + theta_ + 6 * geometry::kLanes * b;
  }
  double* jacobian_block(std::size_t b) {
    return memory() + jacobian_ + geometry::kPackedJacobian * geometry::kLanes * b;
  }
  const double* jacobian_block(std::size_t b) const {
    return memory() + jacobian_ + geometry::kPackedJacobian * geometry::kLanes * b;
  }
  /// Entry q of the packed Jacobian of tetrahedron t.
  double jacobian_entry(std::size_t t, std::size_t q) const {
    return jacobian_block(t / geometry::kLanes)[q * geometry::kLanes + t % geometry::kLanes];
  }

  const CoVolume* energy_;
  /// x [E], the gradient [E], the angles [T/8][6][8], and of the second order the Jacobians
  /// [T/8][21][8]. Small manifolds are solved in microseconds: up to 8 tetrahedra with 48 edge
  /// classes take no memory but this object's.
  std::array<double, (6 + geometry::kPackedJacobian) * geometry::kLanes + 2 * 48> few_;
  std::vector<double> many_;
  std::size_t theta_ = 0, jacobian_ = 0;  // where these begin
  std::size_t flat_count_ = 0;
  bool is_defined_ = false;
};

/// The co-volume functional of a triangulation in its edge lengths x [E],
///     H(x) = sum_t cov(x|t) - sum_e k_e x_e,     grad H = -K,
/// convex and C1 on all of R^E; its critical point is the hyperbolic metric with cone angles k_e.
/// Smooth and strictly convex where no tetrahedron is flat.
///
/// Vertices may be ideal: then H is constant along one direction a cusp, which moves its
/// horosphere, and strictly convex across these directions. A parabolic edge (cone angle 0) keeps
/// the length 0: start there, and no method leaves it. With finite vertices H is defined where
/// every tetrahedron is a true one (`evaluate` returns false elsewhere), and it is not convex.
/// Source: docs/theory.md sections 4 and 9.
class CoVolume final : public solver::Problem {
 public:
  /// Keeps a reference to the triangulation, which must outlive it.
  /// cone_angles: [E] radians, >= 0 and finite; empty for 2 pi everywhere.
  /// Throws InvalidInput for a wrong number of cone angles or an angle out of range.
  explicit CoVolume(const topology::Triangulation& triangulation,
                    std::span<const topology::ConeAngle> cone_angles = {});

  /// The functional of `at` with these tetrahedra taken for flat at all lengths, with angle pi at
  /// that pair of opposite edges where `at` has the largest angles. It is convex, nowhere above H,
  /// and equal to it where these tetrahedra are flat: a minimiser of it where they are is one of H.
  /// Source: docs/theory.md (54').
  ///   flat  indices < T, ascending
  CoVolume(const CoVolumeAt& at, std::vector<std::size_t> flat);

  std::size_t dimension() const override { return triangulation_.edge_count(); }
  bool evaluate(std::span<const double> x, solver::Order order,
                std::unique_ptr<solver::Evaluation>& into) const override;
  /// The functional at x [E]; ask whether it is defined there.
  CoVolumeAt at(std::span<const double> x, solver::Order order = solver::Order::kFirst) const;
  const solver::SparsityPattern& hessian_pattern() const override { return slots().pattern(); }
  std::span<const std::uint32_t> pins() const override { return pins_; }

  std::span<const double> cone_angles() const { return cone_angles_; }
  /// The vertex links [V] with the cone points.
  std::span<const topology::OrbifoldLink> links() const { return links_; }
  /// Whether every vertex is hyperideal; then there is nothing of section 10 in H.
  bool is_hyperideal() const { return form_ == Form::kHyperideal; }
  /// Whether edge class e joins hyperideal vertices, so that its length is > 0 in a metric.
  bool is_between_hyperideal(std::size_t e) const;

 private:
  friend class CoVolumeAt;

  /// Which kernel computes the angles, chosen once.
  enum class Form { kHyperideal, kIdeal, kMixed, kFinite };

  const ElementPattern& slots() const;

  const topology::Triangulation& triangulation_;
  const geometry::BatchKernels& kernels_;
  std::vector<double> cone_angles_;  // [E]
  std::vector<topology::OrbifoldLink> links_;
  Form form_ = Form::kHyperideal;
  std::vector<double> diagonal_;      // [T/8][4][8] of the Gram matrices; empty if all are 1
  std::vector<std::uint32_t> pins_;   // an edge class for each ideal vertex
  std::vector<std::size_t> held_;     // tetrahedra held flat
  std::vector<std::size_t> held_pi_;  // the first of the two edges of each that have angle pi
  LazyElementPattern pattern_;
};

inline std::size_t CoVolumeAt::energy_dimension() const { return energy_->dimension(); }

}  // namespace tripus::energies
