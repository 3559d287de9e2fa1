#include "meshing/formats/graph_points.hpp"

#include <map>
#include <string>

#include "meshing/detail/polylines.hpp"
#include "meshing/detail/scanner.hpp"

namespace tripus::meshing {
namespace {

/// How many polylines have each point.
std::map<Point, std::size_t> sharers(const std::vector<detail::Polyline>& lines) {
  std::map<Point, std::size_t> count;
  for (const detail::Polyline& line : lines) {
    std::map<Point, bool> own;
    for (const Point& point : line.points) own[point] = true;
    for (const auto& each : own) ++count[each.first];
  }
  return count;
}

}  // namespace

SpatialGraph read_point_lists(std::string_view text) {
  std::string plain(text);
  for (char& c : plain)
    if (c == ',' || c == ';') c = ' ';
  detail::Scanner in("list of points", plain, '#');
  std::vector<detail::Polyline> lines(1);
  do {
    // A line with nothing but a comment separates nothing.
    const bool is_comment = in.rest_of_line().find('#') != std::string_view::npos;
    const std::string_view word = in.word_of_line();
    if (word.empty()) {
      if (!is_comment && !lines.back().points.empty()) lines.emplace_back();
      continue;
    }
    Point point;
    point[0] = in.number(word, "a coordinate");
    for (std::size_t k = 1; k < 3; ++k) point[k] = in.number(in.word_of_line(), "a coordinate");
    if (const std::string_view extra = in.word_of_line(); !extra.empty())
      in.fail(quoted(std::string(extra.substr(0, 32))) + " after the three coordinates of a point");
    lines.back().points.push_back(point);
  } while (in.next_line());
  if (lines.back().points.empty()) lines.pop_back();
  const auto count = sharers(lines);
  for (detail::Polyline& line : lines)
    line.is_closed = line.points.size() > 2 && line.points.front() != line.points.back() &&
                     count.at(line.points.front()) == 1 && count.at(line.points.back()) == 1;
  return detail::graph_of(lines);
}

}  // namespace tripus::meshing
