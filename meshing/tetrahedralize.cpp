#include "meshing/tetrahedralize.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <random>
#include <sstream>
#include <utility>

#include "base/error.hpp"
#include "base/stop.hpp"
#include "meshing/detail/child_process.hpp"
#include "meshing/detail/filling.hpp"
#include "meshing/predicates.hpp"

namespace tripus::meshing {
namespace {

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

/// How the surface is put to TetGen: another order of points and axes takes it other ways, so that
/// it may succeed where it failed.
struct Attempt {
  std::uint32_t shuffle = 0;  ///< seed; 0: as it is
  bool keep_boundary = true;
};
constexpr Attempt kAttempts[] = {{0, true}, {0, false}, {1, true},  {2, false},
                                 {3, true}, {4, false}, {5, false}, {6, false}};

/// A try ends after so many seconds: where TetGen succeeds it takes far less, and it may hang.
constexpr double kShortTry = 0.5, kShortTryEach = 1e-3;
/// Of processor time to that on a clock, at most, on a machine that is busy.
constexpr double kBusy = 8;

/// Of the time that is left then, for the way without TetGen.
constexpr double kPlanesShare = 0.5;

/// The surface with points and axes in another order; exact.
class Shuffled {
 public:
  Shuffled(const std::vector<Point>& points, const std::vector<Point>& holes,
           const std::vector<Triangle>& triangles, std::uint32_t seed)
      : numbers_(points.size()) {
    std::iota(numbers_.begin(), numbers_.end(), 0u);
    question.triangles = triangles;
    if (seed > 0) {
      std::mt19937 random(seed);
      const auto below = [&](std::size_t n) { return random() % n; };
      for (std::size_t i = numbers_.size(); i > 1; --i)
        std::swap(numbers_[i - 1], numbers_[below(i)]);
      for (std::size_t i = triangles.size(); i > 1; --i)
        std::swap(question.triangles[i - 1], question.triangles[below(i)]);
      first_axis_ = seed % 3;
      negated_ = seed % 2 == 1;
    }
    std::vector<std::uint32_t> place(points.size());
    for (std::uint32_t i = 0; i < place.size(); ++i) place[numbers_[i]] = i;
    for (const std::uint32_t number : numbers_) question.points.push_back(turned(points[number]));
    for (const Point& hole : holes) question.holes.push_back(turned(hole));
    for (Triangle& t : question.triangles)
      for (std::uint32_t& corner : t) corner = place[corner];
  }

  /// The answer in the old order.
  void turn_back(TetrahedralMesh& mesh) const {
    const std::vector<Point> points = mesh.points;
    for (std::size_t i = 0; i < points.size(); ++i)
      mesh.points[i < numbers_.size() ? numbers_[i] : i] = turned_back(points[i]);
    for (Tetrahedron& t : mesh.tetrahedra)
      for (std::uint32_t& corner : t)
        if (corner < numbers_.size()) corner = numbers_[corner];
  }

  detail::TetgenQuestion question;

 private:
  Point turned(const Point& p) const {
    const double x = p[first_axis_ % 3];
    return {negated_ ? -x : x, p[(first_axis_ + 1) % 3], p[(first_axis_ + 2) % 3]};
  }
  Point turned_back(const Point& q) const {
    Point p;
    for (std::size_t k = 0; k < 3; ++k) p[(first_axis_ + k) % 3] = q[k];
    if (negated_) p[first_axis_] = -q[0];
    return p;
  }

