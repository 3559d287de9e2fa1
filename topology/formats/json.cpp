#include "topology/formats/json.hpp"

#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "topology/detail/text.hpp"
#include "topology/triangulation.hpp"

namespace tripus::topology {
namespace {

using nlohmann::json;

/// Deeper nesting than any document of ours has; the parser stops there.
constexpr int kDeepest = 32;

std::string place(std::size_t t, std::size_t f) {
  return "JSON: face " + std::to_string(f) + " of tetrahedron " + std::to_string(t) + ": ";
}

/// What a wrong value looks like, short enough for a message.
std::string shown(const json& value) {
  if (value.is_object() || value.is_array())
    return std::string("an ") + value.type_name() + " of " + std::to_string(value.size());
  return quoted(value.dump(-1, ' ', true, json::error_handler_t::replace));
}

json parse(std::string_view text) {
  const auto stop_deep = [](int depth, json::parse_event_t, json&) {
    if (depth > kDeepest)
      throw InvalidInput("JSON: nested more than " + std::to_string(kDeepest) + " levels deep");
    return true;
  };
  try {
    return json::parse(text.begin(), text.end(), stop_deep);
  } catch (const json::parse_error& error) {
    throw InvalidInput("JSON: syntax error at byte " + std::to_string(error.byte) +
                       "; expected an object {\"gluings\": [...]}");
  } catch (const json::exception& error) {
    throw InvalidInput("JSON: " + quoted(error.what(), 120));
  }
}

void read_face(const json& entry, std::size_t t, std::size_t f, Gluings& gluings) {
  if (entry.is_null()) return;
  if (!entry.is_array() || entry.size() != 2)
    throw InvalidInput(place(t, f) + "expected [tetrahedron, \"permutation\"] or null, found " +
                       shown(entry));
  const std::size_t count = gluings.tetrahedron_count();
  if (!entry[0].is_number_unsigned() || entry[0].get<std::uint64_t>() >= count)
    throw InvalidInput(place(t, f) + "tetrahedron " + shown(entry[0]) + "; expected 0 to " +
                       std::to_string(count - 1));
  const auto perm = entry[1].is_string()
                        ? detail::parse_perm(entry[1].get_ref<const std::string&>())
                        : std::nullopt;
  if (!perm)
    throw InvalidInput(place(t, f) + "permutation " + shown(entry[1]) +
                       "; expected a word such as \"1230\", the images of 0, 1, 2, 3");
  gluings.set_one_side(t, static_cast<int>(f), entry[0].get<TetrahedronIndex>(), *perm);
}

/// One label an edge class: 3, 2.5, "5/2", 0 for a parabolic edge.
std::vector<ConeAngle> read_cone_orders(const json& list, const Gluings& gluings) {
  const std::size_t edges = Triangulation(gluings).edge_count();
  if (!list.is_array() || list.size() != edges)
    throw InvalidInput("JSON: \"cone_orders\" is " + shown(list) + "; expected " +
                       std::to_string(edges) + " cone orders, one an edge class");
  std::vector<ConeAngle> angles;
  for (const json& entry : list) {
    try {
      angles.push_back(
          parse_cone_order(entry.is_string() ? entry.get_ref<const std::string&>() : entry.dump()));
    } catch (const InvalidInput& error) {
      throw InvalidInput("JSON: cone order of edge class " + std::to_string(angles.size()) + ": " +
                         error.what());
    }
  }
  return angles;
}

}  // namespace

NamedGluings read_json(std::string_view text) {
  const json document = parse(text);
  const auto table = document.is_object() ? document.find("gluings") : document.end();
  if (!document.is_object() || table == document.end() || !table->is_array())
    throw InvalidInput("JSON: expected an object with an array \"gluings\", found " +
                       shown(document));
  NamedGluings result;
  if (const auto name = document.find("name"); name != document.end()) {
    if (!name->is_string())
      throw InvalidInput("JSON: \"name\" is " + shown(*name) + "; expected a string");
    result.name = name->get<std::string>();
  }
  result.gluings = Gluings(table->size());
  for (std::size_t t = 0; t < table->size(); ++t) {
    const json& row = (*table)[t];
    if (!row.is_array() || row.size() != 4)
      throw InvalidInput("JSON: tetrahedron " + std::to_string(t) + ": " + shown(row) +
                         "; expected an array of its four faces");
    for (std::size_t f = 0; f < 4; ++f) read_face(row[f], t, f, result.gluings);
  }
  require_consistent(result.gluings, OpenFaces::kAllowed);
  if (const auto orders = document.find("cone_orders"); orders != document.end())
    result.cone_angles = read_cone_orders(*orders, result.gluings);
  return result;
}

std::string write_json(const NamedGluings& triangulation) {
  const Gluings& gluings = triangulation.gluings;
  std::string out = "{";
  if (!triangulation.name.empty())
    out += "\"name\": " +
           json(triangulation.name).dump(-1, ' ', false, json::error_handler_t::replace) + ", ";
  out += "\"gluings\": [";
  for (std::size_t t = 0; t < gluings.tetrahedron_count(); ++t) {
    out += t == 0 ? "[" : ", [";
    for (int f = 0; f < 4; ++f) {
      if (f > 0) out += ", ";
      if (gluings.is_open(t, f)) {
        out += "null";
        continue;
      }
      const auto letters = word(gluings.gluing(t, f));
      out += "[" + std::to_string(gluings.neighbour(t, f)) + ", \"";
      out.append(letters.begin(), letters.end());
      out += "\"]";
    }
    out += "]";
  }
  out += "]";
  if (!all_full(triangulation.cone_angles)) {
    out += ", \"cone_orders\": [";
    for (std::size_t e = 0; e < triangulation.cone_angles.size(); ++e)
      out += (e > 0 ? ", \"" : "\"") + triangulation.cone_angles[e].order_text() + "\"";
    out += "]";
  }
  return out + "}\n";
}

}  // namespace tripus::topology
