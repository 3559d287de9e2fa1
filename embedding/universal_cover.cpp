#include "embedding/universal_cover.hpp"

#include <algorithm>
#include <cmath>
#include <queue>

#include <fmt/format.h>

#include "base/error.hpp"
#include "embedding/detail/orientations.hpp"
#include "embedding/detail/position_table.hpp"
#include "geometry/moebius.hpp"
#include "topology/covers/presentation.hpp"

namespace tripus::embedding {
namespace {

using geometry::MoebiusMap;
using topology::Triangulation;

/// A cell that has been found; it becomes a Cell when its turn comes.
struct Found {
  MoebiusMap place;
  std::uint32_t tetrahedron;
  std::uint32_t parent;  ///< as a Cell
  std::uint32_t depth;
  std::uint8_t face;
};

struct QueueEntry {
  double key;
  std::uint32_t found;
  /// The greatest comes first in a std::priority_queue: the least key, then the first found.
  friend bool operator<(const QueueEntry& p, const QueueEntry& q) {
    return p.key != q.key ? p.key > q.key : p.found > q.found;
  }
};

/// Half the least distance that the centres of two cells can have: the least distance of a centre
/// to a face of its tetrahedron.
double in_radius(const Embedding& embedding) {
  double least = std::numeric_limits<double>::infinity();
  for (const HyperboloidTetrahedron& tetrahedron : embedding.tetrahedra)
    for (const Vector4& n : tetrahedron.faces) least = std::min(least, std::asinh(n[3]));
  return least;
}

void require_options(const UniversalCoverOptions& options, std::size_t tetrahedron_count) {
  if (options.max_cells < 1 || options.max_cells > kMostCells) {
    throw InvalidInput(
        fmt::format("{} cells of the universal cover were asked for; from 1 to {} "
                    "are possible",
                    options.max_cells, kMostCells));
  }
  if (!(options.max_radius >= 0))
    throw InvalidInput("the radius of the universal cover must be 0 or more");
  if (options.root >= tetrahedron_count) {
    throw InvalidInput(fmt::format("there is no tetrahedron {} to begin with; there are {}",
                                   options.root, tetrahedron_count));
  }
}

void require_tiling(const Embedding& embedding) {
  for (std::size_t e = 0; e < embedding.cone_angles.size(); ++e)
    if (!embedding.cone_angles[e].is_parabolic() &&
        topology::rotation_order(embedding.cone_angles[e]) == 0)
      throw Unsupported(fmt::format(
          "the cone angle around edge class {} is not 2 pi / n for a whole number n, so the cells "
          "overlap and there is no universal cover in hyperbolic space; only a fundamental domain "
          "can be placed",
          e));
}

class Grower {
 public:
  Grower(const Embedding& embedding, const Triangulation& triangulation,
         const UniversalCoverOptions& options)
      : embedding_(embedding),
        gluings_(triangulation.gluings()),
        options_(options),
        by_depth_(options.max_depth != std::numeric_limits<std::uint32_t>::max()),
        sinh_radius_(std::sinh(options.max_radius)),
        separation_(2 * std::sinh(in_radius(embedding))),
        positions_(separation_),
        pairings_(detail::moebius_pairings(embedding, gluings_)) {}

  UniversalCover grow() {
    UniversalCover cover;
    discover({{}, options_.root, kNoCell, 0, 0});
    while (!queue_.empty() && !out_of_precision_) {
      if (cover.cells.size() >= options_.max_cells) {
        cover.end = CoverEnd::kCells;
        return cover;
      }
      if (options_.stop.requested()) {
        cover.end = CoverEnd::kInterrupted;
        return cover;
      }
      const Found next = found_[queue_.top().found];
      queue_.pop();
      const auto number = static_cast<std::uint32_t>(cover.cells.size());
      cover.cells.push_back(
          {next.tetrahedron, geometry::to_matrix(next.place), next.depth, next.parent, next.face});
      expand(next, number);
    }
    if (out_of_precision_) cover.end = CoverEnd::kPrecision;
    return cover;
  }

 private:
  void expand(const Found& cell, std::uint32_t number) {
    if (cell.depth >= options_.max_depth) return;
    for (int f = 0; f < 4; ++f) {
      // No step towards det = 1: far out the determinant is a small difference of large numbers,
      // and would bring its own noise in.
      const MoebiusMap place =
          cell.place * pairings_[cell.tetrahedron][static_cast<std::size_t>(f)];
      discover({place, gluings_.neighbour(cell.tetrahedron, f), number, cell.depth + 1,
                static_cast<std::uint8_t>(f)});
    }
  }

  void discover(const Found& cell) {
    const Vector4 centre = geometry::image_of_origin(cell.place);
    if (!(rounding(centre[3], cell.depth) < separation_ / kSafety)) {
      out_of_precision_ = true;
      return;
    }
    if (!meets_ball(cell)) return;
    const auto number = static_cast<std::uint32_t>(found_.size());
    if (const auto mismatch = positions_.insert(centre.head<3>())) {
      // Two ways to one cell show how large errors really are.
      out_of_precision_ = out_of_precision_ || *mismatch > separation_ / kSafety;
      return;
    }
    found_.push_back(cell);
    // In a depth, 1 - 1/cosh(distance) orders by distance and is less than 1.
    const double key = by_depth_ ? cell.depth + (1 - 1 / centre[3]) : centre[3];
    queue_.push({key, number});
  }

  /// Cells are confused where errors reach a quarter of their separation.
  static constexpr double kSafety = 16;

  /// What rounding alone does to a place at this distance: each of the depth + 1 products adds a
  /// few ulp relatively.
  static double rounding(double cosh_distance, std::uint32_t depth) {
    return 8 * std::numeric_limits<double>::epsilon() * (depth + 1.0) * cosh_distance;
  }

  /// Whether no plane of the cell separates it from the ball: sinh of the distance from the root's
  /// centre to a plane, positive outside, is its product with the normal.
  bool meets_ball(const Found& cell) const {
    if (std::isinf(sinh_radius_)) return true;
    const Vector4 eye = geometry::image_of_origin(geometry::inverse(cell.place));
    const HyperboloidTetrahedron& tetrahedron = embedding_.tetrahedra[cell.tetrahedron];
    for (std::size_t i = 0; i < 4; ++i) {
      if (geometry::lorentz_product(eye, tetrahedron.faces[i]) > sinh_radius_ ||
          (tetrahedron.is_hyperideal(i) &&
           geometry::lorentz_product(eye, tetrahedron.vertices[i]) > sinh_radius_))
        return false;
    }
    return true;
  }

  const Embedding& embedding_;
  const topology::Gluings& gluings_;
  const UniversalCoverOptions& options_;
  const bool by_depth_;
  const double sinh_radius_;
  const double separation_;
  detail::PositionTable positions_;
  std::vector<std::array<MoebiusMap, 4>> pairings_;
  std::vector<Found> found_;
  std::priority_queue<QueueEntry> queue_;
  bool out_of_precision_ = false;
};

}  // namespace

UniversalCover grow_universal_cover(const Embedding& embedding, const Triangulation& triangulation,
                                    const UniversalCoverOptions& options) {
  require_options(options, triangulation.tetrahedron_count());
  require_tiling(embedding);
  return Grower(embedding, triangulation, options).grow();
}

std::vector<Cell> universal_cover(const Embedding& embedding, const Triangulation& triangulation,
                                  const UniversalCoverOptions& options) {
  return grow_universal_cover(embedding, triangulation, options).cells;
}

}  // namespace tripus::embedding
