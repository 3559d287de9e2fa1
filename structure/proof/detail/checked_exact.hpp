#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "structure/proof/detail/checked_field.hpp"
#include "structure/proof/tilt_signs.hpp"
#include "topology/triangulation.hpp"
#include "topology/vertex_kinds.hpp"

namespace tripus::structure::detail {

/// The cofactors of a tetrahedron's Gram matrix, and D = -det G.
template <class N>
struct CheckedCofactors {
  std::array<std::array<N, 4>, 4> c;
  N D;
};

/// Checks that the numbers of a field are the Gram entries of a metric, theory 9.7: its equations
/// are multiplied out, with the square roots that the proof names and none that are guessed.
class CheckedExact {
 public:
  CheckedExact(const topology::Triangulation& triangulation,
               std::span<const topology::ConeAngle> cone_angles,
               std::span<const topology::OrbifoldLink> links, const ExactField& text);
  CheckedExact(const CheckedExact&) = delete;  // numbers point to the field
  CheckedExact& operator=(const CheckedExact&) = delete;

  /// What does not hold; empty if all does.
  std::string refusal();

  /// After `refusal` was empty: whether the terms of the tilts across face f of tetrahedron t that
  /// belong to vertices of one kind, hyperideal or ideal, add up to exactly 0.
  bool sum_is_zero(std::size_t t, int f, topology::VertexKind kind) const;
  /// The same numbers as balls, and what the terms of an ideal vertex class are multiplied by.
  CheckedCofactors<Arb> cofactors(std::size_t t) const;
  Arb horosphere(std::size_t v) const { return horosphere_[v].value(); }
  /// Whether the horospheres of cusps are known.
  bool has_horospheres() const { return has_horospheres_; }
  /// a = -G_ij of an edge class, as a ball.
  Arb gram(std::size_t e) const { return gram_[e].value(); }

 private:
  const topology::OrbifoldLink& link(std::size_t t, int v) const {
    return links_[triangulation_.vertex_class(t, v)];
  }
  long diagonal(std::size_t t, int v) const {
    return link(t, v).kind == topology::VertexKind::kHyperideal ? 1 : 0;
  }
  CheckedNumber number(long n) const { return {field_, RationalPolynomial(n)}; }

  std::string read_field();
  std::string read_entries();
  std::string read_tetrahedron(std::size_t t);
  std::string read_root(std::size_t t);
  std::string check_edge(std::size_t e);
  std::string read_horospheres();
  CheckedNumber row_sum(std::size_t t, int f, topology::VertexKind kind) const;

  const topology::Triangulation& triangulation_;
  std::span<const topology::ConeAngle> cone_angles_;
  std::span<const topology::OrbifoldLink> links_;
  const ExactField& text_;
  CheckedField field_;
  std::vector<CheckedNumber> gram_;                          // [E]
  std::vector<CheckedCofactors<CheckedNumber>> tetrahedra_;  // [T]
  std::vector<CheckedNumber> root_;                          // [T] sqrt D
  std::vector<std::size_t> generator_;                       // tetrahedra whose sqrt D was adjoined
  std::vector<CheckedNumber> horosphere_;                    // [V]
  bool has_horospheres_ = true;
  long height_, bits_;
};

}  // namespace tripus::structure::detail
