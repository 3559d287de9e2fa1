#pragma once

#include <optional>

#include "meshing/tube/detail/pipe_plan.hpp"

namespace tripus::meshing::tube {

/// The surface of straight three-sided pipes and of convex joints between them, within the outer
/// surface: as few triangles as there is reason for. Triangles face out of the piece of space that
/// they bound. Nothing where rounding does not leave the shape that the plan asks for, which takes
/// a drawing with parts some 1e7 times finer than the whole.
std::optional<SurfaceMesh> pipe_surface(const PipePlan& plan);

}  // namespace tripus::meshing::tube
