// Marching tetrahedra on the body-centred cubic lattice: even points at the corners of the cells,
// odd points in their middles. Each tetrahedron has one edge between even points, one between odd
// points and four short ones; four of them surround each even edge, and each is met once there.
//
// Topology depends on the signs at lattice points alone. Inside a tetrahedron the surface is one
// triangle or two that share a diagonal of a quadrilateral whose corners lie on four of its edges:
// wherever on the edges these stand, strictly inside them, the pieces are embedded, fit along the
// faces and leave the lattice points untouched. So crossings may be kept away from the lattice
// points (kClosest), and no triangle is small or thin.
#include <array>
#include <cmath>

#include "base/error.hpp"
#include "meshing/tube/detail/stages.hpp"

namespace tripus::meshing::tube {
namespace {

/// Numbers of the mesh vertices on lattice edges: a hash table with open addressing, keyed by the
/// two ends of an edge (60 bits each).
class EdgeVertices {
 public:
  EdgeVertices() : slots_(std::size_t{1} << 12) {}

  /// The vertex of the edge a b; `fresh` becomes it if there is none yet.
  std::uint32_t find_or_add(std::uint64_t a, std::uint64_t b, std::uint32_t fresh) {
    if (2 * (count_ + 1) > slots_.size()) grow();
    Slot& slot = slot_of(slots_, a, b);
    if (slot.vertex == kFree) {
      slot = {a, b, fresh};
      ++count_;
    }
    return slot.vertex;
  }

 private:
  static constexpr std::uint32_t kFree = 0xffffffff;
  struct Slot {
    std::uint64_t a = 0, b = 0;
    std::uint32_t vertex = kFree;
  };

  static Slot& slot_of(std::vector<Slot>& slots, std::uint64_t a, std::uint64_t b) {
    std::uint64_t h = a * 0x9e3779b97f4a7c15u ^ b * 0xc2b2ae3d27d4eb4fu;
    h ^= h >> 29;
    h *= 0xbf58476d1ce4e5b9u;
    h ^= h >> 32;
    const std::size_t mask = slots.size() - 1;
    std::size_t i = h & mask;
    while (slots[i].vertex != kFree && (slots[i].a != a || slots[i].b != b)) i = (i + 1) & mask;
    return slots[i];
  }

  void grow() {
    std::vector<Slot> larger(2 * slots_.size());
    for (const Slot& slot : slots_)
      if (slot.vertex != kFree) slot_of(larger, slot.a, slot.b) = slot;
    slots_ = std::move(larger);
  }

  std::vector<Slot> slots_;
  std::size_t count_ = 0;
};

/// A crossing stays this far from the ends of its lattice edge, as a part of the edge.
constexpr double kClosest = 0.15;

/// Cells along the side of a block that is sampled densely.
constexpr int kBlock = 4;

constexpr std::uint64_t kMostCells = std::uint64_t{1} << 19;

struct LatticePoint {
  std::uint64_t key;  ///< doubled coordinates, 20 bits each
  double value;
  Point point;
};

class Marcher {
 public:
  Marcher(const TubeRegion& region, double cell, std::size_t most_triangles, const Pulse& pulse)
      : region_(region), cell_(cell), most_triangles_(most_triangles), pulse_(pulse) {
    const Bounds bounds = region.bounds();
    double size = 0;
    for (int k = 0; k < 3; ++k) size = std::max(size, bounds.high[k] - bounds.low[k]);
    cells_ = kBlock;
    while (double(cells_) * cell < size + 4 * cell) cells_ *= 2;
    if (cells_ > kMostCells) throw InternalError("the grid of a tube's surface is too fine");
    const double half = 0.5 * double(cells_) * cell;
    origin_ = bounds.center() - Point{half, half, half};
  }

  SurfaceMesh run() {
    visit({0, 0, 0}, cells_);
    return std::move(mesh_);
  }

 private:
  using Index = std::array<std::uint64_t, 3>;

  Point place(const Index& doubled) const {
    return {origin_[0] + 0.5 * cell_ * double(doubled[0]),
            origin_[1] + 0.5 * cell_ * double(doubled[1]),
            origin_[2] + 0.5 * cell_ * double(doubled[2])};
  }

  /// Goes down to the blocks near the surface. The function changes no faster than the place.
  void visit(const Index& low, std::uint64_t size) {
    pulse_();
    const Point center = place({2 * low[0] + size, 2 * low[1] + size, 2 * low[2] + size});
    // The tetrahedra at a block's edges reach half a cell beyond it; fillets go beyond the tube.
    const double reach = std::sqrt(3.0) * 0.5 * double(size + 1) * cell_ +
                         TubeRegion::kFilletHeight * region_.fillet();
    if (std::abs(region_.full_value(center)) > 1.0001 * reach) return;
    if (size == kBlock) return sample(low);
    const std::uint64_t half = size / 2;
    for (std::uint64_t child = 0; child < 8; ++child)
      visit({low[0] + half * (child & 1), low[1] + half * (child >> 1 & 1),
             low[2] + half * (child >> 2)},
            half);
  }

  void sample(const Index& low) {
    constexpr int n = kBlock;
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j)
        for (int k = 0; k <= n; ++k) {
          even_[i][j][k] = lattice_point(low, 2 * i, 2 * j, 2 * k);
          odd_[i][j][k] = lattice_point(low, 2 * i - 1, 2 * j - 1, 2 * k - 1);
        }
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        for (int k = 0; k < n; ++k)
          for (int axis = 0; axis < 3; ++axis) around_edge({i, j, k}, axis);
  }

