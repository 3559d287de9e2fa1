#include "meshing/formats/graph_obj.hpp"

#include "meshing/detail/polylines.hpp"
#include "meshing/detail/scanner.hpp"

namespace tripus::meshing {
namespace {

std::uint32_t read_end(const detail::Scanner& in, std::string_view word, std::size_t points) {
  word = word.substr(0, word.find('/'));
  if (!word.starts_with('-')) return in.index(word, 1, points);
  const std::uint32_t back = in.natural(word.substr(1), "the number of a point");
  if (back == 0 || back > points)
    in.fail("point -" + std::to_string(back) + " does not exist; so far there are " +
            std::to_string(points) + " points");
  return static_cast<std::uint32_t>(points - back);
}

}  // namespace

SpatialGraph read_obj_lines(std::string_view text) {
  detail::Scanner in("OBJ lines", text, '#');
  std::vector<Point> points;
  std::vector<detail::Polyline> lines;
  do {
    const std::string_view key = in.word_of_line();
    if (key == "v") {
      Point point;
      for (double& x : point) x = in.number(in.word_of_line(), "a coordinate");
      points.push_back(point);
    } else if (key == "l") {
      detail::Polyline line;
      for (auto word = in.word_of_line(); !word.empty(); word = in.word_of_line())
        line.points.push_back(points[read_end(in, word, points.size())]);
      if (line.points.size() < 2) in.fail("a line of fewer than two points");
      lines.push_back(std::move(line));
    } else if (key == "f") {
      in.fail("a face: this is a surface; a graph has lines (l)");
    }
  } while (in.next_line());
  if (lines.empty()) in.fail("there are no lines (l), so there is no graph");
  return detail::graph_of(lines);
}

}  // namespace tripus::meshing
