#include "meshing/detail/polylines.hpp"

#include <array>
#include <unordered_map>

#include "meshing/detail/point_hash.hpp"

namespace tripus::meshing::detail {
namespace {

/// The pieces between neighbouring points.
class Pieces {
 public:
  void add(const Polyline& line) {
    std::uint32_t before = number_of(line.points.front());
    const std::uint32_t first = before;
    for (std::size_t i = 1; i < line.points.size(); ++i) before = add(before, line.points[i]);
    if (line.is_closed && before != first) add(before, line.points.front());
  }

  SpatialGraph graph() {
    SpatialGraph result;
    used_.assign(ends_.size(), false);
    for (std::uint32_t p = 0; p < points_.size(); ++p)
      if (at_[p].size() > 2) result.vertices.push_back(points_[p]);
    // From vertices and loose ends first; what is left then closes up.
    for (const bool closed : {false, true})
      for (std::uint32_t p = 0; p < points_.size(); ++p)
        for (const std::uint32_t piece : at_[p])
          if (!used_[piece] && (closed || at_[p].size() != 2))
            result.edges.push_back(walk(p, piece));
    return result;
  }

 private:
  std::uint32_t number_of(Point point) {
    for (double& x : point)
      if (x == 0) x = 0;  // -0 and 0 are equal, and hash alike
    const auto next = static_cast<std::uint32_t>(points_.size());
    const auto [place, is_new] = numbers_.try_emplace(point, next);
    if (is_new) {
      points_.push_back(point);
      at_.emplace_back();
    }
    return place->second;
  }
  std::uint32_t add(std::uint32_t from, const Point& point) {
    const std::uint32_t to = number_of(point);
    if (to == from) return to;  // a point given twice
    const auto piece = static_cast<std::uint32_t>(ends_.size());
    ends_.push_back({from, to});
    at_[from].push_back(piece);
    at_[to].push_back(piece);
    return to;
  }
  std::vector<Point> walk(std::uint32_t from, std::uint32_t piece) {
    std::vector<Point> edge{points_[from]};
    while (true) {
      used_[piece] = true;
      from = ends_[piece][0] == from ? ends_[piece][1] : ends_[piece][0];
      edge.push_back(points_[from]);
      if (at_[from].size() != 2) return edge;
      const std::uint32_t next = at_[from][0] == piece ? at_[from][1] : at_[from][0];
      if (used_[next]) return edge;
      piece = next;
    }
  }

  std::vector<Point> points_;
  std::unordered_map<Point, std::uint32_t, PointHash> numbers_;
  std::vector<std::array<std::uint32_t, 2>> ends_;
  std::vector<std::vector<std::uint32_t>> at_;
  std::vector<bool> used_;
};

}  // namespace

SpatialGraph graph_of(const std::vector<Polyline>& polylines) {
  Pieces pieces;
  for (const Polyline& line : polylines)
    if (!line.points.empty()) pieces.add(line);
  return pieces.graph();
}

}  // namespace tripus::meshing::detail
