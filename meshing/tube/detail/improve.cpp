#include <queue>
#include <tuple>

#include "meshing/tube/detail/stages.hpp"

namespace tripus::meshing::tube {
namespace {

/// Triangles below this quality are made only where there was a worse one.
constexpr double kGoodQuality = 0.3;

/// On the outer surface edges may be longer by 1 for each kGrowth radii from the tube, up to
/// kLongest times.
constexpr double kGrowth = 2;
constexpr double kLongest = 4;

/// Length that an edge at p should have, as a multiple of one on the tube.
double relative_size(const TubeRegion& region, const Point& p) {
  const double r = region.radius(), far = r * (1 + kGrowth * (kLongest - 1));
  return 1 + std::max(region.graph_distance(p, far) - r, 0.0) / (kGrowth * r);
}

class Coarsener {
 public:
  Coarsener(GuardedSurface& surface, const TubeRegion& region) : surface_(surface) {
    sizes_.reserve(surface.point_count());
    for (std::uint32_t v = 0; v < surface.point_count(); ++v)
      sizes_.push_back(relative_size(region, surface.point(v)));
  }

  void run(std::size_t target, const Pulse& pulse) {
    for (std::uint32_t v = 0; v < surface_.point_count(); ++v) push_edges(v, true);
    for (std::size_t step = 0; surface_.triangle_count() > target && !queue_.empty(); ++step) {
      if (step % 1024 == 0) pulse();
      const Candidate c = queue_.top();
      queue_.pop();
      if (!surface_.adjacent(c.u, c.v)) continue;
      if (cost(c.u, c.v) != c.cost) continue;  // a newer one is in the queue
      if (surface_.collapse(c.u, c.v, kGoodQuality))
        push_edges(c.v, false);
      else if (surface_.collapse(c.v, c.u, kGoodQuality))
        push_edges(c.u, false);
    }
  }

 private:
  struct Candidate {
    double cost;
    std::uint32_t u, v;
    friend bool operator<(const Candidate& a, const Candidate& b) {
      return std::tie(b.cost, b.u, b.v) < std::tie(a.cost, a.u, a.v);
    }
  };

  double cost(std::uint32_t u, std::uint32_t v) const {
    return distance(surface_.point(u), surface_.point(v)) / (sizes_[u] + sizes_[v]);
  }

  /// The edges at v; of each only one direction if `once`.
  void push_edges(std::uint32_t v, bool once) {
    for (const std::uint32_t t : surface_.star(v)) {
      const Triangle& c = surface_.triangle(t);
      const int at = c[0] == v ? 0 : c[1] == v ? 1 : 2;
      const std::uint32_t next = c[(at + 1) % 3];
      if (!once || v < next) queue_.push({cost(v, next), v, next});
    }
  }

  GuardedSurface& surface_;
  std::vector<double> sizes_;
  std::priority_queue<Candidate> queue_;
};

/// The middle of a vertex's neighbours.
Point middle_of_ring(const GuardedSurface& surface, std::uint32_t v) {
  Point sum{0, 0, 0};
  const auto star = surface.star(v);
  for (const std::uint32_t t : star) {
    const Triangle& c = surface.triangle(t);
    const int at = c[0] == v ? 0 : c[1] == v ? 1 : 2;
    sum = sum + surface.point(c[(at + 1) % 3]);
  }
  return (1 / double(star.size())) * sum;
}

}  // namespace

void relax(GuardedSurface& surface, const TubeRegion& region, int sweeps, const Pulse& pulse) {
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (std::uint32_t v = 0; v < surface.point_count(); ++v) {
      if (v % 1024 == 0) pulse();
      if (surface.star(v).empty()) continue;
      const Point& here = surface.point(v);
      const Point goal = region.projected(0.5 * (here + middle_of_ring(surface, v)));
      // A goal that is out of reach may be approached.
      if (!surface.move(v, goal, kGoodQuality)) surface.move(v, 0.5 * (here + goal), kGoodQuality);
    }
}

void coarsen(GuardedSurface& surface, const TubeRegion& region, std::size_t target,
             const Pulse& pulse) {
  if (surface.triangle_count() > target) Coarsener(surface, region).run(target, pulse);
}

}  // namespace tripus::meshing::tube
