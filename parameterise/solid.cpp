#include "parameterise/solid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include <Eigen/Dense>

#include "base/error.hpp"
#include "base/stop.hpp"
#include "embedding/developing_map.hpp"
#include "geometry/moebius.hpp"
#include "structure/solve.hpp"
#include "topology/cone.hpp"
#include "topology/edge_walk.hpp"
#include "topology/simplify/simplify_recording.hpp"

namespace tripus::parameterise {
namespace {

using topology::Gluings;
using topology::TetrahedronIndex;

using topology::slot_of;

constexpr std::uint32_t kUnknown = 0xffffffffu;

void require_hyperbolic_boundary(const meshing::MeshedManifold& manifold) {
  if (manifold.has_only_spheres())
    throw InvalidInput(
        meshing::ball_message(manifold) +
        "; its fundamental group is trivial, so that there is nothing to parameterise by");
  for (const int genus : manifold.boundary_genera)
    if (genus == 1)
      throw Unsupported(
          "the solid has a torus among its boundary components; it would be a cusp of the metric, "
          "infinitely far away, and only solids whose boundary has genus 2 or more (or spheres) "
          "are parameterised");
}

/// A simplification that carries the metric, and how it came about.
struct Found {
  topology::Gluings coned;
  topology::SimplificationRecord record;
};

Found find_metric(meshing::MeshFile file, const MarkOptions& options, const Context& context,
                  MarkedSolid& solid) {
  Found found;
  meshing::ManifoldOptions making;
  making.tetrahedralize = options.tetrahedralize;
  making.stop = context.stop;
  making.progress = context.progress;
  meshing::MeshedManifold manifold = meshing::filled_solid(std::move(file), making);
  require_hyperbolic_boundary(manifold);
  solid.mesh = std::move(manifold.mesh);
  solid.notes = std::move(manifold.notes);
  solid.boundary_genera = std::move(manifold.boundary_genera);
  solid.gluings = std::move(manifold.gluings);
  found.coned = topology::cone_boundary(solid.gluings);
  structure::SolveOptions solving;
  solving.stop = context.stop;
  solving.evidence = false;
  for (std::size_t n = 0;; ++n) {
    found.record = {};
    topology::SimplifyOptions simplify;
    simplify.seed = options.seed + n;
    simplify.stop = context.stop;
    simplify.progress = context.progress;
    const Gluings small = topology::simplify_recording(found.coned, found.record, simplify).gluings;
    throw_if_stopped(context.stop);
    context.report("looking for the metric", small.tetrahedron_count());
    solid.manifold = std::make_unique<topology::Triangulation>(small);
    solid.report = structure::solve(*solid.manifold, solving);
    throw_if_stopped(context.stop);
    solid.seed = options.seed + n;
    if (solid.report.outcome == structure::Outcome::kGeometric) return found;
    if (n + 1 >= options.seeds) break;
  }
  throw Unsupported("none of " + std::to_string(options.seeds) +
                    " small triangulations of this solid carries a hyperbolic metric (" +
                    solid.report.message + "); tripus solve says more about the manifold");
}

/// The embedding whose tetrahedra lie the way round that those of the solid do.
embedding::Embedding oriented_embedding(const topology::Triangulation& manifold,
                                        const structure::Report& report) {
  embedding::Embedding placed = embedding::embed(manifold, report.edge_lengths);
  std::array<geometry::Vector3, 4> corner;
  for (std::size_t v = 0; v < 4; ++v) {
    const Vector4& pole = placed.tetrahedra[0].vertices[v];
    corner[v] = pole.head<3>() / pole[3];
  }
  const double side =
      (corner[1] - corner[0]).cross(corner[2] - corner[0]).dot(corner[3] - corner[0]);
  return side > 0 ? placed : mirrored(placed);
}

topology::FlatConnection connection_of(const MarkedSolid& solid) {
  topology::FlatConnection connection;
  for (const topology::Letter letter : solid.holonomy.group.face_letters)
    connection.values.push_back(solid.group->of_letter(letter));
  return connection;
}

/// The cones over one component of the boundary, each with the way from its frame to that of the
/// first one.
struct Cones {
  std::vector<TetrahedronIndex> tetrahedra;
  std::vector<std::uint32_t> to_first;
  std::set<std::uint32_t> holonomy;  ///< closed ways in the component, seen from the first
};

/// Cone k lies over an open face of the mesh; `apex` is its label of the cone point.
Cones cones_around(MarkedSolid& solid, const Gluings& coned, const topology::FlatConnection& fine,
                   TetrahedronIndex first, int apex, std::vector<std::uint32_t>& element) {
  DeckGroup& group = *solid.group;
  Cones cones;
  std::vector<std::size_t> queue{slot_of(first, apex)};
  element[first] = 0;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const std::size_t k = queue[i] / 4;
    const int at = static_cast<int>(queue[i] % 4);
    cones.tetrahedra.push_back(static_cast<TetrahedronIndex>(k));
    cones.to_first.push_back(element[k]);
    for (int f = 0; f < 4; ++f) {
      if (f == at) continue;
      const TetrahedronIndex other = coned.neighbour(k, f);
      const std::uint32_t there = group.product(element[k], fine.values[slot_of(k, f)]);
      if (element[other] == kUnknown) {
        element[other] = there;
        queue.push_back(slot_of(other, coned.gluing(k, f)(at)));
      } else if (there != element[other]) {
        cones.holonomy.insert(group.product(there, group.inverse(element[other])));
      }
    }
  }
  return cones;
}

/// The plane that the fundamental group of a boundary component maps to itself: the vector that all
/// its elements keep, found by least squares, and then taken for the truncation plane that it is.
ExactPole pole_of(const MarkedSolid& solid, const std::set<std::uint32_t>& holonomy) {
  Matrix4 squares = Matrix4::Zero();
  for (const std::uint32_t h : holonomy) {
    const Matrix4& m = solid.group->matrix(h);
    const Matrix4 moved = (m - Matrix4::Identity()) / m.squaredNorm();
    squares += moved.transpose() * moved;
  }
  const Eigen::SelfAdjointEigenSolver<Matrix4> solver(squares);
  Vector4 pole = solver.eigenvectors().col(0);
  const double square = geometry::lorentz_product(pole, pole);
  if (square > 0) {
    pole /= std::sqrt(square);
    for (const double sign : {1.0, -1.0})
      if (const auto found = solid.group->exact_pole(sign * pole)) return *found;
  }
  throw InternalError("no plane of the geodesic boundary belongs to a boundary component");
}

/// The planes of the boundary, for each point that lies on a component of genus 2 or more.
void make_poles(MarkedSolid& solid, const Gluings& coned, const topology::FlatConnection& fine) {
  DeckGroup& group = *solid.group;
  const std::size_t inside = solid.gluings.tetrahedron_count();
  solid.poles.assign(solid.mesh.points.size(), Vector4::Zero());
  std::vector<std::uint32_t> element(coned.tetrahedron_count(), kUnknown);
  for (std::size_t t = 0; t < inside; ++t)
    for (int open = 0; open < 4; ++open) {
      if (!solid.gluings.is_open(t, open) || element[coned.neighbour(t, open)] != kUnknown)
        continue;
      const Cones cones = cones_around(solid, coned, fine, coned.neighbour(t, open),
                                       coned.gluing(t, open)(open), element);
      if (cones.holonomy.empty()) continue;  // a sphere
      const ExactPole pole = pole_of(solid, cones.holonomy);
      ++solid.planes;
      for (std::size_t n = 0; n < cones.tetrahedra.size(); ++n) {
        const TetrahedronIndex k = cones.tetrahedra[n];
        for (int f = 0; f < 4; ++f) {
          const TetrahedronIndex other = coned.neighbour(k, f);
          if (other >= inside) continue;
          // From the frame of the first cone to that of the tetrahedron below this one.
          const std::uint32_t down = group.product(group.inverse(fine.values[slot_of(k, f)]),
                                                   group.inverse(cones.to_first[n]));
          for (int v = 0; v < 4; ++v) {
            const std::uint32_t point = solid.mesh.tetrahedra[other][static_cast<std::size_t>(v)];
            if (v == coned.gluing(k, f)(f) || !solid.poles[point].isZero(0)) continue;
            const std::uint32_t frame = group.inverse(solid.corners[slot_of(other, v)]);
            solid.poles[point] =
                group.matrix(group.product(group.product(frame, down), pole.element)) * pole.pole;
          }
        }
      }
    }
}

void make_start(MarkedSolid& solid, const topology::FlatConnection& fine) {
  solid.start.assign(solid.mesh.points.size(), geometry::origin());
  std::vector<bool> known(solid.mesh.points.size(), false);
  for (std::size_t slot = 0; slot < solid.corners.size(); ++slot) {
    const std::uint32_t point = solid.mesh.tetrahedra[slot / 4][slot % 4];
    if (known[point]) continue;  // the first corner gives the frame
    known[point] = true;
    solid.start[point] = solid.places[fine.origins[slot / 4]].col(3);
  }
}

}  // namespace

