#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "drawing/drawing.hpp"

// The chord of a curve that stays in a disc stays in it, so the polylines meet nowhere but in the
// discs of crossings, where one is above the plane and the other below.

namespace tripus::drawing {
namespace {

/// Points to a piece: one for so many radians that it turns.
constexpr double kTurnAPoint = std::numbers::pi / 5;
/// How far over-strands rise, in radii of the crossing's disc.
constexpr double kRise = 0.7;

int steps_of(const StrandPiece& piece) {
  const double turn = piece.curve.radius == 0 ? 0 : piece.curve.length() / piece.curve.radius;
  const int steps = 1 + static_cast<int>(turn / kTurnAPoint);
  return piece.level == Level::kPlane ? steps : std::max(4, steps + steps % 2);
}

}  // namespace

std::string to_polylines(const topology::Diagram& diagram) {
  const Drawing drawing = draw(diagram);
  const double size = std::max(
      {drawing.high.real() - drawing.low.real(), drawing.high.imag() - drawing.low.imag(), 1e-9});
  const auto point = [&](Point p, double z) {
    const Point q = (p - drawing.low) * (10 / size);
    return fmt::format("[{:.6f}, {:.6f}, {:.6f}]", q.real(), q.imag(), z * 10 / size);
  };
  std::string text = "{\"vertices\": [";
  for (std::size_t v = 0; v < drawing.vertices.size(); ++v)
    text += (v == 0 ? "" : ", ") + point(drawing.vertices[v], 0);
  text += "],\n \"edges\": [";
  for (std::size_t s = 0; s < drawing.strands.size(); ++s) {
    const DrawnStrand& strand = drawing.strands[s];
    std::vector<std::string> points{point(strand.pieces.front().curve.from, 0)};
    for (const StrandPiece& piece : strand.pieces) {
      const int steps = steps_of(piece);
      const double rise = piece.level == Level::kPlane  ? 0
                          : piece.level == Level::kOver ? kRise
                                                        : -kRise;
      const double height = rise == 0 ? 0 : rise * drawing.crossings[piece.node].radius;
      for (int i = 1; i <= steps; ++i) {
        const double t = double(i) / steps;
        points.push_back(point(i == steps ? piece.curve.to : piece.curve.at(t),
                               height * std::sin(std::numbers::pi * t)));
      }
    }
    if (strand.closed) points.back() = points.front();
    text += s == 0 ? "\n  [" : ",\n  [";
    for (std::size_t i = 0; i < points.size(); ++i) text += (i == 0 ? "" : ", ") + points[i];
    text += "]";
  }
  return text + "],\n \"outer\": \"automatic\"}\n";
}

}  // namespace tripus::drawing
