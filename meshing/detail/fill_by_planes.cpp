// A binary space partition, as H. Fuchs, Z. Kedem and B. Naylor (1980) build it, with the cells
// kept as polyhedra that fit together along whole faces. A triangle goes down the tree, split by
// the planes that are there, and cuts each cell that a piece of it ends up in. At the end every
// face of a cell lies on the surface or has nothing of it inside: where a triangle ends within a
// face, its neighbour leaves the plane and has cut a cell beside the face there, and the face with
// it; or it goes on in the plane.
#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "base/error.hpp"
#include "base/stop.hpp"
#include "meshing/detail/child_process.hpp"
#include "meshing/detail/convex_cells.hpp"
#include "meshing/detail/filling.hpp"
#include "meshing/detail/triangle_tree.hpp"

namespace tripus::meshing::detail {
namespace {

constexpr std::uint32_t kNoCell = ConvexCells::kNone;

/// Bytes for a cell with its share of faces, edges and points; measured, and doubled.
constexpr std::uint64_t kBytesPerCell = 20'000;

/// Seed of the order in which triangles cut; any order will do, one along the surface is bad.
constexpr std::uint32_t kOrderSeed = 12;

/// Of an area of numbers that are each off by 2^-52 of the largest, in squares of that.
constexpr double kAreaRounding = 0x1p-46;

struct OutOfBudget {};

Box bounds_with_margin(const SurfaceMesh& surface) {
  Box box = box_of(surface.points);
  for (std::size_t k = 0; k < 3; ++k) {
    const double margin = 0.25 * (box.high[k] - box.low[k]);
    box.low[k] -= margin;
    box.high[k] += margin;
  }
  return box;
}

class PlaneFiller {
 public:
  PlaneFiller(const Region& region, std::uint64_t memory_limit, double deadline, const Stop& stop)
      : region_(region),
        box_(bounds_with_margin(region.surface)),
        cells_(box_.low, box_.high),
        most_cells_(memory_limit / kBytesPerCell),
        deadline_(deadline),
        stop_(stop) {}

  TetrahedralMesh make() {
    name_planes();
    cut_all();
    find_surface_faces();
    find_inside();
    return tetrahedra();
  }

 private:
  struct Node {
    std::uint32_t plane = kNoCell;  ///< kNoCell: a leaf
    std::uint32_t negative = 0;     ///< child, or the cell of a leaf
    std::uint32_t positive = 0;
  };
  using Polygon = std::vector<RationalPoint>;

  void tick() const {
    throw_if_stopped(stop_);
    if (now_in_seconds() > deadline_ || cells_.cells().size() > most_cells_) throw OutOfBudget{};
  }

  /// Triangles in one plane share it.
  void name_planes() {
    std::map<std::array<BigRational, 4>, std::uint32_t> names;
    const SurfaceMesh& surface = region_.surface;
    for (const Triangle& t : surface.triangles) {
      RationalPlane plane(surface.points[t[0]], surface.points[t[1]], surface.points[t[2]]);
      std::array<BigRational, 4> form = plane.exact;
      const auto first =
          std::find_if(form.begin(), form.end(), [](const BigRational& x) { return x != 0; });
      if (*first < 0)
        for (BigRational& x : form) x = -x;
      const auto [name, fresh] =
          names.emplace(std::move(form), static_cast<std::uint32_t>(planes_.size()));
      if (fresh) {
        planes_.push_back(std::move(plane));
        triangles_on_.emplace_back();
      }
      triangles_on_[name->second].push_back(static_cast<std::uint32_t>(plane_of_.size()));
      plane_of_.push_back(name->second);
    }
  }

  void cut_all() {
    nodes_.push_back({});  // a leaf with cell 0
    std::vector<std::uint32_t> order(region_.surface.triangles.size());
    for (std::uint32_t t = 0; t < order.size(); ++t) order[t] = t;
    std::mt19937 random(kOrderSeed);
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
    for (const std::uint32_t t : order) {
      tick();
      Polygon polygon;
      for (const std::uint32_t v : region_.surface.triangles[t])
        polygon.emplace_back(region_.surface.points[v]);
      insert(std::move(polygon), plane_of_[t]);
    }
  }

  void insert(Polygon whole, std::uint32_t plane) {
    std::vector<std::pair<std::uint32_t, Polygon>> todo;
    todo.emplace_back(0, std::move(whole));
    while (!todo.empty()) {
      const std::uint32_t n = todo.back().first;
      Polygon polygon = std::move(todo.back().second);
      todo.pop_back();
      if (nodes_[n].plane == kNoCell) {
        cut_leaf(n, plane);
        continue;
      }
      if (nodes_[n].plane == plane) continue;  // it lies in a face
      const RationalPlane& cutting = planes_[nodes_[n].plane];
      std::vector<int> sides;
      for (const RationalPoint& p : polygon) sides.push_back(cutting.side(p));
      const auto [least, most] = std::minmax_element(sides.begin(), sides.end());
      if (*least >= 0) {
        todo.emplace_back(nodes_[n].positive, std::move(polygon));
      } else if (*most <= 0) {
        todo.emplace_back(nodes_[n].negative, std::move(polygon));
      } else {
        todo.emplace_back(nodes_[n].positive, part(polygon, sides, cutting, 1));
        todo.emplace_back(nodes_[n].negative, part(polygon, sides, cutting, -1));
      }
    }
  }

