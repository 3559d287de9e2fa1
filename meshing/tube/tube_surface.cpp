// From a drawing to the surface of its tube.
//
// Why the surface is the right one. Let F be the region's function (region.hpp), S the surface
// {F = 0} and h the cell side. No edge of the lattice is longer than h and F changes no faster than
// the place, so |F| < h on the sampled surface M. By the choice of h the levels of F between -h and
// h are all regular (clearance.cpp): the space {|F| <= h} is S x [-h, h], and M separates its two
// ends. If each component of M has the genus of the component of S beside it, then the projection
// of M to S, which has degree 1, is homotopic to a homeomorphism (Kneser), M is incompressible, and
// hence isotopic to S (Waldhausen; for spheres: Alexander). What follows sampling consists of
// isotopies (guarded_surface.hpp). So the genus, which is checked at the end, decides all.
//
// Where strands part at an acute angle the space between their tubes is a cleft, and the sample may
// fall to pieces there at every cell side: the few lattice directions may all lead out of the
// cleft. If the sample's genus is wrong, the next ones are of the region with fillets (TubeRegion),
// as large as the lattice resolves. They lie where -kFilletHeight * kFilletCells * h <= F <= 0; the
// cells are chosen so that the levels down to there less h are regular too.
//
// All this is for round tubes of one radius. Without wishes the surface is made of pipes
// (pipe_plan.hpp, pipe_surface.cpp), which needs no sample and no room that is the same everywhere.
#include "meshing/tube/tube_surface.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "meshing/detail/closed_surface.hpp"
#include "meshing/self_intersection.hpp"
#include "meshing/tube/detail/clearance.hpp"
#include "meshing/tube/detail/stages.hpp"
#include "meshing/tube/detail/vector3.hpp"

