#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/context.hpp"
#include "base/error.hpp"
#include "orthospectrum/sums.hpp"
#include "topology/triangulation.hpp"

/// The orthospectrum: the geodesic arcs that meet the boundary at right angles at both ends.
namespace tripus::orthospectrum {

/// The truncation triangle of a vertex of a tetrahedron, a tile of the boundary.
struct Tile {
  std::uint32_t tetrahedron = 0;
  std::uint32_t vertex = 0;
  friend auto operator<=>(const Tile&, const Tile&) = default;
};

/// One end of an arc: where it meets the boundary, in the projective model of the tile's plane with
/// the middle of the tile at the origin (see BoundaryTile).
struct ArcEnd {
  Tile tile;
  double x = 0, y = 0;
};

inline constexpr std::uint32_t kNoEdge = 0xffffffffu;

/// One arc, unoriented: it is listed from the end whose tile is less (then the foot).
struct Arc {
  double length = 0;
  ArcEnd start, end;
  std::uint32_t edge = kNoEdge;  ///< the edge class that it is, or kNoEdge
  std::uint32_t face_count = 0;
  std::uint64_t first_face = 0;  ///< into Spectrum::faces
};

/// Which arcs to find.
struct SpectrumOptions {
  double length = 0;        ///< all arcs up to this length; > 0, at most kLongestArc. Or 0 and
  std::size_t count = 0;    ///< so many of the shortest, with all of the length of the last
  bool keep_arcs = true;    ///< otherwise sums and counts only, in memory that does not grow
  bool keep_faces = false;  ///< the faces that each arc crosses
  double most_arcs = 1e9;   ///< if there would be about so many, TooManyArcs is thrown early on
};

/// Feet of longer arcs are too near to one another for double precision.
inline constexpr double kLongestArc = 20;

enum class SpectrumEnd { kComplete, kInterrupted, kTimeLimit };

struct Spectrum {
  /// All arcs up to this length are there. After an interruption it is less than what was asked
  /// for.
  double length = 0;
  SpectrumEnd end = SpectrumEnd::kComplete;
  std::uint64_t arc_count = 0;
  std::vector<Arc> arcs;            ///< by length; empty unless kept
  std::vector<std::uint8_t> faces;  ///< of all arcs, see Arc; empty unless kept
  Sums sums;
  std::uint64_t windows = 0;  ///< bundles followed, for those who ask what it cost
};

/// The arcs would be too many.
class TooManyArcs : public InvalidInput {
 public:
  explicit TooManyArcs(double length, double estimate);
  double length, estimate;
};

/// Finds the orthospectrum of the metric with these edge lengths [E] by unfolding from every tile
/// of the boundary: no arc is missed and none found twice. The result does not depend on threads.
/// O(arcs) time. The search is repeated for growing lengths, so an interruption leaves what is
/// complete; the progress tells of each length. Lengths are as good as the metric: to 1e-10 at
/// length 15. Throws InvalidInput for options out of range, a wrong number of lengths and flat
/// tetrahedra, and TooManyArcs. Source: docs/orthospectrum.md.
Spectrum orthospectrum(const topology::Triangulation& triangulation,
                       std::span<const double> edge_lengths, const SpectrumOptions& options,
                       const Context& context = {});

/// A fingerprint of the manifold: the lengths of its `count` shortest arcs, ascending, each as
/// often as there are arcs. Manifolds that are not isometric may share all of them. Throws as
/// `orthospectrum`; fewer lengths only after a stop.
std::vector<double> shortest_lengths(const topology::Triangulation& triangulation,
                                     std::span<const double> edge_lengths, std::size_t count,
                                     const Context& context = {});

/// Arcs of one length between the same boundary components.
struct ArcGroup {
  double length = 0;
  std::array<std::uint32_t, 2> ends{};      ///< boundary components, ascending
  std::size_t first = 0, multiplicity = 0;  ///< where in `order`
};

/// The arcs of a spectrum in groups.
struct Grouping {
  std::vector<ArcGroup> groups;    ///< by length, then by ends
  std::vector<std::size_t> order;  ///< [arcs] indices of arcs, group by group
};

/// Lengths that follow one another within tolerance::kSameArcLength are one.
Grouping group_arcs(const Spectrum& spectrum, const topology::Triangulation& triangulation);

/// The length of an arc by another route: the base plane is carried along `faces` by the face
/// pairings, as products with the four vertices of each tetrahedron. With `start` and `end` it is
/// all that the arc's two poles are; interval arithmetic can take the same way.
/// Returns cosh of the length.
double cosh_along(const topology::Triangulation& triangulation,
                  std::span<const double> edge_lengths, Tile start,
                  std::span<const std::uint8_t> faces, Tile end);

}  // namespace tripus::orthospectrum
