#include "meshing/tetrahedralize.hpp"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <limits>
#include <utility>

#include "base/error.hpp"
#include "base/stopped.hpp"
#include "meshing/detail/child_process.hpp"
#include "meshing/detail/find_tetgen.hpp"
#include "meshing/detail/split.hpp"
#include "meshing/detail/tetgen_protocol.hpp"
#include "meshing/predicates.hpp"

namespace tripus::meshing {
namespace {

using detail::ChildProcess;
using detail::TetgenRequest;
using detail::TetgenResponse;
using detail::TetgenStatus;
using Transfer = ChildProcess::Transfer;

/// Largest volume allowed, in units of the volume that a tetrahedron would have if N filled the
/// region: most come out a little smaller than allowed.
constexpr double kFirstShare = 1.2;
/// An aim is met when the number of tetrahedra is off by less than this part.
constexpr double kAimTolerance = 0.1;
constexpr int kMostAttempts = 4;
/// Of memory, for a tetrahedron on its way to the triangulation (bench/README.md: 260 MB for
/// 200,000).
constexpr std::uint64_t kBytesEach = 1300;

/// TetGen's own tolerances suppose coordinates near 1: a power of two changes no digit.
int scale_exponent(const std::vector<Point>& points) {
  double size = 0;
  for (const Point& p : points)
    for (const double x : p) size = std::fmax(size, std::fabs(x));
  return size > 0 ? -std::ilogb(size) : 0;
}

std::vector<Point> scaled(std::vector<Point> points, int exponent) {
  for (Point& p : points)
    for (double& x : p) x = std::ldexp(x, exponent);
  return points;
}

/// The talk with one process.
class Talk {
 public:
  Talk(const TetrahedralizeOptions& options)
      : options_(options),
        child_(detail::find_tetgen()),
        deadline_(detail::now_in_seconds() + options.time_limit) {}

  template <class Item>
  void send(const std::vector<Item>& items) {
    send(items.data(), items.size() * sizeof(Item));
  }
  void send(const void* data, std::size_t size) {
    require(child_.send(data, size, deadline_, options_.stop_requested));
  }
  void receive(void* data, std::size_t size) {
    require(child_.receive(data, size, deadline_, options_.stop_requested));
  }

 private:
  void require(Transfer transfer) {
    if (transfer == Transfer::kDone) return;
    if (transfer == Transfer::kTimeOut) fail_on_time();
    const std::string ending = child_.ending();
    if (child_.signal() == SIGXCPU) fail_on_time();
    throw_if_stopped(options_.stop_requested);
    if (child_.signal() == SIGINT || child_.signal() == SIGTERM) throw Stopped();
    throw Unsupported("TetGen " + ending +
                      " on this surface: a fault of its own that very thin or very crowded parts "
                      "can cause; remesh the surface more evenly, or give a tetrahedral mesh");
  }
  [[noreturn]] void fail_on_time() const {
    throw Unsupported("TetGen was not done after " +
                      std::to_string(static_cast<long>(options_.time_limit)) +
                      " s; give it more time, or a coarser surface");
  }