  LatticePoint lattice_point(const Index& low, int i, int j, int k) const {
    // The root cube has a margin of 2 cells, so that -1 along its side is never near the surface;
    // there the coordinate wraps, and nothing is drawn.
    const Index doubled{2 * low[0] + std::uint64_t(i), 2 * low[1] + std::uint64_t(j),
                        2 * low[2] + std::uint64_t(k)};
    const Point p{origin_[0] + 0.5 * cell_ * double(std::int64_t(doubled[0])),
                  origin_[1] + 0.5 * cell_ * double(std::int64_t(doubled[1])),
                  origin_[2] + 0.5 * cell_ * double(std::int64_t(doubled[2]))};
    constexpr std::uint64_t mask = (std::uint64_t{1} << 20) - 1;
    return {(doubled[0] & mask) | (doubled[1] & mask) << 20 | (doubled[2] & mask) << 40,
            region_.value(p), p};
  }

  /// The four tetrahedra around the even edge from cell c along an axis.
  void around_edge(const std::array<int, 3>& c, int axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    std::array<int, 3> next = c;
    ++next[axis];
    const LatticePoint &a = even_[c[0]][c[1]][c[2]], &b = even_[next[0]][next[1]][next[2]];
    std::array<const LatticePoint*, 4> ring;
    for (int m = 0; m < 4; ++m) {
      std::array<int, 3> o{c[0] + 1, c[1] + 1, c[2] + 1};
      if (m == 1 || m == 2) --o[u];
      if (m == 2 || m == 3) --o[v];
      ring[m] = &odd_[o[0]][o[1]][o[2]];
    }
    for (int m = 0; m < 4; ++m) tetrahedron({&a, &b, ring[m], ring[(m + 1) % 4]});
  }

  /// A tetrahedron a b c d with det(b - a, c - a, d - a) > 0.
  void tetrahedron(std::array<const LatticePoint*, 4> t) {
    const auto inside = [](const LatticePoint* p) { return p->value < 0; };
    const int count = int(std::count_if(t.begin(), t.end(), inside));
    if (count == 0 || count == 4) return;
    // Even permutations bring the odd one out, or the pair inside, to the front.
    if (count == 2) {
      if (inside(t[0]) != inside(t[1])) {
        const int partner = inside(t[0]) == inside(t[2]) ? 2 : 3;
        if (partner == 2)
          t = {t[0], t[2], t[3], t[1]};
        else
          t = {t[0], t[3], t[1], t[2]};
      }
      if (!inside(t[0])) t = {t[2], t[3], t[0], t[1]};
      quadrilateral(crossing(*t[0], *t[2]), crossing(*t[0], *t[3]), crossing(*t[1], *t[3]),
                    crossing(*t[1], *t[2]));
      return;
    }
    const bool lone = count == 1;
    if (inside(t[1]) == lone) t = {t[1], t[0], t[3], t[2]};
    if (inside(t[2]) == lone) t = {t[2], t[3], t[0], t[1]};
    if (inside(t[3]) == lone) t = {t[3], t[2], t[1], t[0]};
    const std::uint32_t x = crossing(*t[0], *t[1]), y = crossing(*t[0], *t[2]),
                        z = crossing(*t[0], *t[3]);
    if (lone)
      triangle(x, y, z);
    else
      triangle(x, z, y);
  }

  std::uint32_t crossing(const LatticePoint& p, const LatticePoint& q) {
    const LatticePoint& a = p.key < q.key ? p : q;
    const LatticePoint& b = p.key < q.key ? q : p;
    const auto fresh = std::uint32_t(mesh_.points.size());
    const std::uint32_t vertex = vertices_.find_or_add(a.key, b.key, fresh);
    if (vertex == fresh) {
      const double t = std::clamp(a.value / (a.value - b.value), kClosest, 1 - kClosest);
      mesh_.points.push_back((1 - t) * a.point + t * b.point);
    }
    return vertex;
  }

  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (mesh_.triangles.size() >= most_triangles_)
      throw InvalidInput("the surface needs more than " + std::to_string(most_triangles_) +
                         " triangles; choose fewer, or a radius nearer to half of the room");
    mesh_.triangles.push_back({a, b, c});
  }

  void quadrilateral(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    const auto& p = mesh_.points;
    if (distance(p[a], p[c]) <= distance(p[b], p[d])) {
      triangle(a, b, c);
      triangle(a, c, d);
    } else {
      triangle(a, b, d);
      triangle(b, c, d);
    }
  }

  const TubeRegion& region_;
  double cell_;
  std::size_t most_triangles_;
  const Pulse& pulse_;
  std::uint64_t cells_ = 0;
  Point origin_{};
  LatticePoint even_[kBlock + 1][kBlock + 1][kBlock + 1];
  LatticePoint odd_[kBlock + 1][kBlock + 1][kBlock + 1];  ///< [i] lies before even_[i]
  EdgeVertices vertices_;
  SurfaceMesh mesh_;
};

}  // namespace

SurfaceMesh march(const TubeRegion& region, double cell, std::size_t most_triangles,
                  const Pulse& pulse) {
  return Marcher(region, cell, most_triangles, pulse).run();
}

}  // namespace tripus::meshing::tube
