#include "topology/formats/snappea.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "base/error.hpp"
#include "topology/detail/text.hpp"

// The file is read by lines, not by fields: programs disagree about what stands between the two
// lines that matter (Orb adds edge data, older SnapPea leaves the curves out), but all write
// four neighbours on one line and four permutations on the next.

namespace tripus::topology {
namespace {

using Tokens = std::array<std::string_view, 4>;

struct Line {
  std::size_t number = 0;
  std::string_view text;
};

/// The line's tokens if there are exactly four and all pass.
template <class Test>
std::optional<Tokens> four_tokens(std::string_view line, Test passes) {
  Tokens tokens;
  for (std::string_view& token : tokens) {
    token = detail::take_token(line);
    if (token.empty() || !passes(token)) return std::nullopt;
  }
  if (!detail::trimmed(line).empty()) return std::nullopt;
  return tokens;
}

bool is_index(std::string_view token) {
  return std::ranges::all_of(token, [](char c) { return c >= '0' && c <= '9'; });
}

/// Wrong digits are to be reported, not overlooked.
bool looks_like_perm(std::string_view token) { return token.size() == 4 && is_index(token); }

std::vector<Line> significant_lines(std::string_view text) {
  std::vector<Line> lines;
  for (std::size_t number = 1; !text.empty(); ++number) {
    std::string_view line = detail::take_line(text);
    line = detail::trimmed(line.substr(0, line.find("//")));
    if (!line.empty()) lines.push_back({number, line});
  }
  return lines;
}

[[noreturn]] void fail(const Line& line, const std::string& what) {
  throw InvalidInput("SnapPea file, line " + std::to_string(line.number) + ": " + what);
}

void read_tetrahedron(const Line& first, const Tokens& neighbours, const Line& second,
                      const Tokens& perms, std::size_t t, Gluings& gluings) {
  const std::size_t count = gluings.tetrahedron_count();
  for (std::size_t f = 0; f < 4; ++f) {
    const std::string face =
        "face " + std::to_string(f) + " of tetrahedron " + std::to_string(t) + ": ";
    const auto other = detail::parse_integer(neighbours[f]);
    if (!other || static_cast<std::uint64_t>(*other) >= count)
      fail(first, face + "neighbour " + quoted(std::string(neighbours[f])) + "; expected 0 to " +
                      std::to_string(count - 1));
    const auto perm = detail::parse_perm(perms[f]);
    if (!perm)
      fail(second, face + "permutation " + quoted(std::string(perms[f])) +
                       "; expected the images of 0, 1, 2, 3, such as 1230");
    gluings.set_one_side(t, static_cast<int>(f), static_cast<TetrahedronIndex>(*other), *perm);
  }
}

}  // namespace

NamedGluings read_snappea(std::string_view text) {
  std::vector<Line> lines = significant_lines(text);
  if (lines.empty() || !(lines[0].text.starts_with("% Triangulation") ||
                         lines[0].text.starts_with("% triangulation")))
    throw InvalidInput("SnapPea file: the first line is " +
                       quoted(lines.empty() ? "" : std::string(lines[0].text)) +
                       "; expected \"% Triangulation\"");
  NamedGluings result;
  if (lines.size() > 1) result.name = lines[1].text;

  // The number of tetrahedra is the last number alone on a line before the first pair of lines.
  std::optional<std::size_t> announced;
  std::size_t next = 0;
  for (std::size_t i = 2; i < lines.size(); ++i) {
    const auto neighbours = four_tokens(lines[i].text, is_index);
    const auto perms = neighbours && i + 1 < lines.size()
                           ? four_tokens(lines[i + 1].text, looks_like_perm)
                           : std::nullopt;
    if (!perms) {
      if (next > 0 || !is_index(lines[i].text)) continue;
      const auto count = detail::parse_integer(lines[i].text);
      // Each tetrahedron takes two of the remaining lines, which bounds what we allocate.
      if (!count || static_cast<std::size_t>(*count) > (lines.size() - i) / 2)
        fail(lines[i], quoted(std::string(lines[i].text)) +
                           " tetrahedra are announced, more than the file has lines for");
      announced = static_cast<std::size_t>(*count);
      result.gluings = Gluings(*announced);
      continue;
    }
    if (!announced) fail(lines[i], "a tetrahedron before the number of tetrahedra");
    if (next == *announced)
      fail(lines[i], "more tetrahedra than the " + std::to_string(*announced) + " announced");
    read_tetrahedron(lines[i], *neighbours, lines[i + 1], *perms, next++, result.gluings);
    ++i;
  }
  if (!announced) throw InvalidInput("SnapPea file: the number of tetrahedra is missing");
  if (next < *announced)
    throw InvalidInput("SnapPea file: " + std::to_string(*announced) +
                       " tetrahedra are announced, but tetrahedron " + std::to_string(next) +
                       " is missing; expected a line of four neighbours and a line of four "
                       "permutations for each");
  require_consistent(result.gluings, OpenFaces::kAllowed);
  return result;
}

std::string write_snappea(const NamedGluings& triangulation) {
  const Gluings& gluings = triangulation.gluings;
  require_consistent(gluings, OpenFaces::kRefused);
  std::string name = triangulation.name.empty() ? "Tripus" : triangulation.name;
  for (char& c : name)
    if (static_cast<unsigned char>(c) <= ' ' || c == '/') c = '_';
  std::string out = "% Triangulation\n" + name +
                    "\nnot_attempted 0.0\nunknown_orientability\nCS_unknown\n\n0 0\n\n" +
                    std::to_string(gluings.tetrahedron_count()) + "\n";
  for (std::size_t t = 0; t < gluings.tetrahedron_count(); ++t) {
    for (int f = 0; f < 4; ++f) out += " " + std::to_string(gluings.neighbour(t, f));
    out += "\n";
    for (int f = 0; f < 4; ++f) {
      const auto letters = word(gluings.gluing(t, f));
      out += " ";
      out.append(letters.begin(), letters.end());
    }
    out += "\n -1 -1 -1 -1\n";
    for (int curve = 0; curve < 4; ++curve) out += " 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0\n";
    out += " 0.0 0.0\n\n";
  }
  return out;
}

}  // namespace tripus::topology
