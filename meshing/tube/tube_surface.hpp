#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/stop.hpp"
#include "meshing/surface_mesh.hpp"
#include "meshing/tube/spatial_graph.hpp"

namespace tripus::meshing {

/// Without the first three: straight pipes of few triangles, each as thick as its own surroundings
/// leave room for. With one of them: a round tube of one radius, sampled.
struct TubeOptions {
  std::optional<double> radius = {};          ///< of the tube; else half of what the strands leave
  std::optional<std::size_t> triangles = {};  ///< about so many; else by `edges_around`
  std::optional<double> edges_around = {};    ///< triangle edges around the tube; else 10
  /// Called at the start of each step with what is going on, and why it may take long.
  std::function<void(std::string_view activity)> progress = {};
  Stop stop{};  ///< throws Stopped when set
};

/// A tube's surface and what was found on the way.
struct Tube {
  SurfaceMesh surface;     ///< triangles face out of the piece of space that they bound
  bool sampled = false;    ///< whether it is the round one
  double radius = 0;       ///< of the tube; of its thinnest pipe
  double thickest = 0;     ///< of the tube; of its thickest pipe
  double room = 0;         ///< one radius below this keeps the tube's shape
  std::string room_place;  ///< what limits them
  std::vector<long> euler_characteristics;  ///< of the components, sorted
};

/// The boundary of a ball or box with the tube around a graph removed; components of the graph that
/// run to the outer surface make one component with it, each other one is a hole. The surface is
/// closed, manifold, free of self-intersections, and isotopic to the boundary of the drawing's
/// exact neighbourhood (README.md, laws 1-4); all of this but the isotopy is checked again before
/// it is returned.
/// Throws InvalidInput, naming edges, segments and distances, for graphs that have no tube, and
/// Stopped.
Tube make_tube(const SpatialGraph& graph, const TubeOptions& options = {});

inline SurfaceMesh tube_surface(const SpatialGraph& graph, const TubeOptions& options = {}) {
  return make_tube(graph, options).surface;
}

}  // namespace tripus::meshing
