#include "drawing/drawing.hpp"

#include <algorithm>
#include <cmath>

namespace tripus::drawing {
namespace {

using topology::Dart;
using topology::Diagram;

Point unit(Point z) { return z / std::abs(z); }

/// Where two discs touch.
Point contact(const Disc& a, const Disc& b) {
  return a.centre + (b.centre - a.centre) * (a.radius / (a.radius + b.radius));
}

/// Between two points of a disc's rim, at right angles to it.
Curve across(const Disc& disc, Point from, Point to) {
  const Point u = unit(from - disc.centre), v = unit(to - disc.centre);
  const double cosine = std::real(std::conj(u) * v);
  constexpr double kStraight = 1e-9;
  if (1 + cosine < kStraight) return {from, to, {}, 0};
  return {from, to, disc.centre + disc.radius * (u + v) / (1 + cosine),
          disc.radius * std::sqrt((1 - cosine) / (1 + cosine))};
}

/// A strand through the discs of its arcs and nodes.
class StrandPath {
 public:
  StrandPath(const Diagram& diagram, const CircleLayout& layout)
      : diagram_(&diagram), layout_(&layout) {}

  DrawnStrand follow(const topology::Strand& strand) const {
    DrawnStrand drawn;
    drawn.closed = strand.closed;
    const Dart first = strand.darts.front();
    if (!diagram_->is_at_crossing(first)) spoke(drawn, first, false);
    for (const Dart d : strand.darts) {
      along_arc(drawn, d);
      const Dart end = diagram_->mate(d);
      if (diagram_->is_at_crossing(end))
        through(drawn, end);
      else
        spoke(drawn, end, true);
    }
    return drawn;
  }

 private:
  const Disc& node_disc(Dart d) const { return layout_->nodes[diagram_->node(d)]; }
  Point rim(Dart d) const { return contact(node_disc(d), layout_->arcs[d].front()); }

  /// Between the rim and a vertex; at one of degree 2, half of the way through, without a corner.
  void spoke(DrawnStrand& drawn, Dart d, bool inwards) const {
    Curve curve{rim(d), node_disc(d).centre, {}, 0};
    if (diagram_->degree(diagram_->node(d)) == 2) {
      curve = across(node_disc(d), rim(d), rim(diagram_->next(d)));
      curve.to = curve.at(0.5);
    }
    if (!inwards) std::swap(curve.from, curve.to);
    drawn.pieces.push_back({curve, Level::kPlane, 0});
  }
  void through(DrawnStrand& drawn, Dart in) const {
    const Level level = diagram_->is_under(in) ? Level::kUnder : Level::kOver;
    drawn.pieces.push_back(
        {across(node_disc(in), rim(in), rim(diagram_->across(in))), level, diagram_->node(in)});
  }
  void along_arc(DrawnStrand& drawn, Dart d) const {
    const std::vector<Disc>& discs = layout_->arcs[d];
    Point from = rim(d);
    for (std::size_t i = 0; i < discs.size(); ++i) {
      const Point to =
          i + 1 < discs.size() ? contact(discs[i], discs[i + 1]) : rim(diagram_->mate(d));
      drawn.pieces.push_back({across(discs[i], from, to), Level::kPlane, 0});
      from = to;
    }
  }

  const Diagram* diagram_;
  const CircleLayout* layout_;
};

/// Beside the curve through the arc's first disc. A curve that bends has more room outside.
ArcLabel label_of(const Diagram& diagram, const CircleLayout& layout, Dart d) {
  const std::vector<Disc>& discs = layout.arcs[d];
  const Disc& disc = discs.front();
  const Point from = contact(layout.nodes[diagram.node(d)], disc);
  const Point to =
      contact(disc, discs.size() > 1 ? discs[1] : layout.nodes[diagram.node(diagram.mate(d))]);
  const Curve curve = across(disc, from, to);
  const Point middle = curve.at(0.5);
  const Point away = curve.radius == 0 ? Point(0, 1) * (to - from) : middle - curve.centre;
  return {diagram.arc(d), middle, unit(away), disc.radius};
}

}  // namespace

Point Curve::at(double t) const {
  if (radius == 0) return from + t * (to - from);
  return centre + (from - centre) * std::polar(1.0, t * std::arg((to - centre) / (from - centre)));
}

double Curve::length() const {
  if (radius == 0) return std::abs(to - from);
  return radius * std::abs(std::arg((to - centre) / (from - centre)));
}

Drawing draw(const Diagram& diagram) {
  const CircleLayout layout = circle_layout(diagram);
  Drawing drawing;
  drawing.names = topology::strands(diagram);
  drawing.crossings = layout.nodes;
  const StrandPath path(diagram, layout);
  for (const topology::Strand& strand : drawing.names.all)
    drawing.strands.push_back(path.follow(strand));
  for (std::size_t n = 0; n < diagram.node_count(); ++n)
    if (!diagram.is_crossing(n) && diagram.degree(n) != 2)
      drawing.vertices.push_back(layout.nodes[n].centre);
  for (Dart d = 0; d < diagram.dart_count(); ++d)
    if (d < diagram.mate(d)) drawing.arcs.push_back(label_of(diagram, layout, d));
  constexpr int kSamples = 8;
  double low_x = 1e300, low_y = 1e300, high_x = -1e300, high_y = -1e300;
  for (const DrawnStrand& strand : drawing.strands)
    for (const StrandPiece& piece : strand.pieces)
      for (int i = 0; i <= kSamples; ++i) {
        const Point p = piece.curve.at(double(i) / kSamples);
        low_x = std::min(low_x, p.real());
        high_x = std::max(high_x, p.real());
        low_y = std::min(low_y, p.imag());
        high_y = std::max(high_y, p.imag());
      }
  drawing.low = {low_x, low_y};
  drawing.high = {high_x, high_y};
  return drawing;
}

// The over-strand divides the disc, and the under-strand goes once from one side to the other.
double crossing_parameter(const Curve& under, const Curve& over) {
  const auto side = [&](double t) {
    const Point p = under.at(t);
    if (over.radius == 0) return std::imag(std::conj(over.to - over.from) * (p - over.from));
    return std::abs(p - over.centre) - over.radius;
  };
  double low = 0, high = 1;
  const bool first = side(0) > 0;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    ((side(middle) > 0) == first ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace tripus::drawing
