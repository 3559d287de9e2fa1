#include <cmath>

#include <nlohmann/json.hpp>

#include "base/detail/guarded_json.hpp"
#include "base/error.hpp"
#include "meshing/tube/spatial_graph.hpp"

namespace tripus::meshing {
namespace {

using nlohmann::json;

constexpr const char* kForm = "{\"vertices\": [[x,y,z], ...], \"edges\": [[[x,y,z], ...], ...]}";

std::string shown(const json& value) {
  if (value.is_object() || value.is_array())
    return std::string("an ") + value.type_name() + " of " + std::to_string(value.size());
  return quoted(value.dump(-1, ' ', true, json::error_handler_t::replace));
}

json parse(std::string_view text) {
  try {
    return tripus::detail::parse_guarded_json(text, std::string("an object ") + kForm);
  } catch (const InvalidInput& error) {
    throw InvalidInput(std::string("spatial graph: ") + error.what());
  }
}

double read_number(const json& value, const std::string& place) {
  if (!value.is_number() || !std::isfinite(value.get<double>()))
    throw InvalidInput(place + " is " + shown(value) + "; expected a finite number");
  return value.get<double>();
}

Point read_point(const json& value, const std::string& place) {
  if (!value.is_array() || value.size() != 3)
    throw InvalidInput(place + " is " + shown(value) + "; expected a point [x, y, z]");
  Point point;
  for (std::size_t k = 0; k < 3; ++k)
    point[k] = read_number(value[k], place + ": coordinate " + std::to_string(k));
  return point;
}

std::vector<Point> read_points(const json& value, const std::string& place,
                               const std::string& one_of_them) {
  if (!value.is_array())
    throw InvalidInput(place + " is " + shown(value) + "; expected an array of points [x, y, z]");
  std::vector<Point> points;
  points.reserve(value.size());
  for (const json& entry : value)
    points.push_back(read_point(entry, one_of_them + std::to_string(points.size())));
  return points;
}

/// The member of an object, which must be there and be the only kind of thing in it.
void require_keys(const json& object, const std::string& place,
                  const std::vector<std::string>& known) {
  for (const auto& entry : object.items())
    if (std::find(known.begin(), known.end(), entry.key()) == known.end()) {
      std::string names;
      for (const std::string& key : known) names += (names.empty() ? "\"" : ", \"") + key + "\"";
      throw InvalidInput(place + ": unknown key " + quoted(entry.key()) + "; the keys are " +
                         names);
    }
}

const json& member(const json& object, const std::string& place, const char* key) {
  const auto found = object.find(key);
  if (found == object.end()) throw InvalidInput(place + ": \"" + key + "\" is missing");
  return *found;
}

OuterSphere read_sphere(const json& value) {
  const std::string place = "outer sphere";
  if (!value.is_object())
    throw InvalidInput(place + " is " + shown(value) +
                       "; expected {\"center\": [x,y,z], \"radius\": r}");
  require_keys(value, place, {"center", "radius"});
  const OuterSphere sphere{read_point(member(value, place, "center"), place + ": center"),
                           read_number(member(value, place, "radius"), place + ": radius")};
  if (!(sphere.radius > 0)) throw InvalidInput(place + ": the radius must be greater than 0");
  return sphere;
}

OuterBox read_box(const json& value) {
  const std::string place = "outer box";
  if (!value.is_object())
    throw InvalidInput(place + " is " + shown(value) +
                       "; expected {\"low\": [x,y,z], \"high\": [x,y,z]}");
  require_keys(value, place, {"low", "high"});
  const OuterBox box{read_point(member(value, place, "low"), place + ": low"),
                     read_point(member(value, place, "high"), place + ": high")};
  for (std::size_t k = 0; k < 3; ++k)
    if (!(box.low[k] < box.high[k]))
      throw InvalidInput(place + ": coordinate " + std::to_string(k) +
                         " of \"low\" must be less than that of \"high\"");
  return box;
}

Outer read_outer(const json& value) {
  if (value == "automatic") return AutomaticOuter{};
  if (value == "none") return NoOuter{};
  if (!value.is_object() || value.size() != 1)
    throw InvalidInput("\"outer\" is " + shown(value) +
                       "; expected \"automatic\", \"none\", {\"sphere\": ...} or {\"box\": ...}");
  require_keys(value, "outer", {"sphere", "box"});
  if (value.contains("sphere")) return read_sphere(value["sphere"]);
  return read_box(value["box"]);
}

}  // namespace

SpatialGraph read_spatial_graph(std::string_view text) {
  const json document = parse(text);
  const std::string place = "spatial graph";
  if (!document.is_object())
    throw InvalidInput(place + ": found " + shown(document) + "; expected an object " + kForm);
  require_keys(document, place, {"name", "what", "source", "vertices", "edges", "outer"});
  SpatialGraph graph;
  if (const auto name = document.find("name"); name != document.end()) {
    if (!name->is_string())
      throw InvalidInput("\"name\" is " + shown(*name) + "; expected a string");
    graph.name = name->get<std::string>();
  }
  if (const auto vertices = document.find("vertices"); vertices != document.end())
    graph.vertices = read_points(*vertices, "\"vertices\"", "vertex ");
  const json& edges = member(document, place, "edges");
  if (!edges.is_array())
    throw InvalidInput("\"edges\" is " + shown(edges) + "; expected an array of lists of points");
  for (const json& edge : edges) {
    const std::string name = "edge " + std::to_string(graph.edges.size());
    graph.edges.push_back(read_points(edge, name, name + ": point "));
  }
  if (const auto outer = document.find("outer"); outer != document.end())
    graph.outer = read_outer(*outer);
  return graph;
}

}  // namespace tripus::meshing
