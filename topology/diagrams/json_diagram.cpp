// Planar diagrams in JSON.
#include <algorithm>
#include <array>
#include <cstdint>
#include <string>

#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "topology/detail/text.hpp"
#include "topology/diagrams/detail/forms.hpp"

namespace tripus::topology::detail {
namespace {

using nlohmann::json;

std::string at_node(std::size_t n) {
  return "JSON: node " + std::to_string(n) + " of \"diagram\": ";
}

DiagramNode json_node(const json& entry, std::size_t n) {
  const bool with_kind = entry.is_array() && entry.size() == 2 && entry[0].is_string();
  const json& arcs = with_kind ? entry[1] : entry;
  const auto is_arc = [](const json& a) {
    return a.is_number_integer() &&
           (!a.is_number_unsigned() || a.get<std::uint64_t>() <= std::uint64_t{INT64_MAX});
  };
  if (!arcs.is_array() || !std::ranges::all_of(arcs, is_arc))
    throw InvalidInput(at_node(n) +
                       "expected [\"X\", [4,2,5,1]], [\"V\", [1,2,3]] or a list of arcs");
  DiagramNode node;
  for (const json& arc : arcs) node.arcs.push_back(arc.get<std::int64_t>());
  node.kind = kind_of(node.arcs.size());
  if (with_kind) {
    const std::string kind = entry[0].get<std::string>();
    const bool is_crossing = kind == "X" || kind == "x";
    const bool is_circle = kind == "Loop" && node.arcs.size() == 1;
    if (is_circle) node.arcs.push_back(node.arcs.front());
    if (!is_crossing && !is_circle && kind != "V" && kind != "v")
      throw InvalidInput(
          at_node(n) + quoted(kind) +
          " is no kind of node; X is a crossing, V a vertex, Loop (with one arc) a circle");
    node.kind = is_crossing ? NodeKind::kCrossing : NodeKind::kVertex;
  }
  node.place = at_node(n) + to_text(node);
  return node;
}

void json_labels(const json& orders, NamedDiagram& result) {
  if (!orders.is_object())
    throw InvalidInput("JSON: \"cone_orders\" of a diagram is an object {\"arc\": order}");
  for (const auto& [arc, order] : orders.items()) {
    const auto name = parse_integer(arc);
    if (!name)
      throw InvalidInput("JSON: \"cone_orders\": " + quoted(arc) + " is not the number of an arc");
    try {
      result.labels.push_back(
          {*name, parse_cone_order(order.is_string() ? order.get<std::string>() : order.dump())});
    } catch (const InvalidInput& error) {
      throw InvalidInput("JSON: cone order of arc " + arc + ": " + error.what());
    }
  }
}

/// What a diagram says, then what `tripus table --json` says beside it.
constexpr std::array<std::string_view, 17> kKeys{
    "diagram",  "name",     "clockwise", "cone_orders",        "crossings",
    "boundary", "homology", "isosig",    "tetrahedron_count",  "hyperbolic",
    "proved",   "volume",   "signature", "oriented_signature", "isometry_group",
    "same_as",  "tripus"};
constexpr std::size_t kRead = 4;

/// A key with a slip in it would be passed over, and the answer wrong.
void require_known_keys(const json& document) {
  for (const auto& [key, value] : document.items())
    if (std::ranges::find(kKeys, key) == kKeys.end()) {
      std::string known;
      for (std::size_t i = 0; i < kRead; ++i)
        known += (i == 0 ? "" : ", ") + quoted(std::string(kKeys[i]));
      throw InvalidInput("JSON: " + quoted(key) + " is no key of a diagram; there are " + known);
    }
}

}  // namespace

NamedDiagram read_diagram_json(std::string_view text) {
  if (text.find("\"diagram\"") == std::string_view::npos)
    throw InvalidInput(
        "JSON: keys stand in double quotes, as in {\"diagram\": [...]}; Python's json.dumps writes "
        "them");
  json document;
  try {
    const auto stop_deep = [](int depth, json::parse_event_t, json&) {
      if (depth > 8) throw InvalidInput("JSON: a diagram is nested more than 8 levels deep");
      return true;
    };
    document = json::parse(text.begin(), text.end(), stop_deep);
  } catch (const json::exception& error) {
    throw InvalidInput("JSON: " + quoted(error.what(), 120));
  }
  const auto list = document.find("diagram");
  if (list == document.end() || !list->is_array())
    throw InvalidInput("JSON: \"diagram\" is no list of nodes [[\"X\", [4,2,5,1]], ...]");
  require_known_keys(document);
  std::vector<DiagramNode> nodes;
  for (const json& entry : *list) nodes.push_back(json_node(entry, nodes.size()));
  const json clockwise = document.value("clockwise", json(false));
  if (!clockwise.is_boolean())
    throw InvalidInput("JSON: \"clockwise\" is " + clockwise.dump().substr(0, 40) +
                       "; write true or false");
  if (clockwise.get<bool>()) turn_round(nodes);
  NamedDiagram result;
  if (const auto name = document.find("name"); name != document.end() && !name->is_null()) {
    if (!name->is_string()) throw InvalidInput("JSON: \"name\" is no text in quotes");
    result.name = name->get<std::string>();
  }
  if (const auto orders = document.find("cone_orders"); orders != document.end())
    json_labels(*orders, result);
  result.diagram = Diagram(nodes);
  return result;
}

}  // namespace tripus::topology::detail
