#include <optional>

#include "base/error.hpp"
#include "topology/detail/text.hpp"
#include "topology/formats/regina.hpp"

// A Regina file is XML, but the part of XML that it uses is small: tags with quoted attributes,
// comments, and numbers as text. Tags are scanned in order, without recursion, so nesting costs
// nothing. The two generations differ in their tags and in how permutations are numbered.

namespace tripus::topology {
namespace {

struct Tag {
  std::string_view name;        // with a leading / when closing
  std::string_view attributes;  // raw
  std::size_t end = 0;          // just after its '>'
};

[[noreturn]] void fail(const std::string& what) { throw InvalidInput("Regina data file: " + what); }

/// The next tag from `from` on; comments, declarations and CDATA are skipped.
std::optional<Tag> next_tag(std::string_view text, std::size_t from) {
  while ((from = text.find('<', from)) != std::string_view::npos) {
    const auto rest = text.substr(from);
    const auto skip_to = [&](std::string_view mark) {
      const std::size_t end = text.find(mark, from);
      from = end == std::string_view::npos ? text.size() : end + mark.size();
    };
    if (rest.starts_with("<!--")) {
      skip_to("-->");
    } else if (rest.starts_with("<![CDATA[")) {
      skip_to("]]>");
    } else if (rest.starts_with("<!") || rest.starts_with("<?")) {
      skip_to(">");
    } else {
      char quote = 0;
      std::size_t end = from + 1;
      for (; end < text.size() && (quote != 0 || text[end] != '>'); ++end) {
        if (quote == 0 && (text[end] == '"' || text[end] == '\''))
          quote = text[end];
        else if (text[end] == quote)
          quote = 0;
      }
      if (end == text.size()) return std::nullopt;
      auto body = text.substr(from + 1, end - from - 1);
      const auto name = detail::take_token(body);
      return Tag{name, body, end + 1};
    }
  }
  return std::nullopt;
}

std::string without_entities(std::string_view text) {
  static constexpr std::pair<std::string_view, char> kEntities[] = {
      {"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}};
  std::string out;
  while (!text.empty()) {
    char c = text.front();
    std::size_t length = 1;
    for (const auto& [entity, meaning] : kEntities)
      if (text.starts_with(entity)) {
        c = meaning;
        length = entity.size();
      }
    out += c;
    text.remove_prefix(length);
  }
  return out;
}

bool is_empty_element(const Tag& tag) {
  return tag.name.ends_with('/') || tag.attributes.ends_with('/');
}

/// The value of an attribute, or nothing.
std::optional<std::string> attribute(const Tag& tag, std::string_view wanted) {
  std::string_view rest = tag.attributes;
  while (true) {
    const std::size_t equals = rest.find('=');
    if (equals == std::string_view::npos) return std::nullopt;
    const auto name = detail::trimmed(rest.substr(0, equals));
    const std::size_t open = rest.find_first_of("\"'", equals);
    if (open == std::string_view::npos) return std::nullopt;
    const std::size_t close = rest.find(rest[open], open + 1);
    if (close == std::string_view::npos) return std::nullopt;
    if (name == wanted) return without_entities(rest.substr(open + 1, close - open - 1));
    rest.remove_prefix(close + 1);
  }
}

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

/// How a triangulation is written.
struct Dialect {
  std::string_view row;  // the tag of one tetrahedron
  std::string_view end;  // the tag that closes the triangulation
  std::optional<Perm4> (*perm)(std::int64_t);
};

void read_row(std::string_view numbers, const Dialect& dialect, std::size_t t, Gluings& gluings) {
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
    const auto perm = code ? dialect.perm(*code) : std::nullopt;
    if (!perm)
      fail(face + quoted(std::string(perm_token)) + "; expected the number of a permutation");
    gluings.set_one_side(t, f, static_cast<TetrahedronIndex>(*other), *perm);
  }
  if (!detail::trimmed(numbers).empty())
    fail("tetrahedron " + std::to_string(t) + " has more than eight numbers");
}

/// The rows directly inside the element that `from` is in; packets may be nested deeper.
Gluings read_rows(std::string_view text, std::size_t from, const Dialect& dialect) {
  Gluings gluings;
  std::size_t depth = 0;
  while (const auto tag = next_tag(text, from)) {
    from = tag->end;
    if (tag->name.starts_with('/')) {
      if (depth-- > 0) continue;
      require_consistent(gluings, OpenFaces::kAllowed);
      return gluings;
    }
    if (depth == 0 && tag->name == dialect.row) {
      const std::size_t t = gluings.tetrahedron_count();
      gluings.resize(t + 1);
      const std::size_t close = text.find('<', from);
      read_row(text.substr(from, close == std::string_view::npos ? close : close - from), dialect,
               t, gluings);
    }
    if (!is_empty_element(*tag)) ++depth;
  }
  fail("the triangulation is not closed by <" + std::string(dialect.end) + ">");
}

}  // namespace

NamedGluings read_regina_xml(std::string_view text) {
  std::size_t from = 0;
  std::optional<std::string> packet;  // the label of a second-generation triangulation
  while (const auto tag = next_tag(text, from)) {
    from = tag->end;
    if (is_empty_element(*tag)) continue;
    if (tag->name == "tri" && attribute(*tag, "dim") == "3") {
      const bool by_index = attribute(*tag, "perm") == "index";
      const Dialect dialect{"simplex", "/tri", by_index ? from_s4_index : from_image_pack};
      return {attribute(*tag, "label").value_or(""), read_rows(text, from, dialect)};
    }
    if (tag->name == "packet") {
      packet.reset();
      if (attribute(*tag, "type") == "3-Manifold Triangulation")
        packet = attribute(*tag, "label").value_or("");
    } else if (packet && tag->name == "tetrahedra") {
      return {*packet, read_rows(text, from, {"tet", "/tetrahedra", from_image_pack})};
    }
  }
  fail(
      "no 3-manifold triangulation in it; expected <tri dim=\"3\"> or <packet "
      "type=\"3-Manifold Triangulation\">");
}

}  // namespace tripus::topology
