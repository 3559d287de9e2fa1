// Each joint is the convex hull of the rings of its pipes, which lie on a sphere around it. The
// plane of a ring cuts off a cap of that sphere with no other point in it, so the ring is a facet
// of the hull; there the pipe is attached, on the other side of that plane.
#include <cmath>
#include <numbers>

#include "meshing/tube/detail/convex_hull.hpp"
#include "meshing/tube/detail/outer_surface.hpp"
#include "meshing/tube/detail/stages.hpp"

namespace tripus::meshing::tube {
namespace {

class PipeBuilder {
 public:
  explicit PipeBuilder(const PipePlan& plan) : plan_(plan), rings_(plan.pipes.size()) {}

  std::optional<SurfaceMesh> make() {
    for (std::size_t p = 0; p < plan_.pipes.size(); ++p) add_pipe(p);
    for (std::uint32_t j = 0; j < plan_.joints.size(); ++j)
      if (!plan_.joints[j].pipes.empty() && !plan_.joints[j].opening && !add_joint(j))
        return std::nullopt;
    if (!plan_.outer.exists()) return std::move(mesh_);
    // So far all faces out of the tube; the piece of space is what is around that.
    for (Triangle& t : mesh_.triangles) std::swap(t[1], t[2]);
    std::vector<Opening> openings;
    for (std::size_t p = 0; p < plan_.pipes.size(); ++p)
      for (const bool at_a : {true, false})
        if (plan_.joints[at_a ? plan_.pipes[p].a : plan_.pipes[p].b].opening)
          openings.push_back(ring_from_outside(std::uint32_t(p), at_a));
    if (!add_outer_polyhedron(mesh_, plan_.outer, openings)) return std::nullopt;
    return std::move(mesh_);
  }

 private:
  /// The rings of a pipe, both counterclockwise as seen from its end b.
  struct Rings {
    std::uint32_t at_a, at_b;  ///< the first of three points each
  };

  std::uint32_t add_ring(const Point& center, double radius, const Point& x, const Point& y) {
    const auto first = std::uint32_t(mesh_.points.size());
    for (int k = 0; k < 3; ++k) {
      const double angle = 2 * std::numbers::pi * k / 3;
      mesh_.points.push_back(center + (radius * std::cos(angle)) * x +
                             (radius * std::sin(angle)) * y);
    }
    return first;
  }

  /// Where the ring of a pipe has its middle: on the sphere of the joint, or on the outer surface.
  Point middle_of_ring(const Joint& joint, double radius, const Point& along) const {
    if (!joint.opening)
      return joint.point + std::sqrt(joint.radius * joint.radius - radius * radius) * along;
    if (!plan_.outer.is_sphere()) return joint.point;
    const Bounds bounds = plan_.outer.bounds();
    const double r = 0.5 * (bounds.high[0] - bounds.low[0]);
    return bounds.center() + std::sqrt(r * r - radius * radius) * joint.normal;
  }

  void add_pipe(std::size_t p) {
    const Pipe& pipe = plan_.pipes[p];
    const Joint &a = plan_.joints[pipe.a], &b = plan_.joints[pipe.b];
    const Point z = b.opening ? b.normal : unit(b.point - a.point);
    const std::size_t least = std::abs(z[0]) < std::abs(z[1])
                                  ? (std::abs(z[0]) < std::abs(z[2]) ? 0 : 2)
                                  : (std::abs(z[1]) < std::abs(z[2]) ? 1 : 2);
    Point axis{0, 0, 0};
    axis[least] = 1;
    const Point x = unit(cross(axis, z)), y = cross(z, x);
    const std::uint32_t i = add_ring(middle_of_ring(a, pipe.radius_a, z), pipe.radius_a, x, y);
    const std::uint32_t j =
        add_ring(middle_of_ring(b, pipe.radius_b, -1.0 * z), pipe.radius_b, x, y);
    rings_[p] = {i, j};
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t next = (k + 1) % 3;
      mesh_.triangles.push_back({i + k, i + next, j + next});
      mesh_.triangles.push_back({i + k, j + next, j + k});
    }
  }

  /// The ring of pipe p at one end, counterclockwise as seen from within the pipe.
  Triangle ring_from_inside(std::uint32_t p, bool at_a) const {
    const std::uint32_t i = at_a ? rings_[p].at_a : rings_[p].at_b;
    return at_a ? Triangle{i, i + 1, i + 2} : Triangle{i, i + 2, i + 1};
  }
  Triangle ring_from_outside(std::uint32_t p, bool at_a) const {
    const Triangle t = ring_from_inside(p, at_a);
    return {t[0], t[2], t[1]};
  }

  bool add_joint(std::uint32_t j) {
    const Joint& joint = plan_.joints[j];
    std::vector<Triangle> rings;
    std::vector<std::uint32_t> names;
    for (const std::uint32_t p : joint.pipes) {
      rings.push_back(ring_from_inside(p, plan_.pipes[p].a == j));
      names.insert(names.end(), rings.back().begin(), rings.back().end());
    }
    if (joint.pipes.size() == 1) {  // a dead end
      const Pipe& pipe = plan_.pipes[joint.pipes[0]];
      const Point far = plan_.joints[pipe.a == j ? pipe.b : pipe.a].point;
      names.push_back(std::uint32_t(mesh_.points.size()));
      mesh_.points.push_back(joint.point - joint.radius * unit(far - joint.point));
    }
    std::vector<Triangle> facets = ConvexHull(mesh_.points, names).facets();
    if (!take_out(facets, rings)) return false;
    mesh_.triangles.insert(mesh_.triangles.end(), facets.begin(), facets.end());
    return true;
  }

  const PipePlan& plan_;
  std::vector<Rings> rings_;
  SurfaceMesh mesh_;
};

}  // namespace

std::optional<SurfaceMesh> pipe_surface(const PipePlan& plan) { return PipeBuilder(plan).make(); }

}  // namespace tripus::meshing::tube
