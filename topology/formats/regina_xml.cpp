#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <string>

#include <pugixml.hpp>

#include "base/error.hpp"
#include "topology/detail/text.hpp"
#include "topology/formats/formats.hpp"

// The generations differ in their elements and in how permutations are numbered. The tree is walked
// without recursion, so that deep nesting costs nothing.

namespace tripus::topology {
namespace {

[[noreturn]] void fail(const std::string& what) { throw InvalidInput("Regina data file: " + what); }

/// Bits 2i, 2i+1 hold the image of i.
std::optional<Perm4> from_image_pack(std::int64_t code) {
  if (code < 0 || code > 255) return std::nullopt;
  std::string images;
  for (int i = 0; i < 4; ++i) images += static_cast<char>('0' + (code >> (2 * i) & 3));
  return detail::parse_perm(images);
}

/// Regina's S4 lists the permutations lexicographically but for swaps within the pairs 2k, 2k+1
/// that make the even ones stand at even places.
std::optional<Perm4> from_s4_index(std::int64_t code) {
  if (code < 0 || code >= 24) return std::nullopt;
  const Perm4 p = Perm4::from_rank(static_cast<int>(code));
  return p.is_odd() == (code % 2 == 1) ? p : Perm4::from_rank(static_cast<int>(code ^ 1));
}

int s4_index(Perm4 p) {
  for (int code = 0; code < 24; ++code)
    if (from_s4_index(code) == p) return code;
  throw InternalError("a permutation without a number");
}

using PermOf = std::optional<Perm4> (*)(std::int64_t);

void read_row(std::string_view numbers, PermOf perm_of, std::size_t t, Gluings& gluings) {
  for (int f = 0; f < 4; ++f) {
    const auto other_token = detail::take_token(numbers);
    const auto perm_token = detail::take_token(numbers);
    const std::string face =
        "face " + std::to_string(f) + " of tetrahedron " + std::to_string(t) + ": ";
    const auto other = detail::parse_integer(other_token);
    if (!other || *other >= static_cast<std::int64_t>(kMaxTetrahedra))
      fail(face + quoted(std::string(other_token)) + "; expected a tetrahedron, or -1");
    if (*other < 0) continue;
    const auto code = detail::parse_integer(perm_token);
    const auto perm = code ? perm_of(*code) : std::nullopt;
    if (!perm)
      fail(face + quoted(std::string(perm_token)) + "; expected the number of a permutation");
    gluings.set_one_side(t, f, static_cast<TetrahedronIndex>(*other), *perm);
  }
  if (!detail::trimmed(numbers).empty())
    fail("tetrahedron " + std::to_string(t) + " has more than eight numbers");
}

/// The rows directly inside an element; packets may be nested deeper.
NamedGluings read_rows(const pugi::xml_node& element, const char* row, PermOf perm_of) {
  NamedGluings result;
  bool locked = false, described = false;
  for (const pugi::xml_node& each : element.children(row)) {
    const std::size_t t = result.gluings.tetrahedron_count();
    result.gluings.resize(t + 1);
    read_row(each.child_value(), perm_of, t, result.gluings);
    locked |= std::strspn(each.attribute("lock").value(), "0") !=
              std::strlen(each.attribute("lock").value());
    described |= *each.attribute("desc").value() != 0;
  }
  require_consistent(result.gluings, OpenFaces::kAllowed);
  if (locked) result.notes.push_back("locks of tetrahedra and faces not read");
  if (described) result.notes.push_back("descriptions of tetrahedra not read");
  return result;
}

/// The triangulation that an element is, if it is one.
std::optional<NamedGluings> triangulation_of(const pugi::xml_node& element) {
  const std::string_view name = element.name();
  if (name == "tri") {
    if (std::string_view(element.attribute("dim").value()) != "3") return std::nullopt;
    const bool by_index = std::string_view(element.attribute("perm").value()) == "index";
    return read_rows(element, "simplex", by_index ? from_s4_index : from_image_pack);
  }
  if (name == "snappeadata" || name == "snappea") {
    const std::string_view text = detail::trimmed(element.child_value());
    if (text.empty()) return std::nullopt;
    return read_snappea(text);
  }
  if (name != "packet") return std::nullopt;
  const std::string_view type = element.attribute("type").value();
  if (type != "3-Manifold Triangulation" && type != "Triangulation") return std::nullopt;
  return read_rows(element.child("tetrahedra"), "tet", from_image_pack);
}

/// Of an element itself, or of the packet of the second generation that holds it.
std::string label_of(const pugi::xml_node& element) {
  if (const auto label = element.attribute("label")) return label.value();
  return element.parent().attribute("label").value();
}

/// The next element in the order of the file, or nothing.
pugi::xml_node next_in_order(pugi::xml_node node) {
  if (node.first_child()) return node.first_child();
  while (node && !node.next_sibling()) node = node.parent();
  return node ? node.next_sibling() : node;
}

}  // namespace

bool starts_regina_xml(std::string_view text) {
  constexpr std::array<std::string_view, 5> kNames{"regina", "reginadata", "tri", "packet",
                                                   "container"};
  while (text.starts_with("<?") || text.starts_with("<!")) {
    const std::string_view end = text.starts_with("<!--") ? "-->" : ">";
    const std::size_t place = text.find(end);
    if (place == std::string_view::npos) return false;
    text = detail::trimmed(text.substr(place + end.size()));
  }
  if (!text.starts_with('<')) return false;
  text = text.substr(1, text.find_first_of(" \t\r\n/>") - 1);
  return std::find(kNames.begin(), kNames.end(), text) != kNames.end();
}

std::vector<NamedGluings> read_regina_xml(std::string_view text) {
  pugi::xml_document document;
  const auto parsed = document.load_buffer(text.data(), text.size());
  if (!parsed)
    fail("the XML is broken at byte " + std::to_string(parsed.offset) + " (" +
         parsed.description() + "): an element is not closed, or the file is cut off");
  std::vector<NamedGluings> all;
  for (pugi::xml_node node = document.first_child(); node; node = next_in_order(node)) {
    auto found = triangulation_of(node);
    if (!found) continue;
    if (const std::string label = label_of(node); !label.empty()) found->name = label;
    all.push_back(*std::move(found));
  }
  if (all.empty())
    fail(
        "no 3-manifold triangulation in it; expected <tri dim=\"3\"> or <packet "
        "type=\"3-Manifold Triangulation\">");
  return all;
}

std::string write_regina_xml(const NamedGluings& triangulation) {
  const Gluings& gluings = triangulation.gluings;
  pugi::xml_document document;
  pugi::xml_node regina = document.append_child("regina");
  regina.append_attribute("engine") = "7.3";
  pugi::xml_node tri = regina.append_child("tri");
  tri.append_attribute("dim") = 3;
  tri.append_attribute("size") = static_cast<unsigned long long>(gluings.tetrahedron_count());
  tri.append_attribute("perm") = "index";
  tri.append_attribute("label") = triangulation.name.c_str();
  for (std::size_t t = 0; t < gluings.tetrahedron_count(); ++t) {
    std::string row = " ";
    for (int f = 0; f < 4; ++f)
      row += gluings.is_open(t, f) ? std::string("-1 -1 ")
                                   : std::to_string(gluings.neighbour(t, f)) + " " +
                                         std::to_string(s4_index(gluings.gluing(t, f))) + " ";
    tri.append_child("simplex").text() = row.c_str();
  }
  struct Text : pugi::xml_writer {
    std::string text;
    void write(const void* data, std::size_t size) override {
      text.append(static_cast<const char*>(data), size);
    }
  } out;
  document.save(out, "  ");
  return out.text;
}

}  // namespace tripus::topology

namespace tripus::topology::registered_formats {

std::span<const Format> regina_xml() {
  static constexpr Format kRows[] = {{kReginaDataFile, starts_regina_xml, read_regina_xml, 3}};
  return kRows;
}

}  // namespace tripus::topology::registered_formats
