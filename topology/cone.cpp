#include "topology/cone.hpp"

#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "topology/edge_walk.hpp"

// A boundary edge lies on two open faces; the walk around it, through the inside, leads from one to
// the other. So the cones over two neighbouring faces are found and glued in one step, and the
// walks cost O(T) together.
//
// The same walks tell whether the surface is one: at a vertex of it the link must be a disc, that
// is, have Euler characteristic 1 and one boundary circle. Circles are counted by following the
// boundary edges from cone to cone around the vertex.

namespace tripus::topology {
namespace {

constexpr std::uint32_t kNoNumber = 0xffffffffu;

/// The open faces in order, and the number of each.
struct OpenFaceList {
  explicit OpenFaceList(const Gluings& gluings)
      : number(4 * gluings.tetrahedron_count(), kNoNumber) {
    for (std::size_t t = 0; t < gluings.tetrahedron_count(); ++t)
      for (int f = 0; f < 4; ++f)
        if (gluings.is_open(t, f)) {
          number[4 * t + static_cast<std::size_t>(f)] = static_cast<std::uint32_t>(faces.size());
          faces.emplace_back(static_cast<TetrahedronIndex>(t), f);
        }
  }
  std::vector<std::pair<TetrahedronIndex, int>> faces;
  std::vector<std::uint32_t> number;  // [T x 4]
};

/// The labels of the cone over face f in terms of those of the tetrahedron below: an odd
/// permutation that keeps f, the label of the new vertex.
Perm4 cone_labels(int f) {
  std::array<int, 4> images{0, 1, 2, 3};
  std::swap(images[static_cast<std::size_t>((f + 1) % 4)],
            images[static_cast<std::size_t>((f + 2) % 4)]);
  return Perm4::from_images(images[0], images[1], images[2], images[3]);
}

void add_cones(const OpenFaceList& open, std::size_t inside, Gluings& gluings) {
  gluings.resize(inside + open.faces.size());
  for (std::size_t k = 0; k < open.faces.size(); ++k) {
    const auto [t, f] = open.faces[k];
    const auto cone = static_cast<TetrahedronIndex>(inside + k);
    const Perm4 labels = cone_labels(f);
    gluings.glue(t, f, cone, labels);
    for (int x = 0; x < 4; ++x) {
      if (x == f || !gluings.is_open(cone, labels(x))) continue;
      // Around the side of the face opposite x, away from the open face.
      std::array<int, 2> ends{};
      std::size_t size = 0;
      for (int v = 0; v < 4; ++v)
        if (v != x && v != f) ends[size++] = v;
      EdgeWalk walk{t, ends[0], ends[1], x, f};
      while (gluings.neighbour(walk.t, walk.c) < inside) walk.step(gluings);
      const std::size_t far = open.number[4 * walk.t + static_cast<std::size_t>(walk.c)];
      std::array<int, 4> images{};
      images[static_cast<std::size_t>(ends[0])] = walk.a;
      images[static_cast<std::size_t>(ends[1])] = walk.b;
      images[static_cast<std::size_t>(x)] = walk.d;
      images[static_cast<std::size_t>(f)] = walk.c;
      const Perm4 across = Perm4::from_images(images[0], images[1], images[2], images[3]);
      gluings.glue(cone, labels(x), static_cast<TetrahedronIndex>(inside + far),
                   cone_labels(walk.c) * across * labels.inverse());
    }
  }
}

/// Classes of the corners 4 t + v below the cones, in order of their first corners.
std::vector<std::uint32_t> vertex_classes(const Gluings& gluings, std::size_t inside,
                                          std::vector<std::uint32_t>& first_corner) {
  std::vector<std::uint32_t> classes(4 * inside, kNoNumber);
  std::vector<std::uint32_t> stack;
  for (std::uint32_t first = 0; first < 4 * inside; ++first) {
    if (classes[first] != kNoNumber) continue;
    const auto number = static_cast<std::uint32_t>(first_corner.size());
    first_corner.push_back(first);
    classes[first] = number;
    stack.push_back(first);
    while (!stack.empty()) {
      const std::uint32_t here = stack.back();
      stack.pop_back();
      const int v = static_cast<int>(here % 4);
      for (int f = 0; f < 4; ++f) {
        const TetrahedronIndex other = gluings.neighbour(here / 4, f);
        if (f == v || other >= inside) continue;
        const std::uint32_t there =
            4 * other + static_cast<std::uint32_t>(gluings.gluing(here / 4, f)(v));
        if (classes[there] != kNoNumber) continue;
        classes[there] = number;
        stack.push_back(there);
      }
    }
  }
  return classes;
}

/// Circles of open faces around each vertex class.
std::vector<std::uint32_t> boundary_circles(const Gluings& gluings, const OpenFaceList& open,
                                            std::size_t inside,
                                            const std::vector<std::uint32_t>& classes,
                                            std::size_t class_count) {
  std::vector<std::uint32_t> circles(class_count, 0);
  std::vector<bool> seen(4 * open.faces.size(), false);
  for (std::size_t k = 0; k < open.faces.size(); ++k) {
    const auto [t, f] = open.faces[k];
    const Perm4 labels = cone_labels(f);
    for (int v = 0; v < 4; ++v) {
      if (v == f || seen[4 * k + static_cast<std::size_t>(labels(v))]) continue;
      ++circles[classes[4 * t + static_cast<std::size_t>(v)]];
      // From cone to cone around the edge between the new vertex and v.
      EdgeWalk walk{inside + k, f, labels(v), -1, -1};
      for (int x = 3; x >= 0; --x)
        if (x != walk.a && x != walk.b) (walk.c < 0 ? walk.c : walk.d) = x;
      while (!seen[4 * (walk.t - inside) + static_cast<std::size_t>(walk.b)]) {
        seen[4 * (walk.t - inside) + static_cast<std::size_t>(walk.b)] = true;
        walk.step(gluings);
      }
    }
  }
  return circles;
}

/// Marks every corner of an edge below the cones. Returns the number of link vertices that are its
/// ends: 1 if it is its own reverse, which is for others to refuse.
int mark_edge(const Gluings& gluings, std::size_t inside, const EdgeWalk& start,
              std::vector<std::uint8_t>& met) {
  EdgeWalk walk = start;
  for (int way = 0; way < 2; ++way) {
    while (true) {
      met[walk.t] = static_cast<std::uint8_t>(met[walk.t] | 1u << walk.edge());
      if (gluings.neighbour(walk.t, walk.c) >= inside) break;
      walk.step(gluings);
      if (walk.t == start.t && walk.edge() == start.edge())
        return walk.reversed() == start.reversed() ? 2 : 1;
    }
    walk = start;
    std::swap(walk.c, walk.d);
  }
  return 2;
}

/// Euler characteristics of the links below the cones.
std::vector<std::int64_t> euler_characteristics(const Gluings& gluings, std::size_t inside,
                                                const std::vector<std::uint32_t>& classes,
                                                std::size_t class_count) {
  std::vector<std::int64_t> doubled(class_count, 0);  // a side shared by two counts half in each
  for (std::size_t t = 0; t < inside; ++t)
    for (int v = 0; v < 4; ++v) {
      std::int64_t& here = doubled[classes[4 * t + static_cast<std::size_t>(v)]];
      here += 2;
      for (int f = 0; f < 4; ++f)
        if (f != v) here -= gluings.neighbour(t, f) >= inside ? 2 : 1;
    }
  std::vector<std::uint8_t> met(inside, 0);  // a bit an edge
  for (std::size_t t = 0; t < inside; ++t)
    for (int e = 0; e < 6; ++e) {
      if ((met[t] >> e & 1) != 0) continue;
      const auto [a, b] = kEdgeEnds[static_cast<std::size_t>(e)];
      doubled[classes[4 * t + static_cast<std::size_t>(a)]] += 2;
      if (mark_edge(gluings, inside, EdgeWalk::start(t, e), met) == 2)
        doubled[classes[4 * t + static_cast<std::size_t>(b)]] += 2;
    }
  for (std::int64_t& value : doubled) value /= 2;
  return doubled;
}

void require_surface(const Gluings& coned, const OpenFaceList& open, std::size_t inside) {
  std::vector<std::uint32_t> first_corner;
  const auto classes = vertex_classes(coned, inside, first_corner);
  const std::size_t count = first_corner.size();
  const auto circles = boundary_circles(coned, open, inside, classes, count);
  const auto euler = euler_characteristics(coned, inside, classes, count);
  for (std::size_t v = 0; v < count; ++v) {
    if (circles[v] == 0 || (circles[v] == 1 && euler[v] == 1)) continue;
    const std::string place = "vertex " + std::to_string(first_corner[v] % 4) + " of tetrahedron " +
                              std::to_string(first_corner[v] / 4);
    if (circles[v] > 1)
      throw InvalidInput("the boundary surface is pinched at " + place + ": " +
                         std::to_string(circles[v]) +
                         " sheets of it meet there; pull the sheets apart or fill the gap between "
                         "them");
    throw InvalidInput("the link of " + place +
                       ", which lies on the boundary, is not a disc (Euler characteristic " +
                       std::to_string(euler[v]) + "); the gluings are no manifold there");
  }
}

}  // namespace

Gluings cone_boundary(const Gluings& gluings) {
  require_consistent(gluings, OpenFaces::kAllowed);
  const OpenFaceList open(gluings);
  if (open.faces.empty()) return gluings;
  const std::size_t inside = gluings.tetrahedron_count();
  if (inside + open.faces.size() > kMaxTetrahedra)
    throw InvalidInput("coning " + std::to_string(open.faces.size()) +
                       " boundary faces would make more than the " +
                       std::to_string(kMaxTetrahedra) +
                       " tetrahedra that a triangulation can have");
  Gluings coned = gluings;
  add_cones(open, inside, coned);
  require_surface(coned, open, inside);
  return coned;
}

}  // namespace tripus::topology