  void cut_leaf(std::uint32_t n, std::uint32_t plane) {
    const std::uint32_t cell = nodes_[n].negative;
    const std::uint32_t fresh = cells_.cut(cell, planes_[plane], plane);
    const auto child = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({kNoCell, cell, 0});
    nodes_.push_back({kNoCell, fresh, 0});
    nodes_[n] = {plane, child, child + 1};
  }

  /// The part of a convex polygon on one side.
  static Polygon part(const Polygon& polygon, const std::vector<int>& sides,
                      const RationalPlane& plane, int side) {
    Polygon result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const std::size_t next = (i + 1) % polygon.size();
      if (sides[i] * side >= 0) result.push_back(polygon[i]);
      if (sides[i] * sides[next] < 0) result.push_back(crossing(plane, polygon[i], polygon[next]));
    }
    return result;
  }

  void find_surface_faces() {
    component_at_.assign(cells_.faces().size(), kNoCell);
    for (std::size_t f = 0; f < cells_.faces().size(); ++f) {
      if (f % 1024 == 0) tick();
      const ConvexCells::Face& face = cells_.faces()[f];
      if (face.plane == kNoCell) continue;
      const std::size_t axis = axis_of(planes_[face.plane]);
      const RationalPoint inside = point_within(face.loop, axis);
      for (const std::uint32_t t : triangles_on_[face.plane])
        if (is_in_triangle(inside, t, axis)) {
          component_at_[f] = region_.component_of[t];
          break;
        }
    }
  }

  /// Sign of the area of a, b, c seen along an axis, by doubles where these are sure.
  static int area_sign(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c,
                       std::size_t axis) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    double size = 0;
    for (const RationalPoint* p : {&a, &b, &c})
      size = std::max({size, std::fabs(p->near[u]), std::fabs(p->near[v])});
    const double area = (b.near[u] - a.near[u]) * (c.near[v] - a.near[v]) -
                        (b.near[v] - a.near[v]) * (c.near[u] - a.near[u]);
    if (std::fabs(area) > kAreaRounding * size * size) return area > 0 ? 1 : -1;
    const BigRational exact = (b.exact[u] - a.exact[u]) * (c.exact[v] - a.exact[v]) -
                              (b.exact[v] - a.exact[v]) * (c.exact[u] - a.exact[u]);
    return sign_of(exact);
  }

