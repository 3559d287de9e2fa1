#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "meshing/tube/detail/strands.hpp"

namespace tripus::meshing::tube {

/// Where pipes meet, or where one opens to the outer surface.
struct Joint {
  Point point;
  bool opening = false;
  Point normal{};                      ///< of the outer surface, at an opening
  double radius = 0;                   ///< of the ball in which the pipes meet; 0 at an opening
  std::vector<std::uint32_t> pipes{};  ///< those that end here
};

/// A straight pipe from joint a to joint b that may be thicker at one end.
struct Pipe {
  std::uint32_t a, b;
  double radius_a = 0, radius_b = 0;
  std::uint32_t segment;  ///< of the strands: where a message should point
};

/// How thick each part of a tube may be by what is near to it, and by nothing else.
///
/// The ball of a joint and the pipes keep to these rules, each with a tenth to spare, and so meet
/// nothing but what they end at (law 6 of the README):
///   balls          less than half of the way to any other pipe, joint, or the outer surface
///   pipes          less than half of the way to any pipe or joint that they do not end at
///   pipes that end at one joint   each in a cone from there, the cones apart
/// At an opening the strand turns to the outer surface's normal shortly before it.
struct PipePlan {
  std::vector<Joint> joints;
  std::vector<Pipe> pipes;
  OuterSurface outer;
};

PipePlan plan_pipes(const TubeStrands& strands);

}  // namespace tripus::meshing::tube
