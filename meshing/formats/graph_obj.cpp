#include "meshing/formats/graph_obj.hpp"

#include "meshing/detail/obj_line.hpp"
#include "meshing/detail/polylines.hpp"
#include "meshing/detail/scanner.hpp"

namespace tripus::meshing {
namespace {

/// Counted from 1; a negative number counts back from the points so far.
std::int64_t read_end(const detail::Scanner& in, std::string_view word, std::size_t points) {
  word = word.substr(0, word.find('/'));
  if (!word.starts_with('-')) return in.natural(word, "the number of a point");
  const std::uint32_t back = in.natural(word.substr(1), "the number of a point");
  if (back == 0 || back > points)
    in.fail("point -" + std::to_string(back) + " does not exist; so far there are " +
            std::to_string(points) + " points");
  return static_cast<std::int64_t>(points - back) + 1;
}

}  // namespace

bool has_only_lines(std::string_view text) {
  detail::Scanner in("", text, '#');
  bool has_lines = false;
  do {
    detail::ObjLine line(in);
    const std::string_view key = line.word();
    if (key == "f" || key == "fo") return false;
    has_lines |= key == "l";
    if (!key.empty()) line.skip();
  } while (in.next_line());
  return has_lines;
}

SpatialGraph read_obj_lines(std::string_view text) {
  detail::Scanner in("OBJ lines", text, '#');
  std::vector<Point> points;
  struct Line {
    std::uint32_t line;                 ///< of the file
    std::vector<std::int64_t> corners;  ///< counted from 1
  };
  std::vector<Line> lines;
  do {
    detail::ObjLine line(in);
    const std::string_view key = line.word();
    if (key == "v") {
      Point point;
      for (double& x : point) x = in.number(line.word(), "a coordinate");
      points.push_back(point);
      line.skip();
    } else if (key == "l") {
      lines.push_back({in.line(), {}});
      for (auto word = line.word(); !word.empty(); word = line.word())
        lines.back().corners.push_back(read_end(in, word, points.size()));
      if (lines.back().corners.size() < 2) in.fail("a line of fewer than two points");
    } else if (key == "f") {
      in.fail("a face: this is a surface; a graph has lines (l)");
    } else if (!key.empty()) {
      line.skip();
    }
  } while (in.next_line());
  if (lines.empty()) in.fail("there are no lines (l), so there is no graph");
  std::vector<detail::Polyline> polylines;
  for (const Line& line : lines) {
    polylines.emplace_back();
    for (const std::int64_t corner : line.corners) {
      // The points may stand behind the lines.
      if (corner < 1 || static_cast<std::size_t>(corner) > points.size())
        in.fail_at(line.line, "point " + std::to_string(corner) + " does not exist; the file has " +
                                  std::to_string(points.size()) + " points, numbered from 1");
      polylines.back().points.push_back(points[static_cast<std::size_t>(corner) - 1]);
    }
  }
  return detail::graph_of(polylines);
}

}  // namespace tripus::meshing
