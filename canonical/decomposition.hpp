#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "canonical/tilts.hpp"
#include "topology/gluings.hpp"

namespace tripus::canonical {

using FlagIndex = std::uint32_t;
inline constexpr FlagIndex kNoFlag = std::numeric_limits<FlagIndex>::max();

/// A decomposition into polyhedra that are glued along whole faces, as a set of flags.
///
/// A flag is a vertex, an edge at it, a face at the edge and a cell at the face, all as seen from
/// inside that cell. There are four fixed-point-free involutions: step(0) changes the vertex
/// alone, step(1) the edge, step(2) the face, step(3) the cell. They determine the decomposition
/// up to isomorphism, and an isomorphism of connected ones is determined by the image of one flag.
/// Source: docs/canonical.md section 3.
class Decomposition {
 public:
  /// Merges tetrahedra across transparent faces, and triangles of true faces that lie in one plane.
  /// Which do is read off the combinatorics: an edge class with exactly two true faces around it
  /// lies inside a polygon. Faces must not be concave. An edge class whose cone angle is not 2 pi
  /// stays an edge in any case: it cuts the polygon in which it lies.
  ///   cone_angles  [E]; empty for 2 pi everywhere
  /// Throws InternalError if an edge class has exactly one true face: the signs are wrong. Throws
  /// InvalidInput if `edge_inside_cell` finds one.
  Decomposition(const topology::Gluings& gluings, const FaceKinds& faces,
                std::span<const topology::ConeAngle> cone_angles = {});

  std::size_t flag_count() const { return vertex_.size(); }
  std::size_t cell_count() const { return cell_start_.size(); }
  FlagIndex step(int i, FlagIndex flag) const { return step_[static_cast<std::size_t>(i)][flag]; }

  std::uint32_t cell(FlagIndex flag) const { return cell_[flag]; }
  /// The vertex of the flag among those of its cell, from 0.
  std::uint32_t vertex(FlagIndex flag) const { return vertex_[flag]; }
  /// A flag of the cell, the first.
  FlagIndex first_flag(std::size_t cell) const { return cell_start_[cell]; }
  /// The vertex class of the triangulation, that is the boundary component, at the flag's vertex.
  std::uint32_t boundary_component(FlagIndex flag) const { return component_[flag]; }

  /// The cone angle of the flag's edge, as a place in `cone_angles`; 0 if there are no labels.
  std::uint32_t label(FlagIndex flag) const { return label_.empty() ? 0 : label_[flag]; }
  /// The cone angles that occur, descending; empty if there are no labels.
  const std::vector<topology::ConeAngle>& cone_angles() const { return cone_angles_; }

  bool is_orientable() const { return orientable_; }
  /// False for flags of the orientation that makes tetrahedron 0 with labels 0123 positive. Steps
  /// change it; meaningless if not orientable.
  bool is_negative(FlagIndex flag) const { return negative_[flag]; }

 private:
  friend class FlagBuilder;
  std::array<std::vector<FlagIndex>, 4> step_;  // [4][F]
  std::vector<std::uint32_t> cell_, vertex_, component_;
  std::vector<std::uint32_t> label_;  // [F], or empty
  std::vector<topology::ConeAngle> cone_angles_;
  std::vector<FlagIndex> cell_start_;
  std::vector<char> negative_;
  bool orientable_ = true;
};

/// An edge class with a cone angle other than 2 pi that no true face meets: it goes through the
/// inside of a cell, which then is no polyhedron. Nothing if there is none.
std::optional<std::size_t> edge_inside_cell(const topology::Triangulation& triangulation,
                                            const FaceKinds& faces,
                                            std::span<const topology::ConeAngle> cone_angles);

/// Combinatorial type of one cell.
struct CellType {
  std::string name;  ///< tetrahedron, pyramid, octahedron, prism, ..., or "polyhedron 5.5.4.3..."
  std::size_t vertex_count = 0;
  std::vector<std::size_t> face_sizes;  ///< ascending

  friend bool operator==(const CellType&, const CellType&) = default;
};
CellType cell_type(const Decomposition& decomposition, std::size_t cell);

/// Whether a text may be CellType::name.
bool is_cell_type_name(std::string_view text);
/// "tetrahedron, pyramid, ..., polyhedron 5.5.4": for messages.
std::string known_cell_names();

/// "4 tetrahedra", "1 octahedron", "2 tetrahedra + 1 pyramid": by name.
std::string describe_cells(const Decomposition& decomposition);

}  // namespace tripus::canonical
