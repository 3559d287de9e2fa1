#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/detail/guarded_json.hpp"
#include "base/error.hpp"
#include "structure/certificate.hpp"

// nlohmann's own tree would turn integers beyond 64 bits into doubles. The tree here keeps their
// text.

namespace tripus::structure {
namespace {

/// Numbers are read as long double on their way, so that the parser lets integers of up to 4,932
/// digits through; with double it stops at 308.
using json = nlohmann::basic_json<std::map, std::vector, std::string, bool, std::int64_t,
                                  std::uint64_t, long double>;

/// Keeps the text of every number, as a "binary" value: no JSON text makes one.
struct NumbersAsText {
  template <class Tree, class Number>
  static Tree keep(Number value) {
    return keep_text<Tree>(std::to_string(value));
  }
  template <class Tree>
  static Tree keep(typename Tree::number_float_t /*value*/, const std::string& text) {
    return keep_text<Tree>(text);
  }

 private:
  template <class Tree>
  static Tree keep_text(const std::string& text) {
    return Tree::binary(std::vector<std::uint8_t>(text.begin(), text.end()));
  }
};

std::string shown(const json& value) {
  if (value.is_binary())
    return tripus::quoted(std::string(value.get_binary().begin(), value.get_binary().end()));
  if (value.is_string()) return "the string " + tripus::quoted(value.get_ref<const std::string&>());
  if (value.is_object() || value.is_array())
    return fmt::format("an {} of {}", value.type_name(), value.size());
  return value.dump();
}

[[noreturn]] void refuse(const std::string& place, std::string_view expected, const json& found) {
  throw InvalidInput(
      fmt::format("certificate: {}: expected {}, found {}", place, expected, shown(found)));
}

/// Digits, with a minus sign or without: no fraction, no exponent.
Integer read_integer(const json& value, const std::string& place) {
  if (!value.is_binary()) refuse(place, "an integer", value);
  const std::string text(value.get_binary().begin(), value.get_binary().end());
  if (text.find_first_not_of("-0123456789") != std::string::npos)
    refuse(place, "an integer, written without fraction and exponent", value);
  return big_integer(text);
}

const json& member(const json& object, const char* name, std::string_view expected) {
  const auto found = object.find(name);
  if (found == object.end())
    throw InvalidInput(fmt::format("certificate: \"{}\" is missing; expected {}", name, expected));
  return *found;
}

const json& read_array(const json& value, const std::string& place, std::string_view expected) {
  if (!value.is_array()) refuse(place, expected, value);
  return value;
}

/// The certificate object in a document: itself, or the member of an answer.
const json& find_certificate(const json& document) {
  if (!document.is_object()) refuse("the document", "an object", document);
  if (!document.contains("certificate")) return document;
  const json& certificate = document["certificate"];
  if (certificate.is_null()) {
    const auto outcome = document.find("outcome");
    throw InvalidInput(fmt::format(
        "certificate: the answer carries none{}",
        outcome != document.end() && outcome->is_string()
            ? "; its outcome is " + tripus::quoted(outcome->get_ref<const std::string&>())
            : std::string()));
  }
  if (!certificate.is_object()) refuse("\"certificate\"", "an object", certificate);
  return certificate;
}

Certificate::Kind read_kind(const json& value) {
  if (value == "none") return Certificate::Kind::kNone;
  if (value == "semi") return Certificate::Kind::kSemi;
  refuse("\"kind\"", R"("none" or "semi")", value);
}

/// "2/3", in units of pi.
topology::ConeAngle read_cone_angle(const json& value, const std::string& place) {
  constexpr std::string_view kShape = "a fraction of pi such as \"2/3\", as a string";
  if (!value.is_string()) refuse(place, kShape, value);
  const auto& text = value.get_ref<const std::string&>();
  std::int64_t terms[2] = {0, 1};
  std::size_t term = 0, digits = 0;
  for (const char c : text) {
    if (c == '/' && term == 0 && digits > 0) {
      term = 1;
      terms[1] = 0;
      digits = 0;
    } else if (c >= '0' && c <= '9' && digits < 10) {
      terms[term] = 10 * terms[term] + (c - '0');
      ++digits;
    } else {
      refuse(place, kShape, value);
    }
  }
  if (digits == 0 || terms[1] == 0 ||
      std::max(terms[0], terms[1]) > topology::ConeAngle::kLargestTerm)
    refuse(place, kShape, value);
  return topology::ConeAngle::rational(terms[0], terms[1]);
}

}  // namespace

Certificate parse_certificate(std::string_view text) {
  const auto document = tripus::detail::parse_guarded_json<json, NumbersAsText>(
      text,
      "a certificate {\"kind\": ..., \"edge\": [...], \"vertex\": [...]} or an answer of `tripus "
      "solve "
      "--json`");
  const json& object = find_certificate(document);

  Certificate certificate;
  certificate.kind = read_kind(member(object, "kind", R"("none" or "semi")"));
  constexpr std::string_view kEdgeShape = "an array of integers, one an edge class";
  for (const json& u : read_array(member(object, "edge", kEdgeShape), "\"edge\"", kEdgeShape)) {
    certificate.edge.push_back(
        read_integer(u, fmt::format("multiplier of edge class {}", certificate.edge.size())));
  }
  constexpr std::string_view kVertexShape = "an array of four integers a tetrahedron";
  const json& vertex =
      read_array(member(object, "vertex", kVertexShape), "\"vertex\"", kVertexShape);
  for (std::size_t t = 0; t < vertex.size(); ++t) {
    const json& four = vertex[t];
    if (!four.is_array() || four.size() != 4)
      refuse(fmt::format("multipliers of tetrahedron {}", t), "an array of 4 integers", four);
    auto& w = certificate.vertex.emplace_back();
    for (std::size_t v = 0; v < 4; ++v)
      w[v] = read_integer(four[v], fmt::format("multiplier of vertex {} of tetrahedron {}", v, t));
  }
  if (const auto angles = object.find("cone_angles"); angles != object.end()) {
    for (const json& k :
         read_array(*angles, "\"cone_angles\"", "an array of strings, one an edge class"))
      certificate.cone_angles.push_back(read_cone_angle(
          k, fmt::format("cone angle of edge class {}", certificate.cone_angles.size())));
  }
  return certificate;
}

}  // namespace tripus::structure
