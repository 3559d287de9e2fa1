#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/context.hpp"
#include "meshing/manifold.hpp"
#include "parameterise/deck_group.hpp"
#include "structure/report.hpp"

/// A solid in space and the hyperbolic manifold that it is: from the one to the other.
namespace tripus::parameterise {

struct MarkOptions {
  meshing::TetrahedralizeOptions tetrahedralize = {};  ///< for surfaces
  std::uint64_t seed = 0;  ///< of the simplification; further ones are tried if it has no metric
  std::size_t seeds = 10;  ///< how many of them
};

/// A solid in tetrahedra, the metric of its manifold, and the *marking* that tells what the one has
/// to do with the other: a flat connection on the mesh with deck transformations as its values. It
/// is that of the metric on the small triangulation, carried back along the simplification
/// (topology/simplify/carry_back.hpp).
struct MarkedSolid {
  meshing::TetrahedralMesh mesh = {};   ///< tetrahedra in positive order
  topology::Gluings gluings = {};       ///< of the mesh, open on the boundary
  std::vector<std::string> notes = {};  ///< what was mended in the input, and left out
  std::vector<int> boundary_genera = {};

  std::unique_ptr<topology::Triangulation> manifold = {};  ///< small, oriented as the solid
  structure::Report report = {};                           ///< its metric
  embedding::Embedding embedding = {};                     ///< oriented as the solid
  embedding::Holonomy holonomy = {};
  std::vector<Matrix4> places = {};  ///< [tetrahedra of the manifold] in the fundamental domain
  std::unique_ptr<DeckGroup> group = {};

  std::vector<std::uint32_t> values = {};  ///< [T x 4] the connection, as numbers of the group
  /// [T x 4] from the frame of the point at vertex v to that of tetrahedron t. A point has the
  /// frame of the first tetrahedron that it is a vertex of.
  std::vector<std::uint32_t> corners = {};
  std::vector<Vector4> poles = {};  ///< [V] of the plane on which the point must lie, or 0
  std::vector<Vector4> start =
      {};  ///< [V] where the simplification, or a coarser map, sent the point

  std::size_t steps = 0;         ///< of the simplification
  std::size_t record_bytes = 0;  ///< that remember them
  std::size_t planes = 0;        ///< boundary components that are geodesic
  std::uint64_t seed = 0;        ///< of the simplification whose result carries the metric
};

/// Throws InvalidInput for a solid with nothing but spheres for its boundary, whose fundamental
/// group is trivial; Unsupported for a torus (a cusp), and where none of the triangulations found
/// carries a metric; Stopped; and what meshing::filled_solid throws.
std::unique_ptr<MarkedSolid> mark_solid(meshing::MeshFile file, const MarkOptions& options = {},
                                        const Context& context = {});

/// What a corner is whose point has no frame yet.
inline constexpr std::uint32_t kNoFrame = 0xffffffffu;

/// Gives each point whose corners are kNoFrame the frame of the first tetrahedron at it, and
/// carries that to the others around it.
void give_frames(MarkedSolid& solid);

/// Gives every point, and every tetrahedron, the frame in which its image lies in the fundamental
/// domain: neighbours then have frames that are near to each other, and deck transformations along
/// edges are short, so that matrices keep their digits. The map is the same.
///   points [V] in the old frames, and in the new ones afterwards
void choose_frames(MarkedSolid& solid, std::vector<Vector4>& points);

/// How far the products of matrices around the edges inside the mesh are from the identity: the
/// largest entry. As numbers of the group they are the identity, which is checked by mark_solid.
/// The matrices are the long doubles that the words give. Those of doubles, whose entries go to
/// some hundreds, have products that are off by the rounding of these, to the third power.
double relator_defect(const MarkedSolid& solid);

}  // namespace tripus::parameterise