std::unique_ptr<MarkedSolid> mark_solid(meshing::MeshFile file, const MarkOptions& options,
                                        const Context& context) {
  auto solid = std::make_unique<MarkedSolid>();
  const Found found = find_metric(std::move(file), options, context, *solid);
  solid->steps = found.record.size();
  solid->record_bytes = found.record.memory_bytes();
  context.report("carrying the metric back", solid->mesh.tetrahedra.size());
  solid->embedding = oriented_embedding(*solid->manifold, solid->report);
  solid->holonomy = embedding::holonomy(solid->embedding, *solid->manifold);
  for (const auto& place : embedding::developing_map(solid->embedding, solid->manifold->gluings()))
    solid->places.push_back(geometry::to_matrix(place));
  solid->group = std::make_unique<DeckGroup>(solid->embedding, *solid->manifold, solid->holonomy,
                                             solid->places);
  const topology::FlatConnection small = connection_of(*solid);
  const topology::FlatConnection fine =
      topology::carried_back(found.coned, found.record, small, *solid->group);
  if (!topology::curved_edges(found.coned, fine.values, *solid->group).empty())
    throw InternalError("the connection that was carried back is not flat");
  solid->values.assign(
      fine.values.begin(),
      fine.values.begin() + static_cast<std::ptrdiff_t>(4 * solid->mesh.tetrahedra.size()));
  solid->corners.assign(4 * solid->mesh.tetrahedra.size(), kNoFrame);
  give_frames(*solid);
  make_poles(*solid, found.coned, fine);
  make_start(*solid, fine);
  return solid;
}

