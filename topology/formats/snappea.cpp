#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "base/error.hpp"
#include "topology/detail/text.hpp"
#include "topology/formats/formats.hpp"

// Where the lines of a file are as most write them, it is read by lines and not by fields: programs
// disagree about what stands between the two lines that matter (Orb adds edge data, older SnapPea
// leaves the curves out), but all write four neighbours on one line and four permutations on the
// next. SnapPea itself reads by fields, and so is read what has no such lines.

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

/// SnapPea's kinds of solutions, one of which stands behind the name.
constexpr std::array<std::string_view, 8> kSolutions{
    "not_attempted",       "geometric_solution", "nongeometric_solution", "flat_solution",
    "degenerate_solution", "other_solution",     "no_solution",           "externally_computed"};

/// The line of the kind of the solution: the third, or the second if the name is empty.
std::size_t solution_line(const std::vector<Line>& lines) {
  if (lines.size() < 2) return lines.size();
  std::string_view second = lines[1].text;
  const bool is_unnamed =
      std::ranges::find(kSolutions, detail::take_token(second)) != kSolutions.end();
  return is_unnamed ? 1 : 2;
}

/// Tokens with their lines, from the kind of the solution on.
struct Token {
  std::string_view text;
  std::size_t line;
};

std::vector<Token> tokens_of(const std::vector<Line>& lines) {
  std::vector<Token> tokens;
  for (std::size_t i = solution_line(lines); i < lines.size(); ++i)
    for (std::string_view rest = lines[i].text; !rest.empty();)
      if (const auto token = detail::take_token(rest); !token.empty())
        tokens.push_back({token, lines[i].number});
  return tokens;
}

bool is_cusp(std::string_view token) {
  return token == "torus" || token == "Torus" || token == "klein" || token == "Klein" ||
         token == "KLEIN" || token == "TORUS";
}

/// A number that is not 0 in whatever notation; what is no number counts as 0.
bool is_not_zero(std::string_view token) {
  return token.substr(0, token.find_first_of("eE")).find_first_of("123456789") !=
         std::string_view::npos;
}

/// The number of cusps. Throws Unsupported for a filling.
std::size_t count_cusps(const std::vector<Token>& tokens) {
  std::size_t cusps = 0;
  for (std::size_t i = 0; i + 2 < tokens.size(); ++i) {
    if (!is_cusp(tokens[i].text)) continue;
    const std::string_view m = tokens[i + 1].text, l = tokens[i + 2].text;
    if (is_not_zero(m) || is_not_zero(l))
      throw Unsupported("SnapPea file, line " + std::to_string(tokens[i].line) + ": cusp " +
                        std::to_string(cusps) + " has the Dehn filling " +
                        quoted("(" + std::string(m) + "," + std::string(l) + ")") +
                        "; fillings are not supported yet: triangulate the filled manifold first, "
                        "in SnapPy by filled_triangulation()");
    ++cusps;
  }
  return cusps;
}

/// By lines: see the top of this file.
Gluings read_by_lines(const std::vector<Line>& lines) {
  Gluings gluings;
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
      gluings = Gluings(*announced);
      continue;
    }
    if (!announced) fail(lines[i], "a tetrahedron before the number of tetrahedra");
    if (next == *announced)
      fail(lines[i], "more tetrahedra than the " + std::to_string(*announced) + " announced");
    read_tetrahedron(lines[i], *neighbours, lines[i + 1], *perms, next++, gluings);
    ++i;
  }
  if (!announced) throw InvalidInput("SnapPea file: the number of tetrahedra is missing");
  if (next < *announced)
    throw InvalidInput("SnapPea file: " + std::to_string(*announced) +
                       " tetrahedra are announced, but tetrahedron " + std::to_string(next) +
                       " is missing; expected a line of four neighbours and a line of four "
                       "permutations for each");
  return gluings;
}

/// By tokens, as SnapPea itself reads, whatever the lines; everything must be there.
Gluings read_by_tokens(const std::vector<Token>& tokens) {
  std::size_t next = 0;
  const auto take = [&](const std::string& what) -> const Token& {
    if (next == tokens.size()) throw InvalidInput("SnapPea file: it ends before " + what);
    return tokens[next++];
  };
  const auto number = [&](const std::string& what) {
    const Token& token = take(what);
    const auto value = detail::parse_integer(token.text);
    if (!value || *value < 0)
      fail({token.line, token.text}, quoted(std::string(token.text)) + " as " + what);
    return static_cast<std::size_t>(*value);
  };
  take("the kind of the solution");
  take("the volume");
  take("the orientability");
  if (take("the Chern-Simons invariant").text == "CS_known") take("the Chern-Simons invariant");
  const std::size_t cusps = number("the number of torus cusps") + number("that of Klein bottles");
  for (std::size_t i = 0; i < cusps; ++i)
    for (int k = 0; k < 3; ++k) take("the cusps");
  const std::size_t count = number("the number of tetrahedra");
  // Neighbours, permutations, cusps, four times sixteen numbers of curves, a shape.
  constexpr std::size_t kEach = 4 + 4 + 4 + 64 + 2;
  if (count > (tokens.size() - next) / kEach)
    throw InvalidInput("SnapPea file: " + std::to_string(count) +
                       " tetrahedra are announced, more than the file has numbers for");
  Gluings gluings(count);
  for (std::size_t t = 0; t < count; ++t, next += kEach) {
    Tokens neighbours, perms;
    for (std::size_t f = 0; f < 4; ++f) {
      neighbours[f] = tokens[next + f].text;
      perms[f] = tokens[next + 4 + f].text;
    }
    read_tetrahedron({tokens[next].line, {}}, neighbours, {tokens[next + 4].line, {}}, perms, t,
                     gluings);
  }
  return gluings;
}

/// Whether the two lines of some tetrahedron stand as programs write them.
bool has_pair_of_lines(const std::vector<Line>& lines) {
  for (std::size_t i = 2; i + 1 < lines.size(); ++i)
    if (four_tokens(lines[i].text, is_index) && four_tokens(lines[i + 1].text, looks_like_perm))
      return true;
  return false;
}

}  // namespace

NamedGluings read_snappea(std::string_view text) {
  const std::vector<Line> lines = significant_lines(text);
  if (lines.empty() || !(lines[0].text.starts_with("% Triangulation") ||
                         lines[0].text.starts_with("% triangulation")))
    throw InvalidInput("SnapPea file: the first line is " +
                       quoted(lines.empty() ? "" : std::string(lines[0].text)) +
                       "; expected \"% Triangulation\"");
  NamedGluings result;
  if (lines.size() > 1 && solution_line(lines) > 1) result.name = lines[1].text;
  const std::vector<Token> tokens = tokens_of(lines);
  if (count_cusps(tokens) > 0)
    result.notes.push_back("peripheral curves and shapes of the SnapPea file not read");
  const bool is_free = !has_pair_of_lines(lines) && tokens.size() > 20;
  result.gluings = is_free ? read_by_tokens(tokens) : read_by_lines(lines);
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

namespace tripus::topology::registered_formats {
namespace {

bool starts_snappea(std::string_view text) { return text.front() == '%'; }

}  // namespace

std::span<const Format> snappea() {
  static constexpr Format kRows[] = {
      {"SnapPea triangulation", starts_snappea, read_one<read_snappea>, 2}};
  return kRows;
}

}  // namespace tripus::topology::registered_formats
