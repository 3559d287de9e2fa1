#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "meshing/surface_mesh.hpp"

/// Faces of more than three corners need not be planar, and were cut into triangles along diagonals
/// that looked best in each face by itself. Where one collides with the rest of the surface, the
/// other diagonal of its quadrilateral is as true to the file.

namespace tripus::meshing::detail {

/// A surface whose sheets touched in points and edges, and do no more.
struct SheetsApart {
  SurfaceMesh mesh;
  std::size_t moved = 0;  ///< points that were in one place with others
  double distance = 0;    ///< the farthest that one was moved
};

/// Boolean operations leave solids that touch themselves along an edge or in a point, and tell what
/// belongs to which sheet by points that are there several times. Such points are moved a little
/// towards their neighbours, which parts the sheets, however they are joined. Nothing if no points
/// are in one place, the triangles do not close up by the numbers of their corners, or no distance
/// that is tried gives a valid surface (require_valid). Points are all used, coordinates
/// in_exact_range.
std::optional<SheetsApart> sheets_apart(const SurfaceMesh& mesh);

/// A side k of a triangle, from corner k to corner k+1, that no other triangle has.
struct OpenEdge {
  std::uint32_t triangle = 0, side = 0;
};

struct Edges {
  std::vector<OpenEdge> open;
  bool is_crowded = false;  ///< an edge is in three triangles or more

  bool is_closed() const { return open.empty() && !is_crowded; }
};

/// Corners of a triangle are different. In O(T log T).
Edges edges_of(const std::vector<Triangle>& triangles);

/// Gives ends of the open edges that are at most so far apart one number, that of the first;
/// returns how many got another.
std::size_t weld(SurfaceMesh& mesh, const std::vector<OpenEdge>& open, double distance);

/// Splits triangles where an end of some open edge is at most so far from the inside of theirs;
/// the parts come last in `mesh`, and `cell_of` [triangles] is what they inherit. Returns how many
/// were split; does nothing where there are too many open edges to compare.
std::size_t split_at_points(SurfaceMesh& mesh, std::vector<std::uint32_t>& cell_of,
                            const std::vector<OpenEdge>& open, double distance);

/// Whether two triangles of the mesh are parts of one face of the file.
using SameFace = std::function<bool(std::size_t, std::size_t)>;

/// Turns diagonals that are edges of other triangles as well, where the other diagonal is no edge.
/// Returns how many. Triangles keep their places.
std::size_t uncrowd_diagonals(SurfaceMesh& mesh, const SameFace& same_face);

/// Turns diagonals of triangles that cross others, as long as that leaves fewer crossings; if some
/// are left in the end, those of quadrilaterals are chosen anew (choose_diagonals), and if that
/// has no solution, nothing is changed. The surface is closed, its triangles are proper and
/// different. Returns how many were turned. Quadratic at worst, in the number of crossings times
/// triangles.
std::size_t uncross_diagonals(SurfaceMesh& mesh, const SameFace& same_face);

/// For every face that was cut into two triangles the diagonal with which no triangle crosses
/// another and no edge is in more than two, if there are such; triangles of other faces stay.
/// Exact: each pair of triangles that collide excludes a pair of diagonals, and such pairs alone
/// decide. The surface is closed, its triangles are proper and different, and keep their places.
/// Returns how many diagonals were turned: 0 if there is no way, or none was needed. Near-linear
/// where the boxes of triangles overlap few others.
std::size_t choose_diagonals(SurfaceMesh& mesh, const SameFace& same_face);

}  // namespace tripus::meshing::detail
