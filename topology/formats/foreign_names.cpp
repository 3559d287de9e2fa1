#include <array>

#include "base/error.hpp"
#include "topology/detail/text.hpp"
#include "topology/formats/formats.hpp"

namespace tripus::topology {
namespace {

/// A pattern of names: # stands for one or more digits, @ for "a" or "n", all else for itself.
bool fits(std::string_view pattern, std::string_view text) {
  for (const char p : pattern) {
    if (p == '#') {
      if (text.empty() || !detail::is_digit(text.front())) return false;
      while (!text.empty() && detail::is_digit(text.front())) text.remove_prefix(1);
      continue;
    }
    const bool good = !text.empty() &&
                      (p == '@' ? text.front() == 'a' || text.front() == 'n' : text.front() == p);
    if (!good) return false;
    text.remove_prefix(1);
  }
  return text.empty();
}

/// The tables of SnapPy that have names of this form, by its documentation.
constexpr std::array<std::string_view, 24> kPatterns{
    "m#",       "s#",       "v#",      "t#",      "x#",       "y#",       "o#_#",     "L#@#",
    "K#@#",     "#@#",      "K#_#",    "#_#",     "#^#_#",    "k#_#",     "otet#_#",  "ntet#_#",
    "ocube#_#", "ncube#_#", "ooct#_#", "noct#_#", "odode#_#", "ndode#_#", "oicos#_#", "nicos#_#"};

/// "m003(-3,1)" without what is filled.
std::string_view without_fillings(std::string_view text) {
  const std::size_t open = text.find('(');
  return open == std::string_view::npos || !text.ends_with(')') ? text : text.substr(0, open);
}

bool starts_with_any(std::string_view text, std::initializer_list<std::string_view> beginnings) {
  for (const std::string_view beginning : beginnings)
    if (text.starts_with(beginning)) return true;
  return false;
}

}  // namespace

std::optional<std::string> foreign_name(std::string_view text) {
  text = detail::trimmed(text);
  const std::string_view name = without_fillings(text);
  bool found = starts_with_any(
      text, {"DT:", "DT[", "Braid:", "Braid[", "braid[", "b++", "b+-", "b-+", "b--", "b+o", "b-o"});
  for (const std::string_view pattern : kPatterns) found = found || fits(pattern, name);
  if (!found) return std::nullopt;
  const std::string shown(text);
  return quoted(shown) +
         " is a SnapPy name, not a signature: give its signature, which SnapPy tells by "
         "Manifold('" +
         std::string(quoted(shown).substr(1, quoted(shown).size() - 2)) + "')" +
         (name.size() != text.size() ? ".filled_triangulation()" : "") +
         ".triangulation_isosig(decorated=False)";
}

}  // namespace tripus::topology