void give_frames(MarkedSolid& solid) {
  std::vector<std::uint32_t> stack;
  for (std::uint32_t first = 0; first < solid.corners.size(); ++first) {
    if (solid.corners[first] != kNoFrame) continue;
    solid.corners[first] = 0;
    stack.assign(1, first);
    while (!stack.empty()) {
      const std::uint32_t here = stack.back();
      stack.pop_back();
      const std::size_t t = here / 4;
      const int v = static_cast<int>(here % 4);
      for (int f = 0; f < 4; ++f) {
        if (f == v || solid.gluings.is_open(t, f)) continue;
        const std::size_t there =
            slot_of(solid.gluings.neighbour(t, f), solid.gluings.gluing(t, f)(v));
        if (solid.corners[there] != kNoFrame) continue;
        const std::uint32_t back = solid.group->inverse(solid.values[slot_of(t, f)]);
        solid.corners[there] = solid.group->product(back, solid.corners[here]);
        stack.push_back(static_cast<std::uint32_t>(there));
      }
    }
  }
}

void choose_frames(MarkedSolid& solid, std::vector<Vector4>& points) {
  DeckGroup& group = *solid.group;
  std::vector<std::uint32_t> change(points.size());  // from the new frame to the old one
  for (std::size_t v = 0; v < points.size(); ++v) {
    change[v] = group.of_place(points[v]);
    if (change[v] == 0) continue;
    const Matrix4 back = geometry::lorentz_inverse(group.matrix(change[v]));
    points[v] = geometry::on_hyperboloid(back * points[v]);
    solid.start[v] = back * solid.start[v];
    if (solid.poles[v].isZero(0)) continue;
    solid.poles[v] = back * solid.poles[v];
    if (const auto exact = group.exact_pole(solid.poles[v]))
      solid.poles[v] = group.matrix(exact->element) * exact->pole;
  }
  const std::size_t count = solid.gluings.tetrahedron_count();
  std::vector<std::uint32_t> frame(count);  // of the tetrahedra, likewise
  for (std::size_t t = 0; t < count; ++t) {
    for (std::size_t v = 0; v < 4; ++v) {
      std::uint32_t& corner = solid.corners[4 * t + v];
      corner = group.product(corner, change[solid.mesh.tetrahedra[t][v]]);
    }
    frame[t] = solid.corners[4 * t];
    for (std::size_t v = 0; v < 4; ++v)
      solid.corners[4 * t + v] = group.product(group.inverse(frame[t]), solid.corners[4 * t + v]);
  }
  for (std::size_t t = 0; t < count; ++t)
    for (int f = 0; f < 4; ++f) {
      if (solid.gluings.is_open(t, f)) continue;
      std::uint32_t& value = solid.values[slot_of(t, f)];
      value = group.product(group.product(group.inverse(frame[t]), value),
                            frame[solid.gluings.neighbour(t, f)]);
    }
}

double relator_defect(const MarkedSolid& solid) {
  double largest = 0;
  std::vector<bool> seen(6 * solid.gluings.tetrahedron_count(), false);
  for (std::size_t t = 0; t < solid.gluings.tetrahedron_count(); ++t)
    for (int e = 0; e < 6; ++e) {
      if (seen[6 * t + static_cast<std::size_t>(e)]) continue;
      const auto start = topology::EdgeWalk::start(t, e);
      topology::EdgeWalk walk = start;
      LongMatrix4 product = LongMatrix4::Identity();
      bool is_closed = true;
      do {
        seen[6 * walk.t + static_cast<std::size_t>(walk.edge())] = true;
        is_closed = !solid.gluings.is_open(walk.t, walk.c);
        if (!is_closed) break;
        const std::uint32_t value = solid.values[slot_of(walk.t, walk.c)];
        if (value != 0) product *= solid.group->long_matrix(value);
        walk.step(solid.gluings);
      } while (walk.t != start.t || walk.a != start.a || walk.b != start.b);
      if (is_closed)
        largest = std::max(largest, static_cast<double>(
                                        (product - LongMatrix4::Identity()).cwiseAbs().maxCoeff()));
    }
  return largest;
}

}  // namespace tripus::parameterise
