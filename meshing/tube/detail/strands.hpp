#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "meshing/tube/detail/outer_surface.hpp"

namespace tripus::meshing::tube {

inline constexpr std::uint32_t kNone = 0xffffffff;

/// A straight piece of the graph.
struct Segment {
  Point a, b;
  std::uint32_t node_a, node_b;
  std::uint32_t edge;    ///< of the SpatialGraph
  std::uint32_t number;  ///< from 0 along that edge
  bool beyond;           ///< a spur outside the outer surface that keeps the tube open there
};

enum class NodeKind { kInside, kCrossing, kBeyond };

struct Node {
  Point point;
  NodeKind kind;
  std::vector<std::uint32_t> segments;
};

/// A spatial graph cut at the outer surface: every loose end runs to a crossing, and from there a
/// spur goes on along the outward normal, so that near the outer surface the tube is a pipe that
/// crosses it squarely.
struct TubeStrands {
  std::vector<Segment> segments;
  std::vector<Node> nodes;
  OuterSurface outer;
  std::vector<std::uint32_t>
      loose_inside;  ///< edges with loose ends, where there is no outer surface

  /// What the surface of the tube must be, by the graph alone.
  struct Expected {
    std::vector<long> euler_characteristics;  ///< one a component, sorted
  };
  Expected expected() const;

  /// The least angle between two segments at a node.
  double sharpest_angle() const;
};

/// "edge 2 segment 3", or what a spur is.
std::string name_of(const Segment& segment);

/// Throws InvalidInput naming edge and point for all that is wrong with a graph except for strands
/// that come too close to each other (see clearance.hpp). `outer` stands in for graph.outer.
TubeStrands make_strands(const SpatialGraph& graph, const OuterSurface& outer);

}  // namespace tripus::meshing::tube
