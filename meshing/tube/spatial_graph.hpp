#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "meshing/surface_mesh.hpp"

namespace tripus::meshing {

/// The outer surface of the piece of space from which the tube is taken.
struct OuterSphere {
  Point center{};
  double radius = 0;
};
struct OuterBox {
  Point low{}, high{};
};
/// A sphere around the whole graph, with room for its tube.
struct AutomaticOuter {};
/// None: the surface bounds the tube itself, a handlebody or a solid torus.
struct NoOuter {};
using Outer = std::variant<AutomaticOuter, NoOuter, OuterSphere, OuterBox>;

/// A graph drawn in space with straight pieces.
///   vertices  points where edges end; each is the end of one edge or more
///   edges     each the points of a polyline, two or more. Its first and its last point are
///               - a vertex,
///               - or each other (a knot, which needs no vertex),
///               - or a loose end: the edge goes on to the outer surface, straight on if the end
///                 lies inside, and the tube is open there.
struct SpatialGraph {
  std::string name;
  std::vector<Point> vertices;
  std::vector<std::vector<Point>> edges;
  Outer outer = AutomaticOuter{};
};

/// Reads the JSON form (documented in meshing/tube/README.md). Only its form is checked here;
/// tube_surface checks the geometry. Throws InvalidInput naming the key, edge and point.
SpatialGraph read_spatial_graph(std::string_view text);

}  // namespace tripus::meshing
