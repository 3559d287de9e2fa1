#pragma once

#include <vector>

#include "viewer/scene.hpp"

namespace tripus::viewer {

/// Points of a wall of a cell in a model, whose convex hull holds the wall but for `margin`.
struct WallOutline {
  std::vector<Vector3> points;
  double margin = 0;                 ///< the wall lies within this of the hull
  Vector3 middle = Vector3::Zero();  ///< the same for both cells of a shared face, to rounding
  double radius = 0;                 ///< the wall lies within this of `middle`
};

/// The outline of a wall, finer for larger and rounder walls.
///   detail  length in the model that nobody sees: the margin need not be less; > 0
WallOutline wall_outline(Model model, const SceneCell& cell, std::size_t wall, double detail);

}  // namespace tripus::viewer
