#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "structure/proof/detail/arb_number.hpp"
#include "structure/proof/detail/precise_tetrahedron.hpp"
#include "topology/cone_angle.hpp"
#include "topology/triangulation.hpp"
#include "topology/vertex_kinds.hpp"

namespace tripus::structure::detail {

/// What is asked of the lengths of a triangulation with cone angles: the kinds of the vertices, the
/// angles wanted around the edges, and which lengths are free. docs/theory.md 9.3 and 9.6.
class ConeMetric {
 public:
  /// Throws InvalidInput as topology::require_solvable.
  ConeMetric(const topology::Triangulation& triangulation,
             std::vector<topology::ConeAngle> cone_angles);

  const topology::Triangulation& triangulation() const { return triangulation_; }
  const std::vector<topology::ConeAngle>& cone_angles() const { return cone_angles_; }

  /// The diagonal of the Gram matrix: 1 at a hyperideal vertex, 0 at an ideal one.
  Diagonal diagonal(std::size_t t) const;
  /// The angle wanted around an edge class, at the thread's precision.
  Arb target(std::size_t e) const;
  /// A parabolic edge: its length is 0 and stays so.
  bool is_fixed(std::size_t e) const { return cone_angles_[e].is_parabolic(); }
  /// Why there is no such metric although floating point sees a cusp: cone angles at it that are no
  /// known fractions of pi do not add up to what a cusp needs. Empty if all cusps are exact.
  std::string inexact_cusp() const;
  /// The vertex classes at the ends of an edge class.
  std::array<std::uint32_t, 2> ends(std::size_t e) const;
  /// Whether an end is ideal, or one finite and the other hyperideal: such a length may be any real
  /// number.
  bool may_be_negative(std::size_t e) const { return any_sign_[e]; }
  /// Whether every tetrahedron is strictly convex in all its lengths.
  bool is_strictly_convex() const { return strictly_convex_; }
  /// Radii are claimed wider than proved by this factor, so that other code, with other bounds for
  /// the weights, can follow: at cusps it may hold other edges.
  double margin() const { return strictly_convex_ ? 1 + 0x1p-4 : 4; }
  bool has_finite_vertex() const { return finite_vertex_; }
  bool is_ideal(std::size_t v) const { return kinds_[v] == topology::VertexKind::kIdeal; }
  bool is_finite(std::size_t v) const { return kinds_[v] == topology::VertexKind::kFinite; }
  /// An edge class for each cusp: with their lengths fixed no horosphere can move.
  const std::vector<std::size_t>& pins() const { return pins_; }
  /// The same without some edge classes [E]; fewer where the others do not hold all horospheres.
  std::vector<std::size_t> pins_without(const std::vector<bool>& excluded) const;

 private:
  bool is_any_sign(std::size_t e) const;

  const topology::Triangulation& triangulation_;
  std::vector<topology::ConeAngle> cone_angles_;  // [E]
  std::vector<topology::VertexKind> kinds_;       // [V]
  std::vector<bool> any_sign_;                    // [E] of the length
  std::vector<std::size_t> pins_;
  bool strictly_convex_ = true;
  bool finite_vertex_ = false;
};

/// Moves the horospheres of lengths [E] to one common area, structure::kHorosphereArea. The areas
/// are sums of Euclidean triangles, docs/theory.md (80).
void equalise_horospheres(const ConeMetric& metric, std::vector<Arb>& lengths);

}  // namespace tripus::structure::detail
