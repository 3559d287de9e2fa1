// Pictures of diagrams: discs that touch, curves without corners, gaps where they belong.
#include <cmath>
#include <complex>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "drawing/drawing.hpp"
#include "topology/diagrams/random_diagram.hpp"
#include "topology/diagrams/read_diagram.hpp"
#include "topology/diagrams/tables.hpp"

namespace tripus::drawing {
namespace {

using topology::Dart;
using topology::Diagram;

std::vector<Diagram> samples() {
  std::vector<Diagram> all;
  for (const char* name : {"0_1", "3_1", "8_19", "9_40", "L6a4", "0_1 theta", "6_14 theta",
                           "2_1 handcuff", "hk4_1", "hk7_43"})
    all.push_back(topology::find_diagram(name)->diagram);
  all.push_back(topology::read_diagram("X[1,1,2,2]").diagram);
  all.push_back(topology::read_diagram("V[1] V[1,2] V[2]").diagram);
  all.push_back(topology::read_diagram("X[2,1,1,2] V[3,4] V[3,4]").diagram);
  for (std::uint64_t seed = 0; seed < 20; ++seed)
    all.push_back(topology::random_diagram(1 + seed, seed, seed % 3 < 1 + seed ? seed % 3 : 0));
  return all;
}

double gap(const Disc& a, const Disc& b) {
  return std::abs(a.centre - b.centre) - a.radius - b.radius;
}

TEST(CircleLayout, NeighboursTouchAndNoDiscsOverlap) {
  for (const Diagram& diagram : samples()) {
    SCOPED_TRACE(to_text(diagram));
    const CircleLayout layout = circle_layout(diagram);
    std::vector<Disc> all = layout.nodes;
    for (Dart d = 0; d < diagram.dart_count(); ++d) {
      const auto& arc = layout.arcs[d];
      ASSERT_FALSE(arc.empty());
      EXPECT_NEAR(gap(layout.nodes[diagram.node(d)], arc.front()), 0, 1e-8);
      for (std::size_t i = 1; i < arc.size(); ++i) EXPECT_NEAR(gap(arc[i - 1], arc[i]), 0, 1e-8);
      if (d < diagram.mate(d)) all.insert(all.end(), arc.begin(), arc.end());
    }
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) ASSERT_GT(gap(all[i], all[j]), -1e-8);
  }
}

/// The way a curve runs at one of its ends.
Point direction(const Curve& curve, Point end) {
  if (curve.radius == 0) return curve.to - curve.from;
  return (end - curve.centre) * Point(0, curve.turns_left() ? 1 : -1);
}

TEST(Drawing, StrandsHaveNoCornersBetweenVertices) {
  for (const Diagram& diagram : samples()) {
    SCOPED_TRACE(to_text(diagram));
    for (const DrawnStrand& strand : draw(diagram).strands)
      for (std::size_t i = 0; i + (strand.closed ? 0 : 1) < strand.pieces.size(); ++i) {
        const Curve& one = strand.pieces[i].curve;
        const Curve& two = strand.pieces[(i + 1) % strand.pieces.size()].curve;
        ASSERT_NEAR(std::abs(one.to - two.from), 0, 1e-9);
        const Point before = direction(one, one.to), after = direction(two, two.from);
        EXPECT_NEAR(std::arg(after / before), 0, 1e-4);
      }
  }
}

// A circle without a crossing is one: at a vertex of degree 2 there is no corner either.
TEST(Drawing, StrandsHaveNoCornersAtVerticesOfDegreeTwo) {
  for (const char* text : {"Loop[1]", "V[1,2] V[2,1]", "V[1,2] V[1,2]", "V[1,2] V[2,3] V[1,3]",
                           "X[1,1,2,3] V[2,3]", "V[1] V[1,2] V[2,3] V[3]"}) {
    SCOPED_TRACE(text);
    const Diagram diagram = topology::read_diagram(text).diagram;
    std::vector<std::pair<Point, Point>> ends;  // where a curve ends, and how it leaves the vertex
    for (const DrawnStrand& strand : draw(diagram).strands) {
      const Curve& first = strand.pieces.front().curve;
      const Curve& last = strand.pieces.back().curve;
      ends.emplace_back(first.from, direction(first, first.from));
      ends.emplace_back(last.to, -direction(last, last.to));
    }
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < ends.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        if (std::abs(ends[i].first - ends[j].first) > 1e-9) continue;
        ++pairs;
        EXPECT_NEAR(std::abs(std::arg(-ends[i].second / ends[j].second)), 0, 1e-4);
      }
    EXPECT_GT(pairs, 0u);
  }
}

TEST(Drawing, EveryArcHasItsNumberInADiscOfItsOwn) {
  for (const Diagram& diagram : samples()) {
    SCOPED_TRACE(to_text(diagram));
    const CircleLayout layout = circle_layout(diagram);
    const Drawing drawing = draw(diagram);
    ASSERT_EQ(drawing.arcs.size(), diagram.arc_count());
    std::size_t k = 0;
    for (Dart d = 0; d < diagram.dart_count(); ++d) {
      if (d > diagram.mate(d)) continue;
      const ArcLabel& label = drawing.arcs[k++];
      EXPECT_EQ(label.arc, diagram.arc(d));
      const Disc& disc = layout.arcs[d].front();
      EXPECT_LT(std::abs(label.middle - disc.centre), disc.radius);
      EXPECT_NEAR(std::abs(label.away), 1, 1e-9);
    }
    std::string svg = to_svg(diagram, {.arcs = true});
    std::size_t numbers = 0;
    for (std::size_t at = 0; (at = svg.find("<text ", at)) != std::string::npos; ++at) ++numbers;
    EXPECT_EQ(numbers, diagram.arc_count());
    EXPECT_EQ(to_svg(diagram).find("<text "), std::string::npos);
  }
}

TEST(Drawing, OverStrandsPassInTheMiddleOfTheGaps) {
  for (const Diagram& diagram : samples()) {
    const Drawing drawing = draw(diagram);
    std::vector<const Curve*> over(diagram.node_count(), nullptr), under = over;
    for (const DrawnStrand& strand : drawing.strands)
      for (const StrandPiece& piece : strand.pieces) {
        if (piece.level == Level::kOver) over[piece.node] = &piece.curve;
        if (piece.level == Level::kUnder) under[piece.node] = &piece.curve;
      }
    for (std::size_t n = 0; n < diagram.node_count(); ++n) {
      ASSERT_EQ(over[n] != nullptr, diagram.is_crossing(n));
      if (over[n] == nullptr) continue;
      const double t = crossing_parameter(*under[n], *over[n]);
      EXPECT_GT(t, 0.01);
      EXPECT_LT(t, 0.99);
      double nearest = 1;
      for (int i = 0; i <= 2000; ++i)
        nearest = std::min(nearest, std::abs(over[n]->at(i / 2000.0) - under[n]->at(t)));
      EXPECT_LT(nearest, 1e-3 * drawing.crossings[n].radius);
    }
  }
}

TEST(Drawing, ADiagramThatIsTooLargeIsRefused) {
  EXPECT_THAT([] { to_svg(topology::random_diagram(1500, 1)); },
              ::testing::ThrowsMessage<InvalidInput>(::testing::HasSubstr("up to 2000 are drawn")));
}

}  // namespace
}  // namespace tripus::drawing