  /// An axis along which a plane is not seen edge on.
  static std::size_t axis_of(const RationalPlane& plane) {
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k)
      if (std::fabs(plane.near[k]) > std::fabs(plane.near[axis])) axis = k;
    return axis;
  }

  /// A point of a face that is not on its rim; seen along an axis, where it need not lie in the
  /// plane of the face.
  RationalPoint point_within(const std::vector<std::uint32_t>& loop, std::size_t axis) const {
    const auto corner = [&](std::size_t i) -> const RationalPoint& {
      return cells_.points()[loop[i % loop.size()]];
    };
    std::size_t third = 2;  // not in line with the first two
    while (area_sign(corner(0), corner(1), corner(third), axis) == 0) ++third;
    const int way = area_sign(corner(0), corner(1), corner(third), axis);
    RationalPoint near(middle(loop));
    bool inside = true;
    for (std::size_t i = 0; inside && i < loop.size(); ++i)
      inside = area_sign(corner(i), corner(i + 1), near, axis) == way;
    if (inside) return near;
    std::array<BigRational, 3> sum;
    for (std::size_t k = 0; k < 3; ++k)
      sum[k] = (corner(0).exact[k] + corner(1).exact[k] + corner(third).exact[k]) / 3;
    return RationalPoint(std::move(sum));
  }

  bool is_in_triangle(const RationalPoint& p, std::uint32_t triangle, std::size_t axis) const {
    const Triangle& t = region_.surface.triangles[triangle];
    int least = 1, most = -1;
    for (std::size_t k = 0; k < 3; ++k) {
      const int sign = area_sign(RationalPoint(region_.surface.points[t[k]]),
                                 RationalPoint(region_.surface.points[t[(k + 1) % 3]]), p, axis);
      least = std::min(least, sign);
      most = std::max(most, sign);
    }
    return least >= 0 || most <= 0;
  }

  /// Marks what is reached from the cells given without crossing the surface; calls
  /// at_surface(component, cell beyond) where it would.
  template <class AtSurface>
  void flood(std::vector<std::uint32_t> todo, std::vector<bool>& reached,
             const AtSurface& at_surface) const {
    while (!todo.empty()) {
      const std::uint32_t c = todo.back();
      todo.pop_back();
      if (reached[c]) continue;
      reached[c] = true;
      for (const std::uint32_t f : cells_.cells()[c].faces) {
        const auto& sides = cells_.faces()[f].cells;
        const std::uint32_t next = sides[0] == c ? sides[1] : sides[0];
        if (next == kNoCell) continue;
        if (component_at_[f] != kNoCell)
          at_surface(component_at_[f], next);
        else
          todo.push_back(next);
      }
    }
  }

  void find_inside() {
    std::vector<std::uint32_t> outermost, behind;
    for (const ConvexCells::Face& face : cells_.faces())
      if (face.plane == kNoCell) outermost.push_back(face.cells[0]);
    std::vector<bool> outside(cells_.cells().size());
    flood(outermost, outside, [&](std::uint32_t component, std::uint32_t next) {
      if (component == region_.outermost) behind.push_back(next);
    });
    inside_.assign(cells_.cells().size(), false);
    flood(behind, inside_, [](std::uint32_t, std::uint32_t) {});
  }

  /// Whether the loop of a face runs counterclockwise as seen from the positive side of its plane.
  bool runs_around_normal(const ConvexCells::Face& face) const {
    const RationalPlane& plane = planes_[face.plane];
    const std::size_t axis = axis_of(plane);
    int way = 0;  // of a convex polygon: that of any three of its corners that are not in a line
    for (std::size_t i = 1; way == 0 && i + 1 < face.loop.size(); ++i)
      way = area_sign(cells_.points()[face.loop[0]], cells_.points()[face.loop[i]],
                      cells_.points()[face.loop[i + 1]], axis);
    return (way > 0) == (plane.near[axis] > 0);
  }

  /// Which side of a face's plane a cell is on.
  int side_of(const std::vector<std::uint32_t>& corners, const ConvexCells::Face& face) const {
    for (const std::uint32_t v : corners)
      if (std::find(face.loop.begin(), face.loop.end(), v) == face.loop.end())
        if (const int side = planes_[face.plane].side(cells_.points()[v]); side != 0) return side;
    throw InternalError("a convex cell is flat");
  }

  /// Cells get a point in the middle, and faces with more than three corners.
  TetrahedralMesh tetrahedra() const {
    TetrahedralMesh mesh;
    std::vector<std::uint32_t> numbers(cells_.points().size(), kNoCell);
    std::vector<std::uint32_t> face_middles(cells_.faces().size(), kNoCell);
    const auto add = [&](const Point& p) {
      mesh.points.push_back(p);
      return static_cast<std::uint32_t>(mesh.points.size() - 1);
    };
    const auto number = [&](std::uint32_t v) {
      if (numbers[v] == kNoCell) numbers[v] = add(cells_.points()[v].near);
      return numbers[v];
    };
    for (std::size_t c = 0; c < cells_.cells().size(); ++c) {
      if (!inside_[c]) continue;
      if (c % 256 == 0) tick();
      const std::vector<std::uint32_t> corners = cells_.corners(static_cast<std::uint32_t>(c));
      const std::uint32_t center = add(middle(corners));
      for (const std::uint32_t f : cells_.cells()[c].faces) {
        const ConvexCells::Face& face = cells_.faces()[f];
        // Counterclockwise as seen from the center is the positive order.
        const bool forward = runs_around_normal(face) == (side_of(corners, face) > 0);
        const std::size_t count = face.loop.size();
        if (count > 3 && face_middles[f] == kNoCell) face_middles[f] = add(middle(face.loop));
        for (std::size_t i = 0; i < (count == 3 ? 1 : count); ++i) {
          Tetrahedron t{number(face.loop[i]), number(face.loop[(i + 1) % count]),
                        count == 3 ? number(face.loop[2]) : face_middles[f], center};
          if (!forward) std::swap(t[0], t[1]);
          mesh.tetrahedra.push_back(t);
        }
      }
    }
    return mesh;
  }

  Point middle(const std::vector<std::uint32_t>& corners) const {
    Point sum{};
    for (const std::uint32_t v : corners)
      for (std::size_t k = 0; k < 3; ++k)
        sum[k] += cells_.points()[v].near[k] / static_cast<double>(corners.size());
    return sum;
  }

  const Region& region_;
  Box box_;
  ConvexCells cells_;
  std::uint64_t most_cells_;
  double deadline_;
  Stop stop_;
  std::vector<RationalPlane> planes_;
  std::vector<std::uint32_t> plane_of_;                   // [triangles]
  std::vector<std::vector<std::uint32_t>> triangles_on_;  // [planes]
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> component_at_;  // [faces] of the surface; kNoCell off it
  std::vector<bool> inside_;                 // [cells]
};

}  // namespace

std::optional<TetrahedralMesh> fill_by_planes(const Region& region, std::uint64_t memory_limit,
                                              double deadline, const Stop& stop) {
  try {
    return PlaneFiller(region, memory_limit, deadline, stop).make();
  } catch (const OutOfBudget&) {
    return std::nullopt;
  }
}

}  // namespace tripus::meshing::detail