  std::vector<std::uint32_t> numbers_;
  std::size_t first_axis_ = 0;
  bool negated_ = false;
};

/// TetGen orders corners the other way. Says no if a tetrahedron is flat.
bool make_positive(TetrahedralMesh& mesh) {
  for (Tetrahedron& t : mesh.tetrahedra) {
    const auto& p = mesh.points;
    const int sign = orientation(p[t[0]], p[t[1]], p[t[2]], p[t[3]]);
    if (sign == 0) return false;
    if (sign < 0) std::swap(t[2], t[3]);
  }
  return true;
}

/// What is wrong with the points inside, where the boundary is as it should be: tetrahedra that
/// were turned to be positive fill a region once only if they fill its volume.
std::string inside_fault(const TetrahedralMesh& mesh, const Region& region) {
  constexpr double kVolumeTolerance = 1e-6;  // rounding makes 1e-9 of thin ones
  Point low = region.surface.points.front(), high = low;
  for (const Point& p : region.surface.points)
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::fmin(low[k], p[k]);
      high[k] = std::fmax(high[k], p[k]);
    }
  for (const Point& p : mesh.points)
    for (std::size_t k = 0; k < 3; ++k)
      if (!(p[k] >= low[k] && p[k] <= high[k])) return "TetGen made a point outside the surface";
  double sum = 0;
  for (const Tetrahedron& t : mesh.tetrahedra) sum += std::fabs(detail::volume_of(mesh, t));
  if (!(std::fabs(sum - volume(region)) <= kVolumeTolerance * volume(region)))
    return "TetGen's tetrahedra do not fill the volume inside this surface";
  return {};
}

/// Takes out points that are in no tetrahedron, beyond those of the surface.
void drop_unused_points(TetrahedralMesh& mesh, std::size_t of_surface) {
  std::vector<std::uint32_t> place(mesh.points.size());
  for (const Tetrahedron& t : mesh.tetrahedra)
    for (const std::uint32_t corner : t) place[corner] = 1;
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < place.size(); ++i) {
    const bool keep = i < of_surface || place[i] != 0;
    place[i] = kept;
    if (keep) mesh.points[kept++] = mesh.points[i];
  }
  mesh.points.resize(kept);
  for (Tetrahedron& t : mesh.tetrahedra)
    for (std::uint32_t& corner : t) corner = place[corner];
}

/// A program of ours that crashes is no fault of the surface, whatever drove it there.
[[noreturn]] void fail(const std::string& problem, bool mesher_failed) {
  if (mesher_failed)
    throw IoError(problem +
                  "; if it does so on every surface, install it again, or name another "
                  "with TRIPUS_TETGEN; else remesh this one more evenly");
  throw Unsupported(problem +
                    ", a fault of its own that very thin or very crowded parts can cause; remesh "
                    "the surface more evenly, or give a tetrahedral mesh");
}

/// Fills one region, in one way or another.
class Filler {
 public:
  Filler(const Region& region, const TetrahedralizeOptions& options)
      : region_(region),
        options_(options),
        exponent_(scale_exponent(region.surface.points)),
        points_(scaled(region.surface.points, exponent_)),
        deadline_(detail::now_in_seconds() + options.time_limit) {
    for (std::uint32_t c = 0; c < region.components.size(); ++c)
      if (c != region.outermost) holes_.push_back(point_in_hole(region, c));
    holes_ = scaled(std::move(holes_), exponent_);
  }

  /// With as few tetrahedra as it takes.
  TetrahedralMesh fill() {
    const auto count = static_cast<double>(region_.surface.triangles.size());
    const double short_try = kShortTry + kShortTryEach * count;
    for (const Attempt& attempt : kAttempts) {
      attempt_ = attempt;
      if (auto mesh = ask(attempt, 0, short_try)) return *std::move(mesh);
      require_time();
    }
    const double now = detail::now_in_seconds();
    if (auto mesh = detail::fill_by_planes(region_, options_.memory_limit,
                                           now + kPlanesShare * (deadline_ - now), options_.stop)) {
      by_planes_ = true;
      return *std::move(mesh);
    }
    require_time();
    attempt_ = kAttempts[0];  // with all the time that there is
    if (auto mesh = ask(attempt_, 0, deadline_ - detail::now_in_seconds())) return *std::move(mesh);
    require_time();
    fail(first_problem_, mesher_failed_);
  }

  /// Whether tetrahedra may be flat, or turned inside out, by rounding.
  bool is_rounded() const { return by_planes_; }

