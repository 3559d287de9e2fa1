#include "topology/triangulation.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "topology/edge_walk.hpp"

// The skeleton is found by walking, not by union-find: around each edge class once (which gives
// its corners in cyclic order for nothing) and over each vertex link once. Every array is sized
// beforehand, so a tiny triangulation costs a handful of allocations and a large one no growth.

namespace tripus::topology {
namespace {

constexpr std::uint32_t kUnset = 0xffffffffu;

}  // namespace

Triangulation::Triangulation(Gluings gluings) : gluings_(std::move(gluings)) {
  if (gluings_.tetrahedron_count() == 0)
    throw InvalidInput("the triangulation has no tetrahedra; at least one is needed");
  require_consistent(gluings_, OpenFaces::kRefused);
  walk_edges();
  walk_vertex_links();
  walk_components();
}

void Triangulation::walk_edges() {
  const std::size_t count = tetrahedron_count();
  edge_class_.assign(6 * count, kUnset);
  corners_.reserve(6 * count);
  edge_start_.reserve(count + 2);
  edge_start_.push_back(0);
  for (std::size_t t = 0; t < count; ++t)
    for (int e = 0; e < 6; ++e) {
      if (edge_class(t, e) != kUnset) continue;
      const auto index = static_cast<std::uint32_t>(edge_start_.size() - 1);
      auto walk = EdgeWalk::start(t, e);
      // The walk permutes directed corners, so it returns to its start; it meets one of its own
      // corners before that only when it runs along it backwards.
      do {
        std::uint32_t& slot = edge_class_[6 * walk.t + static_cast<std::size_t>(walk.edge())];
        if (slot != kUnset)
          throw InvalidInput("edge " + std::to_string(std::min(walk.a, walk.b)) +
                             std::to_string(std::max(walk.a, walk.b)) + " of tetrahedron " +
                             std::to_string(walk.t) +
                             " is identified with its own reverse; the midpoint of such an edge "
                             "is not a manifold point, so the gluings must be changed");
        slot = index;
        corners_.emplace_back(walk.t, walk.edge(), walk.reversed());
        walk.step(gluings_);
      } while (walk.t != t || walk.edge() != e || walk.reversed());
      edge_start_.push_back(static_cast<std::uint32_t>(corners_.size()));
    }
}

void Triangulation::walk_vertex_links() {
  const std::size_t count = tetrahedron_count();
  vertex_class_.assign(4 * count, kUnset);
  std::vector<std::uint32_t> queue(4 * count);   // link triangles 4 t + v, class after class
  std::vector<std::uint8_t> flipped(4 * count);  // against the orientation that t induces
  std::size_t head = 0;
  std::size_t tail = 0;
  for (std::uint32_t first = 0; first < 4 * count; ++first) {
    if (vertex_class_[first] != kUnset) continue;
    const auto index = static_cast<std::uint32_t>(links_.size());
    VertexLink& link = links_.emplace_back();
    const std::size_t begin = tail;
    vertex_class_[first] = index;
    queue[tail++] = first;
    for (; head < tail; ++head) {
      const std::uint32_t here = queue[head];
      const std::size_t t = here / 4;
      const int v = static_cast<int>(here % 4);
      for (int f = 0; f < 4; ++f) {
        if (f == v) continue;
        const Perm4 p = gluings_.gluing(t, f);
        const std::uint32_t there = 4 * gluings_.neighbour(t, f) + static_cast<std::uint32_t>(p(v));
        // Induced orientations of neighbouring link triangles agree when the gluing is odd.
        const std::uint8_t flip = flipped[here] ^ static_cast<std::uint8_t>(!p.is_odd());
        if (vertex_class_[there] == kUnset) {
          vertex_class_[there] = index;
          flipped[there] = flip;
          queue[tail++] = there;
        } else if (flipped[there] != flip) {
          link.orientable = false;
        }
      }
    }
    link.triangle_count = static_cast<std::uint32_t>(tail - begin);
    // Triangles minus their sides; the link's vertices are the ends of edge classes.
    link.euler_characteristic = -static_cast<std::int32_t>(link.triangle_count / 2);
  }
  for (std::size_t e = 0; e < edge_count(); ++e) {
    const EdgeCorner corner = corners_[edge_start_[e]];
    for (const int end : kEdgeEnds[static_cast<std::size_t>(corner.edge())])
      ++links_[vertex_class(corner.tetrahedron(), end)].euler_characteristic;
  }
}

void Triangulation::walk_components() {
  enum : std::uint8_t { kNew, kUpright, kFlipped };
  const std::size_t count = tetrahedron_count();
  std::vector<std::uint8_t> state(count, kNew);
  std::vector<std::uint32_t> stack;
  stack.reserve(count);
  for (std::uint32_t first = 0; first < count; ++first) {
    if (state[first] != kNew) continue;
    ++component_count_;
    state[first] = kUpright;
    stack.push_back(first);
    while (!stack.empty()) {
      const std::uint32_t t = stack.back();
      stack.pop_back();
      for (int f = 0; f < 4; ++f) {
        const std::uint32_t other = gluings_.neighbour(t, f);
        const bool flipped = (state[t] == kFlipped) != !gluings_.gluing(t, f).is_odd();
        const std::uint8_t wanted = flipped ? kFlipped : kUpright;
        if (state[other] == kNew) {
          state[other] = wanted;
          stack.push_back(other);
        } else if (state[other] != wanted) {
          orientable_ = false;
        }
      }
    }
  }
}

std::size_t Triangulation::memory_bytes() const {
  const auto held = [](const auto& array) { return array.capacity() * sizeof(array[0]); };
  return gluings_.memory_bytes() + held(edge_class_) + held(vertex_class_) + held(edge_start_) +
         held(corners_) + held(links_);
}

}  // namespace tripus::topology
