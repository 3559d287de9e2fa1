#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "base/stop.hpp"
#include "meshing/formats/read_mesh.hpp"
#include "meshing/tetrahedralize.hpp"
#include "topology/gluings.hpp"

namespace tripus::meshing {

/// The way from a boundary surface to a small ideal triangulation.
enum class MeshStage { kMesh, kConed, kCollapsed, kMinimal };
inline constexpr std::size_t kStageCount = 4;
/// "mesh", "coned", "collapsed", "minimal".
std::string_view stage_name(MeshStage stage);

struct ManifoldOptions {
  TetrahedralizeOptions tetrahedralize;  ///< for surfaces
  std::uint64_t seed = 0;                ///< of the simplification
  /// Called now and then with what is going on and the number of tetrahedra so far (0: none yet).
  std::function<void(std::string_view activity, std::size_t tetrahedra)> progress;
  Stop stop{};
};

/// A solid as an ideal triangulation: a boundary component of genus 1 or more has become an ideal
/// vertex, a sphere was filled in.
struct MeshedManifold {
  topology::Gluings gluings;
  std::array<std::size_t, kStageCount> tetrahedra{};  ///< at each MeshStage
  std::vector<int> boundary_genera;                   ///< of all boundary components, sorted
  std::size_t points = 0;                             ///< of the input
  std::size_t triangles = 0;                          ///< of the input, 0 for a tetrahedral mesh
  std::size_t turned = 0;          ///< triangles that did not agree with most of their component
  std::vector<std::string> notes;  ///< what was not read, and what was mended
  TetrahedralMesh mesh;
  bool mesh_is_exact = true;  ///< false: some of its tetrahedra are only right before rounding

  /// Whether the boundary is nothing but spheres: the solid is then a ball, or a ball with balls
  /// taken out, and carries no metric with geodesic boundary.
  bool has_only_spheres() const;
};

/// MeshStage::kMesh alone: mends and checks a surface or a tetrahedral mesh (mend, require_valid)
/// and fills the surface with tetrahedra; the gluings are open on the boundary. Throws what these
/// throw: InvalidInput, Unsupported, Stopped.
MeshedManifold filled_solid(MeshFile file, const ManifoldOptions& options = {});

/// All stages: cones off the boundary of the filled solid and simplifies. Deterministic for a seed.
/// Throws what filled_solid throws.
MeshedManifold manifold_of(MeshFile file, const ManifoldOptions& options = {});

/// What a solid with nothing but spheres for its boundary is, in a sentence.
std::string ball_message(const MeshedManifold& manifold);

}  // namespace tripus::meshing
