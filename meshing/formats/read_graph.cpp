#include "meshing/formats/read_graph.hpp"

#include <array>

#include "base/error.hpp"
#include "meshing/detail/oogl.hpp"
#include "meshing/detail/scanner.hpp"
#include "meshing/formats/graph_obj.hpp"
#include "meshing/formats/graph_points.hpp"
#include "meshing/formats/graph_vect.hpp"
#include "meshing/formats/obj.hpp"

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

}  // namespace tripus::meshing
