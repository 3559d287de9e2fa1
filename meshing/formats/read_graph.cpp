#include "meshing/formats/read_graph.hpp"

#include <array>
#include <map>
#include <string>

#include "base/error.hpp"
#include "meshing/detail/polylines.hpp"
#include "meshing/detail/scanner.hpp"
#include "meshing/formats/formats.hpp"

namespace tripus::meshing {
namespace {

struct GraphFormat {
  std::string_view name;
  bool (*matches)(std::string_view content);
  SpatialGraph (*read)(std::string_view content);
};

std::string_view without_mark(std::string_view content) {
  content.remove_prefix(content.starts_with("\xef\xbb\xbf") ? 3 : 0);
  return content;
}

std::string_view first_word(std::string_view content) {
  return detail::Scanner("", content.substr(0, 4096), '#').word();
}

bool starts_vect(std::string_view content) {
  detail::Scanner in("", content.substr(0, 4096), '#');
  detail::skip_oogl_wrapping(in);
  const std::string_view word = in.word();
  return word == "VECT" || word == "4VECT";
}
bool starts_json_graph(std::string_view content) {
  const std::string_view word = first_word(content);
  return word.starts_with('[') || word.starts_with('{');
}
bool starts_points(std::string_view content) {
  const std::string_view word = first_word(content);
  return !word.empty() &&
         std::string_view("+-.0123456789").find(word.front()) != std::string_view::npos;
}

/// The first that matches is taken. A new format is one file and one line here.
constexpr std::array kGraphFormats{
    GraphFormat{"VECT", starts_vect, read_vect},
    GraphFormat{"JSON", starts_json_graph, read_spatial_graph},
    GraphFormat{"Wavefront OBJ with lines", starts_obj, read_obj_lines},
    GraphFormat{"list of points", starts_points, read_point_lists},
};

}  // namespace

std::string graph_format_names() {
  std::string names;
  for (const GraphFormat& format : kGraphFormats)
    names += (names.empty() ? "" : ", ") + std::string(format.name);
  return names;
}

bool is_drawn_graph(std::string_view content) {
  content = without_mark(content);
  if (starts_vect(content)) return true;
  if (starts_obj(content)) return has_only_lines(content);
  if (!starts_points(content)) return false;
  try {
    return !read_point_lists(content).edges.empty();
  } catch (const InvalidInput&) {
    return false;
  }
}

SpatialGraph read_graph(std::string_view content) {
  content = without_mark(content);
  for (const GraphFormat& format : kGraphFormats)
    if (format.matches(content)) return format.read(content);
  throw InvalidInput("its content has no format of graphs that is known; looked for: " +
                     graph_format_names());
}

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

SpatialGraph read_vect(std::string_view text) {
  detail::Scanner in("VECT", text, '#');
  detail::skip_oogl_wrapping(in);
  const std::string_view head = in.word();
  if (head != "VECT" && head != "4VECT") in.fail("the file does not begin with VECT");
  const bool homogeneous = head == "4VECT";
  const std::uint32_t count = in.count("the number of polylines", 2);
  const std::uint32_t points = in.count("the number of points", 6);
  in.natural("the number of colours");
  std::vector<detail::Polyline> lines(count);
  std::vector<std::uint32_t> sizes;
  std::uint64_t sum = 0;
  for (detail::Polyline& line : lines) {
    std::string_view word = in.word();
    line.is_closed = word.starts_with('-');
    word.remove_prefix(line.is_closed ? 1 : 0);
    sizes.push_back(in.natural(word, "the number of points of a polyline"));
    sum += sizes.back();
  }
  if (sum != points)
    in.fail("the polylines have " + std::to_string(sum) + " points in all; " +
            std::to_string(points) + " were announced");
  for (std::uint32_t i = 0; i < count; ++i) in.number("a number of colours");
  for (std::uint32_t i = 0; i < count; ++i)
    for (std::uint32_t k = 0; k < sizes[i]; ++k) {
      Point point = in.point();
      if (homogeneous) {
        const double w = in.number("a coordinate");
        for (double& x : point) x /= w;
      }
      lines[i].points.push_back(point);
    }
  return detail::graph_of(lines);
}

}  // namespace tripus::meshing
