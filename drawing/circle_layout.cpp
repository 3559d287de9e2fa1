#include "drawing/circle_layout.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>

#include "base/error.hpp"

// C. R. Collins, K. Stephenson, *A circle packing algorithm* (2003). The triangulated disc: nodes
// and pieces of arcs are vertices. A region whose walk meets every vertex once gets a vertex in its
// middle; where it comes back to one, a ring of vertices is put in between, so that no two
// vertices are joined twice. The outer region gets no middle.

namespace tripus::drawing {
namespace {

using topology::Dart;
using topology::Diagram;
using Vertex = std::size_t;
using Triangle = std::array<Vertex, 3>;  // counterclockwise

constexpr double kAngleTolerance = 1e-12;
constexpr int kMostRounds = 200'000;

/// Of three circles that touch each other, the angle at the centre of the one with radius x.
double angle_at(double x, double y, double z) {
  return 2 * std::atan(std::sqrt(y * z / (x * (x + y + z))));
}

class TriangulatedDisc {
 public:
  explicit TriangulatedDisc(const Diagram& diagram) : diagram_(&diagram) {
    count_ = diagram.node_count();
    of_dart_.resize(diagram.dart_count());
    for (Dart d = 0; d < diagram.dart_count(); ++d) {
      const Dart mate = diagram.mate(d);
      if (d > mate) continue;
      of_dart_[d].push_back(count_++);
      if (diagram.node(d) == diagram.node(mate)) of_dart_[d].push_back(count_++);
      of_dart_[mate].assign(of_dart_[d].rbegin(), of_dart_[d].rend());
    }
    const topology::DiagramRegions areas = topology::regions(diagram);
    std::vector<std::size_t> corners(areas.count(), 0);
    for (const std::uint32_t region : areas.of_dart) ++corners[region];
    const auto outer = std::ranges::max_element(corners) - corners.begin();
    for (std::size_t r = 0; r < areas.count(); ++r)
      fill(areas.start[r], static_cast<std::ptrdiff_t>(r) == outer);
  }

  std::vector<Disc> packed() {
    const std::vector<double> radii = solve();
    return place(radii);
  }
  const std::vector<Vertex>& of_dart(Dart d) const { return of_dart_[d]; }

 private:
  /// The vertices met on a walk around a region, counterclockwise seen from it.
  std::vector<Vertex> walk_around(Dart first) const {
    std::vector<Vertex> walk;
    Dart d = first;
    do {
      walk.push_back(diagram_->node(d));
      walk.insert(walk.end(), of_dart_[d].begin(), of_dart_[d].end());
      d = diagram_->along_region(d);
    } while (d != first);
    return walk;
  }

  void fill(Dart first, bool outer) {
    std::vector<Vertex> walk = walk_around(first);
    std::vector<Vertex> sorted = walk;
    std::ranges::sort(sorted);
    const std::size_t n = walk.size();
    if (std::ranges::adjacent_find(sorted) != sorted.end()) {
      const Vertex ring = std::exchange(count_, count_ + n);
      for (std::size_t i = 0; i < n; ++i) {
        const std::size_t j = (i + 1) % n;
        triangles_.push_back({walk[i], walk[j], ring + i});
        triangles_.push_back({walk[j], ring + j, ring + i});
      }
      std::iota(walk.begin(), walk.end(), ring);
    }
    if (outer) {
      boundary_ = walk;
      return;
    }
    const Vertex middle = count_++;
    for (std::size_t i = 0; i < n; ++i) triangles_.push_back({walk[i], walk[(i + 1) % n], middle});
  }

  std::vector<double> solve() const {
    std::vector<std::vector<std::pair<Vertex, Vertex>>> flowers(count_);
    for (const auto& [a, b, c] : triangles_) {
      flowers[a].emplace_back(b, c);
      flowers[b].emplace_back(c, a);
      flowers[c].emplace_back(a, b);
    }
    for (const Vertex v : boundary_) flowers[v].clear();
    std::vector<double> radii(count_, 1.0);
    for (int round = 0; round < kMostRounds; ++round) {
      double worst = 0;
      for (Vertex v = 0; v < count_; ++v) {
        if (flowers[v].empty()) continue;
        double sum = 0;
        for (const auto& [a, b] : flowers[v]) sum += angle_at(radii[v], radii[a], radii[b]);
        worst = std::max(worst, std::abs(sum - 2 * std::numbers::pi));
        // As if all its neighbours had one radius: the radius with which they would close up.
        const auto k = static_cast<double>(flowers[v].size());
        const double now = std::sin(sum / (2 * k)), wanted = std::sin(std::numbers::pi / k);
        radii[v] *= now / (1 - now) * (1 - wanted) / wanted;
      }
      if (worst < kAngleTolerance) return radii;
    }
    return radii;
  }