  const TetrahedralizeOptions& options_;
  ChildProcess child_;
  double deadline_;
};

void require_success(std::uint64_t status) {
  switch (static_cast<TetgenStatus>(status)) {
    case TetgenStatus::kDone:
      return;
    case TetgenStatus::kOutOfMemory:
      throw Unsupported("TetGen ran out of memory; give it more, or a coarser surface");
    case TetgenStatus::kSelfIntersection:
    case TetgenStatus::kTinyFeature:
      throw InvalidInput(
          "TetGen finds parts of the surface too near to each other to tell them apart; remesh it, "
          "or move them apart");
    default:
      throw Unsupported("TetGen gave up on this surface (its error " + std::to_string(status) +
                        "); remesh the surface more evenly, or give a tetrahedral mesh");
  }
}

TetrahedralMesh run(const Region& region, const std::vector<Point>& points,
                    const std::vector<Point>& holes, double max_volume,
                    const TetrahedralizeOptions& options) {
  TetgenRequest request;
  request.memory_limit = options.memory_limit;
  request.processor_seconds = static_cast<std::uint64_t>(std::ceil(options.time_limit)) + 1;
  request.max_volume = max_volume;
  request.points = points.size();
  request.triangles = region.surface.triangles.size();
  request.holes = holes.size();
  Talk talk(options);
  talk.send(&request, sizeof request);
  talk.send(points);
  talk.send(region.surface.triangles);
  talk.send(holes);
  TetgenResponse response;
  talk.receive(&response, sizeof response);
  if (response.mark != TetgenResponse::kMark)
    throw InternalError("tripus-tetgen is not of the version of this program");
  require_success(response.status);
  TetrahedralMesh mesh;
  mesh.points.resize(response.points);
  mesh.tetrahedra.resize(response.tetrahedra);
  talk.receive(mesh.points.data(), mesh.points.size() * sizeof(Point));
  talk.receive(mesh.tetrahedra.data(), mesh.tetrahedra.size() * sizeof(Tetrahedron));
  return mesh;
}

/// TetGen orders corners the other way.
void require_positive(TetrahedralMesh& mesh) {
  for (Tetrahedron& t : mesh.tetrahedra) {
    for (const std::uint32_t corner : t)
      if (corner >= mesh.points.size()) throw InternalError("TetGen: a corner that does not exist");
    const auto& p = mesh.points;
    const int sign = orientation(p[t[0]], p[t[1]], p[t[2]], p[t[3]]);
    if (sign < 0) std::swap(t[2], t[3]);
    if (sign == 0)
      throw Unsupported(
          "TetGen made a flat tetrahedron on this surface; remesh the surface more evenly, or give "
          "a tetrahedral mesh");
  }
}

using Face = std::array<std::uint32_t, 3>;

std::vector<Face> boundary_faces(const TetrahedralMesh& mesh) {
  std::vector<Face> faces;
  faces.reserve(4 * mesh.tetrahedra.size());
  for (const Tetrahedron& t : mesh.tetrahedra)
    for (std::size_t f = 0; f < 4; ++f) {
      Face face{t[(f + 1) % 4], t[(f + 2) % 4], t[(f + 3) % 4]};
      std::sort(face.begin(), face.end());
      faces.push_back(face);
    }
  std::sort(faces.begin(), faces.end());
  std::vector<Face> once;
  for (std::size_t i = 0, end = 0; i < faces.size(); i = end) {
    while (end < faces.size() && faces[end] == faces[i]) ++end;
    if (end - i == 1) once.push_back(faces[i]);
  }
  return once;
}

/// Positive tetrahedra whose boundary is the surface, every triangle once, fill the region.
void require_boundary(const TetrahedralMesh& mesh, const SurfaceMesh& surface) {
  const bool same_points =
      mesh.points.size() >= surface.points.size() &&
      std::equal(surface.points.begin(), surface.points.end(), mesh.points.begin());
  std::vector<Face> wanted = surface.triangles;
  for (Face& face : wanted) std::sort(face.begin(), face.end());
  std::sort(wanted.begin(), wanted.end());
  if (!same_points || boundary_faces(mesh) != wanted)
    throw Unsupported(
        "TetGen did not keep the boundary of this surface; remesh the surface more evenly, or give "
        "a tetrahedral mesh");
}

/// The boundary alone may force more; else the largest volume is corrected a few times.
template <class Fill>
TetrahedralMesh fill_with_about(std::size_t aim, double region_volume, const Fill& fill) {
  TetrahedralMesh best = fill(0.0);
  const auto wanted = static_cast<double>(aim);
  const auto distance = [&](const TetrahedralMesh& mesh) {
    return std::fabs(std::log(static_cast<double>(mesh.tetrahedra.size()) / wanted));
  };
  if (best.tetrahedra.size() >= aim) return best;
  double max_volume = kFirstShare * region_volume / wanted;
  for (int i = 0; i < kMostAttempts && distance(best) > kAimTolerance; ++i) {
    TetrahedralMesh mesh = fill(max_volume);
    max_volume *= static_cast<double>(mesh.tetrahedra.size()) / wanted;
    if (distance(mesh) < distance(best)) best = std::move(mesh);
  }
  return best;
}

/// TetGen adds no point whose sphere of influence meets the boundary, so that near coarse triangles
/// it leaves tetrahedra larger than it was told: these are split here.
void keep_promises(TetrahedralMesh& mesh, double max_volume, const TetrahedralizeOptions& options) {
  detail::SplitOptions split;
  split.max_volume = max_volume;
  const auto aim = static_cast<double>(options.tetrahedra);
  if (static_cast<double>(mesh.tetrahedra.size()) < (1 - kAimTolerance) * aim)
    split.tetrahedra = options.tetrahedra;
  split.most = options.memory_limit / kBytesEach;
  detail::split_largest(mesh, split);
}

}  // namespace

double volume(const Region& region) {
  const auto& [points, triangles] = region.surface;
  const Point& o = points[triangles.front()[0]];
  double sum = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    std::array<Point, 3> v;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) v[i][k] = points[triangles[t][i]][k] - o[k];
    const double cone = v[0][0] * (v[1][1] * v[2][2] - v[1][2] * v[2][1]) +
                        v[0][1] * (v[1][2] * v[2][0] - v[1][0] * v[2][2]) +
                        v[0][2] * (v[1][0] * v[2][1] - v[1][1] * v[2][0]);
    sum += region.component_of[t] == region.outermost ? cone : -cone;
  }
  return sum / 6;
}

TetrahedralMesh tetrahedralize(const Region& region, const TetrahedralizeOptions& options) {
  const int exponent = scale_exponent(region.surface.points);
  const std::vector<Point> points = scaled(region.surface.points, exponent);
  std::vector<Point> holes;
  for (std::uint32_t c = 0; c < region.components.size(); ++c)
    if (c != region.outermost) holes.push_back(point_in_hole(region, c));
  holes = scaled(std::move(holes), exponent);
  const double unit = std::ldexp(1.0, exponent);
  const auto scaled_volume = [&](double max_volume) {  // 0 stays, and nothing else becomes 0
    const double least = max_volume > 0 ? std::numeric_limits<double>::min() : 0;
    return std::fmax(max_volume * unit * unit * unit, least);
  };
  const auto fill = [&](double max_volume) {
    return run(region, points, holes, scaled_volume(max_volume), options);
  };
  TetrahedralMesh mesh = options.tetrahedra > 0
                             ? fill_with_about(options.tetrahedra, volume(region), fill)
                             : fill(options.max_volume);
  keep_promises(mesh, scaled_volume(options.max_volume), options);
  mesh.points = scaled(std::move(mesh.points), -exponent);
  require_positive(mesh);
  require_boundary(mesh, region.surface);
  return mesh;
}

}  // namespace tripus::meshing
