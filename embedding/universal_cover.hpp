#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "base/stop.hpp"
#include "embedding/embedding.hpp"

namespace tripus::embedding {

inline constexpr std::uint32_t kNoCell = 0xffffffffu;

/// No universal cover is grown beyond this many cells: a gigabyte.
inline constexpr std::size_t kMostCells = 2'000'000;

/// One tetrahedron of the universal cover.
struct Cell {
  std::uint32_t tetrahedron = 0;  ///< of which it is a copy
  Matrix4 isometry;               ///< from the frame of that tetrahedron to that of the root
  std::uint32_t depth = 0;        ///< faces crossed on the way from the root along the parents
  std::uint32_t parent =
      kNoCell;            ///< the cell beside it from which it was reached; kNoCell: the root
  std::uint8_t face = 0;  ///< of the parent, across which it lies
};

struct UniversalCoverOptions {
  std::size_t max_cells = kMostCells;  ///< 1 to kMostCells
  /// Cells further from the root than this many faces are left out. With this set the order is
  /// breadth-first, `Cell::depth` the least number of faces to cross, and near cells come first
  /// within one depth.
  std::uint32_t max_depth = std::numeric_limits<std::uint32_t>::max();
  /// Only cells none of whose planes separates them from the ball of this radius around the centre
  /// of the root: with them every cell that meets the ball is there.
  double max_radius = std::numeric_limits<double>::infinity();
  std::uint32_t root = 0;  ///< the tetrahedron to begin with; its frame becomes that of space
  Stop stop{};             ///< polled at every cell
};

/// Why the growth ended.
enum class CoverEnd {
  kComplete,     ///< everything within the depth or the radius
  kCells,        ///< max_cells are there
  kInterrupted,  ///< stop
  kPrecision,    ///< so far from the root that double precision no longer tells cells apart
};

struct UniversalCover {
  std::vector<Cell> cells;  ///< the root first, parents before children
  CoverEnd end = CoverEnd::kComplete;
};

/// Grows the universal cover of the manifold from one tetrahedron, each cell once.
///
/// Unless max_depth is set, the next cell is always the one whose centre is nearest to that of the
/// root among those that touch a cell which is already there; so a cover of more cells begins with
/// the cells of a smaller one. Equal distances go by the order of discovery.
///
/// Cells are told apart by where their centres lie: those of different cells are further apart than
/// the sum of their in-radii, whatever symmetries the tetrahedra have (docs/theory.md (73)). Places
/// are products in SL(2,C), whose relative error grows like the depth and not like its exponential
/// (docs/theory.md (62)).
/// O(cells) time but for the queue; some 500 bytes a cell while it runs.
/// Throws InvalidInput for options out of range.
UniversalCover grow_universal_cover(const Embedding& embedding,
                                    const topology::Triangulation& triangulation,
                                    const UniversalCoverOptions& options = {});

/// The cells of `grow_universal_cover` alone.
std::vector<Cell> universal_cover(const Embedding& embedding,
                                  const topology::Triangulation& triangulation,
                                  const UniversalCoverOptions& options = {});

}  // namespace tripus::embedding