  std::vector<Disc> place(const std::vector<double>& radii) const {
    std::map<std::pair<Vertex, Vertex>, Vertex> third;
    for (const auto& [a, b, c] : triangles_)
      third[{a, b}] = c, third[{b, c}] = a, third[{c, a}] = b;
    std::vector<Disc> discs(count_);
    std::vector<bool> placed(count_, false);
    const auto [a, b, c] = triangles_.front();
    discs[a] = {0, radii[a]};
    discs[b] = {radii[a] + radii[b], radii[b]};
    placed[a] = placed[b] = true;
    std::vector<std::pair<Vertex, Vertex>> queue{{a, b}, {b, a}};
    for (std::size_t i = 0; i < queue.size(); ++i) {
      const auto [from, to] = queue[i];
      const auto found = third.find({from, to});
      if (found == third.end()) continue;  // the rim, or a triangle seen before
      const Vertex v = found->second;
      for (const auto& edge : {std::pair(from, to), std::pair(to, v), std::pair(v, from)})
        third.erase(edge);
      queue.insert(queue.end(), {{v, to}, {from, v}});
      if (placed[v]) continue;
      const double turn = angle_at(radii[from], radii[to], radii[v]);
      const Point along = (discs[to].centre - discs[from].centre) / (radii[from] + radii[to]);
      discs[v] = {discs[from].centre + (radii[from] + radii[v]) * along * std::polar(1.0, turn),
                  radii[v]};
      placed[v] = true;
    }
    return discs;
  }

  const Diagram* diagram_;
  std::size_t count_ = 0;
  std::vector<std::vector<Vertex>> of_dart_;
  std::vector<Triangle> triangles_;
  std::vector<Vertex> boundary_;
};

CircleLayout layout_of_piece(const Diagram& piece) {
  TriangulatedDisc disc(piece);
  const std::vector<Disc> all = disc.packed();
  CircleLayout layout;
  layout.nodes.assign(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(piece.node_count()));
  layout.arcs.resize(piece.dart_count());
  for (Dart d = 0; d < piece.dart_count(); ++d)
    for (const Vertex v : disc.of_dart(d)) layout.arcs[d].push_back(all[v]);
  return layout;
}

/// Left and right end of a layout.
std::pair<double, double> extent(const CircleLayout& layout) {
  double low = 1e300, high = -1e300;
  const auto meet = [&](const Disc& disc) {
    low = std::min(low, disc.centre.real() - disc.radius);
    high = std::max(high, disc.centre.real() + disc.radius);
  };
  for (const Disc& disc : layout.nodes) meet(disc);
  for (const auto& arc : layout.arcs)
    for (const Disc& disc : arc) meet(disc);
  return {low, high};
}

}  // namespace

CircleLayout circle_layout(const Diagram& diagram) {
  if (diagram.arc_count() > kMostArcsDrawn)
    throw InvalidInput("the diagram has " + std::to_string(diagram.arc_count()) + " arcs; up to " +
                       std::to_string(kMostArcsDrawn) + " are drawn");
  const topology::DiagramPieces parts = topology::pieces(diagram);
  CircleLayout layout;
  layout.nodes.resize(diagram.node_count());
  layout.arcs.resize(diagram.dart_count());
  double right = 0;
  for (std::size_t part = 0; part < parts.count; ++part) {
    std::vector<topology::DiagramNode> nodes;
    std::vector<std::size_t> numbers;
    for (std::size_t n = 0; n < diagram.node_count(); ++n) {
      if (parts.of_node[n] != part) continue;
      numbers.push_back(n);
      topology::DiagramNode node{diagram.kind(n)};
      for (std::uint32_t k = 0; k < diagram.degree(n); ++k) {
        const Dart d = diagram.first_dart(n) + k;
        node.arcs.push_back(std::min(d, diagram.mate(d)));
      }
      nodes.push_back(std::move(node));
    }
    const Diagram piece(nodes);
    CircleLayout drawn = layout_of_piece(piece);
    const auto [low, high] = extent(drawn);
    const double shift = part == 0 ? 0 : right - low + 1;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      layout.nodes[numbers[i]] = drawn.nodes[i];
      layout.nodes[numbers[i]].centre += shift;
      for (std::uint32_t k = 0; k < piece.degree(i); ++k) {
        auto& arc = layout.arcs[diagram.first_dart(numbers[i]) + k];
        arc = drawn.arcs[piece.first_dart(i) + k];
        for (Disc& disc : arc) disc.centre += shift;
      }
    }
    right = high + shift;
  }
  return layout;
}

}  // namespace tripus::drawing
