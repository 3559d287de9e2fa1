#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "energies/element_pattern.hpp"
#include "solver/problem.hpp"
#include "topology/triangulation.hpp"

namespace tripus::energies {

class VolumeInAngles;

/// The volume functional at given angles: a value of its own.
class VolumeInAnglesAt final : public solver::Evaluation {
 public:
  explicit VolumeInAnglesAt(const VolumeInAngles& energy);

  bool is_of(const VolumeInAngles& energy) const { return energy_ == &energy; }

  /// Mismatches of lengths [6 T - E].
  std::span<const double> gradient() const override { return gradient_; }
  double value() const override;
  void hessian_values(std::span<double> values) const override;
  void hessian_times(std::span<const double> v, std::span<double> Hv) const override;
  void hessian_diagonal_blocks(std::size_t block_size, std::span<double> blocks) const override;

  /// Dihedral angles [T x 6].
  std::span<const double> dihedral_angles() const { return theta_; }
  /// For each edge class the mean of the lengths of its corners [E].
  std::vector<double> mean_edge_lengths() const;

 private:
  friend class VolumeInAngles;

  bool move_to(std::span<const double> y, solver::Order order);
  /// Calls add(variable a, variable b, entry) for all ordered pairs of variables of all tetrahedra.
  template <class Add>
  void for_entries(Add&& add) const;

  const VolumeInAngles* energy_;
  std::vector<double> gradient_;
  std::vector<double> theta_;    // [T x 6]
  std::vector<double> length_;   // [T x 6]
  std::vector<double> inverse_;  // [T x 36] d l / d theta, allocated at the first request
};

/// Minus twice the volume, as a function of the dihedral angles of all tetrahedra:
///     f(y) = -2 sum_t vol(theta_t(y)),      theta(y) = theta_0 + B y,
/// strictly convex on the open polytope {theta > 0, vertex sums < pi} with the edge sums of
/// theta_0. The columns of B are a sparse basis of the directions that keep the edge sums: for
/// consecutive corners c, c' around an edge, +1 at c and -1 at c'. By Schlaefli's formula
///     df/dy = l_c - l_c',
/// so at the critical point all corners of an edge class have one length: the metric.
/// Outside of the polytope `evaluate` returns false.
/// Source: docs/theory.md section 4.
class VolumeInAngles final : public solver::Problem {
 public:
  /// Keeps a reference to the triangulation, which must outlive it.
  /// interior: [T x 6] angles in the open polytope; they fix the cone angles.
  /// Throws InvalidInput naming the tetrahedron whose angles are not in it.
  VolumeInAngles(const topology::Triangulation& triangulation, std::span<const double> interior);

  /// 6 T - E: the corners less one an edge class.
  std::size_t dimension() const override { return first_.size(); }
  bool evaluate(std::span<const double> y, solver::Order order,
                std::unique_ptr<solver::Evaluation>& into) const override;
  /// The functional at a y [dimension] of the polytope.
  VolumeInAnglesAt at(std::span<const double> y, solver::Order order = solver::Order::kFirst) const;
  const solver::SparsityPattern& hessian_pattern() const override { return slots().pattern(); }

 private:
  friend class VolumeInAnglesAt;

  const ElementPattern& slots() const;

  const topology::Triangulation& triangulation_;
  std::vector<double> interior_;          // [T x 6]
  std::vector<std::uint32_t> first_;      // [dimension] flat corner 6 t + e with coefficient +1
  std::vector<std::uint32_t> second_;     // [dimension] ... and with -1
  std::vector<std::uint32_t> variables_;  // [T x 12] variables with +1, then -1, at each corner
  LazyElementPattern pattern_;
};

}  // namespace tripus::energies
