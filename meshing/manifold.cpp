#include "meshing/manifold.hpp"

#include <algorithm>
#include <utility>

#include "base/stop.hpp"
#include "meshing/mend.hpp"
#include "meshing/predicates.hpp"
#include "meshing/validate_tetrahedra.hpp"
#include "topology/cone.hpp"
#include "topology/simplify/simplify.hpp"

namespace tripus::meshing {
namespace {

void tell(const ManifoldOptions& options, std::string_view activity, std::size_t tetrahedra) {
  throw_if_stopped(options.stop);
  if (options.progress) options.progress(activity, tetrahedra);
}

topology::Gluings open_gluings(SurfaceFile file, const ManifoldOptions& options,
                               MeshedManifold& manifold) {
  manifold.points = file.mesh.points.size();
  manifold.triangles = file.mesh.triangles.size();
  const Region region = require_valid(std::move(file.mesh), file.lines, options.stop);
  manifold.turned = region.turned;
  for (const SurfaceComponent& component : region.components)
    manifold.boundary_genera.push_back(component.genus);
  std::sort(manifold.boundary_genera.begin(), manifold.boundary_genera.end());
  tell(options, "filling the surface with tetrahedra", 0);
  TetrahedralizeOptions filling = options.tetrahedralize;
  filling.stop = options.stop;
  manifold.mesh = tetrahedralize(region, filling);
  const auto& points = manifold.mesh.points;
  manifold.mesh_is_exact = std::all_of(
      manifold.mesh.tetrahedra.begin(), manifold.mesh.tetrahedra.end(), [&](const Tetrahedron& t) {
        return orientation(points[t[0]], points[t[1]], points[t[2]], points[t[3]]) > 0;
      });
  return gluings_of(manifold.mesh);
}

topology::Gluings open_gluings(TetrahedralFile file, const ManifoldOptions&,
                               MeshedManifold& manifold) {
  manifold.points = file.mesh.points.size();
  Solid solid = require_valid(std::move(file.mesh), file.lines);
  manifold.mesh = std::move(solid.mesh);
  manifold.boundary_genera = std::move(solid.boundary_genera);
  return std::move(solid.gluings);
}

}  // namespace

std::string_view stage_name(MeshStage stage) {
  constexpr std::array<std::string_view, kStageCount> kNames{"mesh", "coned", "collapsed",
                                                             "minimal"};
  return kNames[static_cast<std::size_t>(stage)];
}

bool MeshedManifold::has_only_spheres() const {
  return std::all_of(boundary_genera.begin(), boundary_genera.end(),
                     [](int genus) { return genus == 0; });
}

MeshedManifold filled_solid(MeshFile file, const ManifoldOptions& options) {
  MeshedManifold manifold;
  tell(options, "checking the mesh", 0);
  manifold.gluings = std::visit(
      [&](auto&& each) {
        auto mended = mend(std::move(each));
        manifold.notes = mended.notes;
        return open_gluings(std::move(mended), options, manifold);
      },
      std::move(file));
  manifold.tetrahedra[static_cast<std::size_t>(MeshStage::kMesh)] =
      manifold.gluings.tetrahedron_count();
  return manifold;
}

MeshedManifold manifold_of(MeshFile file, const ManifoldOptions& options) {
  MeshedManifold manifold = filled_solid(std::move(file), options);
  const auto count = [&](MeshStage stage) -> std::size_t& {
    return manifold.tetrahedra[static_cast<std::size_t>(stage)];
  };
  tell(options, "coning off the boundary", count(MeshStage::kMesh));
  manifold.gluings = topology::cone_boundary(manifold.gluings);
  count(MeshStage::kConed) = manifold.gluings.tetrahedron_count();
  topology::SimplifyOptions simplify;
  simplify.seed = options.seed;
  simplify.stop = options.stop;
  simplify.progress = options.progress;
  topology::Simplified simplified = topology::simplify(manifold.gluings, simplify);
  throw_if_stopped(options.stop);
  manifold.gluings = std::move(simplified.gluings);
  count(MeshStage::kCollapsed) = simplified.collapsed;
  count(MeshStage::kMinimal) = manifold.gluings.tetrahedron_count();
  return manifold;
}

std::string ball_message(const MeshedManifold& manifold) {
  const std::size_t holes = manifold.boundary_genera.size() - 1;
  return "it bounds a ball" +
         (holes == 0 ? std::string()
                     : " with " + std::to_string(holes) + (holes == 1 ? " ball" : " balls") +
                           " taken out") +
         ": its boundary has only spheres, and a metric needs a component of genus 2 or more";
}

}  // namespace tripus::meshing
