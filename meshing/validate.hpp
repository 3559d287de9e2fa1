#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/stop.hpp"
#include "meshing/self_intersection.hpp"
#include "meshing/surface_mesh.hpp"

namespace tripus::meshing {

struct SurfaceComponent {
  std::size_t triangle_count = 0;
  std::uint32_t first_triangle = 0;
  int genus = 0;
};

/// A solid by its boundary: what lies inside the outermost component of a surface and outside all
/// others, which are holes. Triangles run counterclockwise as seen from outside their component, so
/// normals of holes point into the region.
struct Region {
  SurfaceMesh surface;
  std::vector<std::uint32_t> component_of;  ///< [triangles]
  std::vector<SurfaceComponent> components;
  std::uint32_t outermost = 0;
  std::size_t turned = 0;  ///< triangles that did not agree with most of their component
};

/// Checks that a surface bounds a region, and returns that. In this order: not empty, coordinates
/// finite and in_exact_range, corners of a triangle different, no unused points, no equal points,
/// no collinear triangles, no triangle twice, every edge in two triangles, one fan of triangles at
/// every point, two-sided, no self-intersection (exact), every component but one inside that one
/// and in no other (exact). The way round of the triangles is mended, nothing else.
/// Points and triangles keep their numbers. Near-linear in the number of triangles.
/// Throws InvalidInput naming what is wrong, where (with the line, where `lines` knows it), how
/// often, and what to do; Stopped when `stop` is set.
Region require_valid(SurfaceMesh mesh, const SourceLines& lines = {}, const Stop& stop = {});

/// A point inside a hole (component `hole`, not the outermost) of a valid region. Exact.
/// Throws Unsupported if none of many tried is: a hole too thin for doubles.
Point point_in_hole(const Region& region, std::uint32_t hole);

}  // namespace tripus::meshing
