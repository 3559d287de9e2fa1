#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/stop.hpp"
#include "meshing/tetrahedral_mesh.hpp"
#include "meshing/validate.hpp"

namespace tripus::meshing::detail {

struct SplitOptions {
  double max_volume = 0;       ///< split what is larger; 0: nothing for its size
  std::size_t tetrahedra = 0;  ///< split the largest until there are so many
  std::size_t most = 0;        ///< tetrahedra that there is room for
};

/// Splits tetrahedra at their centroids, the largest first, so that no face is touched: what a
/// mesher cannot refine without new points on the boundary. The new tetrahedra have the sign of
/// the old one (exact); one too flat for that is left when only a number is asked for.
/// Throws Unsupported if `most` is not enough, or one is too flat for `max_volume`.
void split_largest(TetrahedralMesh& mesh, const SplitOptions& options);

/// Volume of a tetrahedron, negative if its corners are not in positive order.
double volume_of(const TetrahedralMesh& mesh, const Tetrahedron& t);

/// Fills a region with tetrahedra without any mesher: a box around it is cut by the planes of its
/// triangles into convex cells, each plane where its triangles run, all of it in exact rational
/// arithmetic. Never fails but for want of time or memory (nothing is returned then); makes some
/// 50 tetrahedra a triangle. The points are rounded at the end, so that tetrahedra may be flat or
/// turned inside out by that; how they hang together is that of the exact ones, in positive order.
/// The points of the surface are the first ones.
/// Throws Stopped.
std::optional<TetrahedralMesh> fill_by_planes(const Region& region, std::uint64_t memory_limit,
                                              double deadline, const Stop& stop);

/// Faces of one tetrahedron alone, counterclockwise from outside where tetrahedra are in positive
/// order; those with equal corners follow each other in no order of meaning.
std::vector<Triangle> boundary_faces(const TetrahedralMesh& mesh);

/// Whether tetrahedra in positive order fill a region: what is wrong if not, nothing if they do.
///
/// Their boundary is the surface, or a subdivision of it with new points. Positive tetrahedra fill
/// what their boundary encloses, once everywhere, if that is embedded. It is then the surface up to
/// isotopy: each of its triangles lies on a triangle of the surface up to rounding, so it lies in
/// a collar S x [-e, e] of the surface S; each component encloses the volume of the one that it has
/// points of, so it runs once around that; and it has its genus (Waldhausen 1968, as for tubes in
/// tube/tube_surface.cpp).
/// Exact but for "up to rounding", which is tolerance::kOnSurface.
std::string boundary_fault(const TetrahedralMesh& mesh, const Region& region, const Stop& stop);

/// One question to TetGen.
struct TetgenQuestion {
  std::vector<Point> points;
  std::vector<Triangle> triangles;
  std::vector<Point> holes;             ///< a point in each
  double max_volume = 0;                ///< 0: no matter
  bool keep_boundary = true;            ///< whether it is asked to; it does not always
  std::uint64_t memory_limit = 0;       ///< bytes
  std::uint64_t processor_seconds = 0;  ///< at most
  double deadline = 0;                  ///< of now_in_seconds
  Stop stop{};
};

/// A mesh of which nothing is promised but that its numbers are those of points, or why there is
/// none.
struct TetgenAnswer {
  std::optional<TetrahedralMesh> mesh;
  std::string problem;         ///< a sentence without its full stop
  bool out_of_memory = false;  ///< another try would end so as well
  bool mesher_failed = false;  ///< it crashed, or its answer makes no sense
};

/// Asks TetGen in a process of its own (tripus-tetgen), and ends that.
/// Throws Unsupported if the program is missing, IoError if it cannot be started, Stopped.
TetgenAnswer ask_tetgen(const TetgenQuestion& question);

}  // namespace tripus::meshing::detail