  /// Whether TetGen can add points inside and none on the boundary.
  bool can_refine() const { return !by_planes_ && attempt_.keep_boundary; }

  /// In the way that fill() found.
  TetrahedralMesh refined(double max_volume) {
    const double unit = std::ldexp(1.0, exponent_);
    // Nothing but 0 becomes 0.
    const double scaled_volume =
        std::fmax(max_volume * unit * unit * unit, std::numeric_limits<double>::min());
    first_problem_.clear();
    if (auto mesh = ask(attempt_, scaled_volume, deadline_ - detail::now_in_seconds()))
      return *std::move(mesh);
    require_time();
    fail(first_problem_, mesher_failed_);
  }

 private:
  std::optional<TetrahedralMesh> ask(const Attempt& attempt, double max_volume, double seconds) {
    Shuffled shuffled(points_, holes_, region_.surface.triangles, attempt.shuffle);
    detail::TetgenQuestion& question = shuffled.question;
    question.keep_boundary = attempt.keep_boundary;
    question.max_volume = max_volume;
    question.memory_limit = options_.memory_limit;
    question.processor_seconds = static_cast<std::uint64_t>(std::ceil(seconds));
    question.deadline = std::fmin(deadline_, detail::now_in_seconds() + kBusy * seconds);
    question.stop = options_.stop;
    detail::TetgenAnswer answer = detail::ask_tetgen(question);
    if (answer.out_of_memory)
      throw Unsupported(answer.problem + "; give it more, or a coarser surface");
    std::string problem = answer.problem;
    if (answer.mesh) {
      TetrahedralMesh& mesh = *answer.mesh;
      shuffled.turn_back(mesh);
      mesh.points = scaled(std::move(mesh.points), -exponent_);
      drop_unused_points(mesh, region_.surface.points.size());
      problem = make_positive(mesh) ? detail::boundary_fault(mesh, region_, options_.stop)
                                    : "TetGen made a flat tetrahedron on this surface";
      if (problem.empty()) problem = inside_fault(mesh, region_);
      if (problem.empty()) return std::move(answer.mesh);
    }
    if (first_problem_.empty()) first_problem_ = problem;
    mesher_failed_ = answer.mesher_failed;
    return std::nullopt;
  }

  void require_time() const {
    throw_if_stopped(options_.stop);
    if (detail::now_in_seconds() >= deadline_)
      throw Unsupported("TetGen was not done after " +
                        std::to_string(static_cast<long>(options_.time_limit)) +
                        " s; give it more time, or a coarser surface");
  }

  const Region& region_;
  const TetrahedralizeOptions& options_;
  int exponent_;
  std::vector<Point> points_, holes_;
  double deadline_;
  Attempt attempt_;
  bool by_planes_ = false;
  std::string first_problem_;
  bool mesher_failed_ = false;  ///< at the last try
};

/// The boundary alone may force more; else the largest volume is corrected a few times.
template <class Fill>
TetrahedralMesh fill_with_about(TetrahedralMesh best, std::size_t aim, double region_volume,
                                const Fill& fill) {
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
  const double most = static_cast<double>(options.memory_limit) / kBytesEach;
  if (options.max_volume > 0 && volume(region) / options.max_volume > most) {
    std::ostringstream text;
    text << "no tetrahedron larger than " << options.max_volume << ": that is more than "
         << volume(region) / options.max_volume << " tetrahedra, and memory is granted for " << most
         << "; allow larger ones";
    throw Unsupported(text.str());
  }
  Filler filler(region, options);
  TetrahedralMesh mesh = filler.fill();
  if (options.tetrahedra > 0 && filler.can_refine())
    mesh = fill_with_about(std::move(mesh), options.tetrahedra, volume(region),
                           [&](double max_volume) { return filler.refined(max_volume); });
  else if (options.max_volume > 0 && filler.can_refine())
    mesh = filler.refined(options.max_volume);
  if (!filler.is_rounded()) keep_promises(mesh, options.max_volume, options);
  return mesh;
}

}  // namespace tripus::meshing
