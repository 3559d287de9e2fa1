#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "drawing/circle_layout.hpp"
#include "topology/diagrams/diagram.hpp"

namespace tripus::drawing {

/// A piece of a strand: an arc of a circle, at most half of one, or straight.
struct Curve {
  Point from, to;
  Point centre;
  double radius = 0;  ///< 0: straight
  /// Whether the arc turns left on its way.
  bool turns_left() const { return std::imag(std::conj(from - centre) * (to - centre)) > 0; }
  /// The point at 0 <= t <= 1, evenly along the curve.
  Point at(double t) const;
  double length() const;
};

enum class Level : std::uint8_t { kPlane, kOver, kUnder };
struct StrandPiece {
  Curve curve;
  Level level = Level::kPlane;
  std::uint32_t node = 0;  ///< where it is over or under
};

/// A strand of the graph in its direction: consecutive pieces meet in one direction.
struct DrawnStrand {
  std::vector<StrandPiece> pieces;
  bool closed = false;
};

/// Where the number of an arc can stand: beside the middle of its curve, in a disc of its own.
struct ArcLabel {
  std::int64_t arc = 0;
  Point middle;       ///< of the arc's curve in the disc
  Point away;         ///< unit vector to the side on which there is more room
  double radius = 0;  ///< of the disc
};

/// A diagram as smooth curves: in each disc of the layout a strand runs along the circle that meets
/// the disc's rim at right angles, so it has no corners, and two strands of a crossing meet once.
struct Drawing {
  std::vector<DrawnStrand> strands;
  std::vector<Point> vertices;  ///< of the graph; those of degree 2 are not among them
  std::vector<Disc> crossings;  ///< [N] the disc of each node
  topology::Strands names;      ///< which darts the strands have
  std::vector<ArcLabel> arcs;   ///< one for each arc
  Point low, high;              ///< the corners of the picture
};
Drawing draw(const topology::Diagram& diagram);

/// The fraction of an under-strand's way at which the over-strand of its crossing passes above it.
double crossing_parameter(const Curve& under, const Curve& over);

struct SvgOptions {
  double size = 320;       ///< of the longer side, in pixels
  std::string title = {};  ///< what readers of the page hear; none if empty
  bool colours = true;     ///< one for each strand of a graph or component of a link
  bool arcs = false;       ///< with the numbers of the arcs, as the diagram's text names them
};
/// A picture in SVG; under-strands have gaps, cut out and not painted over.
std::string to_svg(const topology::Diagram& diagram, const SvgOptions& options = {});

/// A drawing in space of the same graph: the JSON that `tube` reads, {"vertices": .., "edges": ..}.
/// Over-strands rise above the plane, under-strands dive below it.
std::string to_polylines(const topology::Diagram& diagram);

}  // namespace tripus::drawing