namespace tripus::meshing {
namespace {

/// Of the components of a surface that we made, sorted.
std::vector<long> euler_characteristics(const SurfaceMesh& mesh) {
  std::string fault = detail::manifold_fault(mesh.triangles, mesh.points.size());
  topology::DisjointSets components(mesh.points.size());
  const auto doubled = detail::doubled_characteristics(mesh.triangles, components);
  for (std::uint32_t v = 0; v < mesh.points.size() && fault.empty(); ++v)
    if (!doubled.contains(components.root(v))) fault = "vertex " + std::to_string(v) + " is unused";
  if (!fault.empty())
    throw InternalError("the tube's surface is not a closed manifold: " + fault +
                        "; please report this graph");
  std::vector<long> result;
  for (const auto& [component, twice] : doubled) result.push_back(twice / 2);
  std::sort(result.begin(), result.end());
  return result;
}

using namespace tube;

/// The largest part of the room that a tube may fill, and the part that it fills by itself.
constexpr double kMostOfRoom = 0.95, kUsualPartOfRoom = 0.5;

/// The largest cell, as a part of what tube and space around it leave (< 1, see above).
constexpr double kLargestCell = 0.9;

/// Size of the fillets in cells. Measured on 120 stars of three strands 15 degrees apart, in random
/// directions: 78 samples have a wrong genus without fillets, 25 with fillets of 1 cell, 3 with 2.
constexpr double kFilletCells = 2;

/// A sample of the wrong genus is taken again with a finer lattice, so often; the first ones go
/// without fillets, which ask for smaller cells.
constexpr int kPlainSamples = 2, kMostSamples = 5;
constexpr double kNextCell = 0.87;

/// Where that does not help and the radius is not given, a smaller one is tried, so often.
constexpr int kMostRadii = 3;
constexpr double kNextRadius = 0.7;

/// Triangles of the sampled surface for an area of one squared cell side: measured on planes and
/// tubes, 5.5 to 7.
constexpr double kTrianglesPerCell = 6;

/// Sampled triangles for each one wanted, so that coarsening can even them out.
constexpr double kSpareTriangles = 2;

/// An icosahedron holds a ball of 0.79 of its size.
constexpr double kWideSphere = 1.5;

/// Less room than this part of the whole is rounding of the coordinates.
constexpr double kLeastRoom = 1e-12;

constexpr double kUsualEdgesAround = 10;
constexpr std::size_t kMostTubeTriangles = std::size_t{1} << 23;
constexpr double kMostCellsAlongAxis = 1 << 18;
constexpr int kSweepsBefore = 1, kSweepsAfter = 4;

/// The numbers of a drawing are within these bounds: squares and cubes of its lengths must not
/// overflow, nor differences of its coordinates lose more than half their digits.
constexpr double kLargestCoordinate = 1e60, kSmallestSize = 1e-40, kMostOffset = 1e6;

/// A polyline with more pieces is refused: every pair of them is looked at.
constexpr std::size_t kMostSegments = 50'000;

void check_sizes(const SpatialGraph& graph) {
  Bounds bounds;
  double largest = 0;
  std::size_t count = 0;
  const auto add = [&](const Point& p, const std::string& place) {
    for (const double x : p) {
      if (!(std::abs(x) <= kLargestCoordinate))
        throw InvalidInput(place + " at " + as_text(p) +
                           " has a coordinate beyond 1e60; scale the drawing");
      largest = std::max(largest, std::abs(x));
    }
    bounds.add(p);
    ++count;
  };
  for (std::size_t v = 0; v < graph.vertices.size(); ++v)
    add(graph.vertices[v], "vertex " + std::to_string(v));
  for (std::size_t e = 0; e < graph.edges.size(); ++e)
    for (std::size_t p = 0; p < graph.edges[e].size(); ++p)
      add(graph.edges[e][p], "edge " + std::to_string(e) + ": point " + std::to_string(p));
  if (count > kMostSegments)
    throw InvalidInput("the graph has " + std::to_string(count) + " points; at most " +
                       std::to_string(kMostSegments) + " are taken");
  if (const auto* sphere = std::get_if<OuterSphere>(&graph.outer)) {
    const Point r{sphere->radius, sphere->radius, sphere->radius};
    add(sphere->center - r, "outer sphere");
    add(sphere->center + r, "outer sphere");
  } else if (const auto* box = std::get_if<OuterBox>(&graph.outer)) {
    add(box->low, "outer box");
    add(box->high, "outer box");
  }
  if (count == 0) return;
  const double size = bounds.diagonal();
  if (largest > 0 && size < kSmallestSize)
    throw InvalidInput("the drawing is only " + as_text(size) + " large; scale it up");
  if (largest > kMostOffset * size)
    throw InvalidInput("the drawing is " + as_text(size) + " large but its coordinates reach " +
                       as_text(largest) + "; move it to the origin");
}

void require_room(const Clearance& clearance, const TubeStrands& strands) {
  Bounds bounds = strands.outer.exists() ? strands.outer.bounds() : Bounds{};
  for (const Segment& s : strands.segments)
    if (!s.beyond) {
      bounds.add(s.a);
      bounds.add(s.b);
    }
  if (!(clearance.room > kLeastRoom * bounds.diagonal()))
    throw InvalidInput("there is no room for a tube: " + clearance.place +
                       (clearance.room > 0 ? ", too thin for the size of the whole" : "") +
                       "; draw them apart");
}

/// A sphere that leaves the graph's own room around it, and as much again; `wide`: so much that an
/// icosahedron in it has room, unless a loose end would become longer by that.
OuterSurface automatic_outer(const SpatialGraph& graph, bool wide) {
  const TubeStrands strands = make_strands(graph, OuterSurface{});
  const Clearance clearance = find_clearance(strands);
  require_room(clearance, strands);
  Bounds bounds;
  for (const auto& edge : graph.edges)
    for (const Point& p : edge) bounds.add(p);
  const Point center = bounds.center();
  double farthest = 0;
  for (const auto& edge : graph.edges)
    for (const Point& p : edge) farthest = std::max(farthest, distance(p, center));
  if (wide && strands.loose_inside.empty())
    return OuterSurface(OuterSphere{center, kWideSphere * farthest});
  return OuterSurface(OuterSphere{center, farthest + 2 * std::min(clearance.room, farthest)});
}

TubeStrands cut_at_outer(const SpatialGraph& graph, bool wide) {
  if (const auto* sphere = std::get_if<OuterSphere>(&graph.outer))
    return make_strands(graph, OuterSurface(*sphere));
  if (const auto* box = std::get_if<OuterBox>(&graph.outer))
    return make_strands(graph, OuterSurface(*box));
  if (std::holds_alternative<AutomaticOuter>(graph.outer))
    return make_strands(graph, automatic_outer(graph, wide));
  TubeStrands strands = make_strands(graph, OuterSurface{});
  if (!strands.loose_inside.empty())
    throw InvalidInput("edge " + std::to_string(strands.loose_inside.front()) +
                       " has an end that is no vertex, and there is no outer surface to which it "
                       "could go on; list the end among the vertices or give an outer surface");
  return strands;
}

double choose_radius(const Clearance& clearance, const TubeOptions& options) {
  const double most = kMostOfRoom * clearance.room;
  if (!options.radius) return kUsualPartOfRoom * clearance.room;
  if (!(*options.radius > 0) || !std::isfinite(*options.radius))
    throw InvalidInput("the radius of the tube must be a finite number greater than 0");
  if (*options.radius > most)
    throw InvalidInput("a tube of radius " + as_text(*options.radius) + " does not fit: " +
                       clearance.place + "; the radius must not exceed " + as_text(most));
  return *options.radius;
}

double tube_area(const TubeStrands& strands, double radius) {
  double length = 0;
  for (const Segment& s : strands.segments)
    if (!s.beyond) length += distance(s.a, s.b);
  return 2 * std::numbers::pi * radius * (length + 2 * radius);
}

double outer_area(const TubeStrands& strands) {
  if (!strands.outer.exists()) return 0;
  const Point size = strands.outer.bounds().high - strands.outer.bounds().low;
  const double box = 2 * (size[0] * size[1] + size[1] * size[2] + size[2] * size[0]);
  // A sphere fills pi / 6 of its cube's faces.
  return strands.outer.is_sphere() ? std::numbers::pi / 6 * box : box;
}

/// What else to try where one radius asks for too many triangles.
std::string advice_on_radius(const TubeOptions& options, double radius, double room) {
  const double half = kUsualPartOfRoom * room;
  if (!options.radius || radius == half) return "";
  return std::string("give a ") + (radius > half ? "smaller" : "larger") + " radius, near " +
         as_text(half) + ", or none; ";
}

/// Refuses tubes that are too thin for the size of the whole, before any memory is taken.
void require_feasible(const TubeStrands& strands, const Clearance& clearance,
                      const TubeRegion& region, double area, double cell,
                      const std::string& advice) {
  const Point size = region.bounds().high - region.bounds().low;
  const double most = std::max({size[0], size[1], size[2]});
  if (most > kMostCellsAlongAxis * cell ||
      kTrianglesPerCell * area > double(kMostTubeTriangles) * cell * cell)
    throw InvalidInput(
        std::string(region.radius() > kUsualPartOfRoom * clearance.room
                        ? "what a tube of this radius leaves free"
                        : "the tube") +
        " is too thin for the size of the whole: the surface needs triangles of size " +
        as_text(cell) + " where all is " + as_text(most) + " large; " + advice +
        (strands.outer.exists() ? "give a closer outer surface, or " : "") +
        "draw the graph with more room (" + clearance.place + ")");
}

double edges_around(const TubeOptions& options) {
  const double edges = options.edges_around.value_or(kUsualEdgesAround);
  if (!(edges >= 3) || !(edges <= 10'000))
    throw InvalidInput("there must be 3 to 10000 edges around the tube, not " + as_text(edges));
  return edges;
}

/// Edges around the tube decide the length of an edge on it; the outer surface has longer ones.
std::size_t usual_triangles(const TubeStrands& strands, double radius, double edges_around) {
  const double edge = 2 * std::numbers::pi * radius / edges_around;
  const double triangle = std::sqrt(3.0) / 4 * edge * edge;
  const double count = (tube_area(strands, radius) + outer_area(strands) / 4) / triangle;
  return std::size_t(std::min(count, double(kMostTubeTriangles)));
}

/// Tells what is going on now, and again as often as it is called.
Pulse start(const TubeOptions& options, const std::string& activity) {
  Pulse pulse(options.stop, [&options, activity] {
    if (options.progress) options.progress(activity);
  });
  pulse();
  return pulse;
}

/// What is wrong with a surface, if anything; exact.
std::string fault_of(const Tube& tube, const Stop& stop) {
  if (euler_characteristics(tube.surface) != tube.euler_characteristics)
    return "does not have the components and genera that the graph has";
  if (const auto pair = first_self_intersection(tube.surface, stop))
    return "crosses itself in triangles " + std::to_string((*pair)[0]) + " and " +
           std::to_string((*pair)[1]);
  return "";
}

/// Says no if rounding spoils the pipes.
bool make_pipes(const TubeStrands& strands, const TubeOptions& options, Tube& tube) {
  start(options, "laying " + std::to_string(strands.segments.size()) + " pipes");
  const PipePlan plan = plan_pipes(strands);
  std::optional<SurfaceMesh> surface = pipe_surface(plan);
  if (!surface) return false;
  tube.surface = *std::move(surface);
  start(options, "checking " + std::to_string(tube.surface.triangles.size()) + " triangles");
  if (!fault_of(tube, options.stop).empty()) return false;
  tube.radius = HUGE_VAL;
  tube.thickest = 0;
  for (const Pipe& pipe : plan.pipes)
    for (const double radius : {pipe.radius_a, pipe.radius_b}) {
      tube.radius = std::min(tube.radius, radius);
      tube.thickest = std::max(tube.thickest, radius);
    }
  return true;
}

/// Makes the surface of the tube of radius tube.radius; says no if no sample has the graph's
/// genera.
bool make_surface(const TubeStrands& strands, const Clearance& clearance,
                  const TubeOptions& options, Tube& tube) {
  const std::size_t wanted = options.triangles
                                 ? *options.triangles
                                 : usual_triangles(strands, tube.radius, edges_around(options));
  const double depth = kLargestCell * std::min(tube.radius, tube.room - tube.radius);
  const double area = tube_area(strands, tube.radius) + outer_area(strands);
  double cell =
      std::min(depth, std::sqrt(kTrianglesPerCell * area / (kSpareTriangles * double(wanted) + 1)));
  for (int sample = 0; sample < kMostSamples; ++sample, cell *= kNextCell) {
    const bool plain = sample < kPlainSamples;
    if (!plain)
      cell = std::min(cell, kLargestCell * (tube.room - tube.radius) /
                                (1 + TubeRegion::kFilletHeight * kFilletCells));
    const TubeRegion region(strands, tube.radius, depth, plain ? 0 : kFilletCells * cell);
    require_feasible(strands, clearance, region, area, cell,
                     advice_on_radius(options, tube.radius, tube.room));
    SurfaceMesh sampled = march(
        region, cell, kMostTubeTriangles,
        start(options,
              "sampling in cells of " + as_text(cell) + ", so small because " +
                  (cell < kNextCell * depth ? "so many triangles are wanted" : clearance.place)));
    if (euler_characteristics(sampled) != tube.euler_characteristics) continue;
    const Pulse pulse = start(options, "from " + std::to_string(sampled.triangles.size()) +
                                           " sampled triangles to " + std::to_string(wanted));
    GuardedSurface surface(std::move(sampled));
    relax(surface, region, kSweepsBefore, pulse);
    coarsen(surface, region, wanted, pulse);
    relax(surface, region, kSweepsAfter, pulse);
    tube.surface = surface.mesh();
    start(options, "checking " + std::to_string(tube.surface.triangles.size()) + " triangles");
    if (const std::string fault = fault_of(tube, options.stop); !fault.empty())
      throw InternalError("the tube's surface " + fault + "; please report this graph");
    tube.thickest = tube.radius;
    tube.sampled = true;
    return true;
  }
  return false;
}

}  // namespace

Tube make_tube(const SpatialGraph& graph, const TubeOptions& options) {
  check_sizes(graph);
  edges_around(options);
  start(options, "measuring the room between " + std::to_string(graph.edges.size()) + " edges");
  const bool round = options.radius || options.triangles || options.edges_around;
  const TubeStrands strands = cut_at_outer(graph, !round);
  const Clearance clearance = find_clearance(strands);
  require_room(clearance, strands);
  Tube tube;
  tube.radius = choose_radius(clearance, options);
  tube.room = clearance.room;
  tube.room_place = clearance.place;
  tube.euler_characteristics = strands.expected().euler_characteristics;
  if (!round && make_pipes(strands, options, tube)) return tube;
  const int radii = options.radius ? 1 : kMostRadii;
  for (int attempt = 0; attempt < radii; ++attempt, tube.radius *= kNextRadius)
    if (make_surface(strands, clearance, options, tube)) return tube;
  throw InternalError(
      "no sample of the tube's surface has the components and genera that the graph has; strands "
      "may part at very small angles (the least is " +
      as_text(strands.sharpest_angle() * 180 / std::numbers::pi) +
      " degrees): " + (options.radius ? "try a smaller radius, more triangles, or " : "") +
      "spread them, or report this graph");
}

}  // namespace tripus::meshing
