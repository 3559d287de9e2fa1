#include <algorithm>
#include <array>
#include <vector>

#include "base/error.hpp"
#include "topology/detail/text.hpp"
#include "topology/formats/formats.hpp"
#include "topology/isomorphism.hpp"
#include "topology/triangulation.hpp"

// A row of the file is an edge class: index, colour, label, two vertex indices if the line
// "vertices_known" came before, and the corners in cyclic order, each <tetrahedron><face><face>, as
// "6xv": the edge of tetrahedron 6 (from 1) in which the faces x and v meet. Between two corners of
// a row lies a face: the first of the earlier one is glued to the second of the later one.

namespace tripus::topology {
namespace {

constexpr std::string_view kFaceLetters = "uvwx";  // faces 0 1 2 3

/// For two faces, the third face that comes after them; Orb's table, -1 on the diagonal.
constexpr int kThirdFace[4][4] = {{-1, 2, 3, 1}, {3, -1, 0, 2}, {1, 3, -1, 0}, {2, 0, 1, -1}};

struct OrbCorner {
  std::size_t tetrahedron = 0;
  std::array<int, 2> faces{};
};

struct OrbRow {
  std::size_t line = 0;
  ConeAngle angle;
  std::vector<OrbCorner> corners;
};

[[noreturn]] void refuse_orb(std::size_t line, const std::string& what) {
  throw InvalidInput("Orb file: line " + std::to_string(line) + ": " + what);
}

OrbCorner parse_corner(std::string_view token, std::size_t line) {
  OrbCorner corner;
  const auto bad = [&]() {
    refuse_orb(line, quoted(std::string(token)) +
                         " is not a corner; expected a tetrahedron and two different faces, such "
                         "as 6xv");
  };
  if (token.size() < 3) bad();
  const auto number = detail::parse_integer(token.substr(0, token.size() - 2));
  if (!number || *number < 1 || *number > static_cast<std::int64_t>(kMaxTetrahedra)) bad();
  corner.tetrahedron = static_cast<std::size_t>(*number - 1);
  for (std::size_t i = 0; i < 2; ++i) {
    const std::size_t face = kFaceLetters.find(token[token.size() - 2 + i]);
    if (face == std::string_view::npos) bad();
    corner.faces[i] = static_cast<int>(face);
  }
  if (corner.faces[0] == corner.faces[1]) bad();
  return corner;
}

OrbRow parse_row(std::string_view text, std::size_t line, bool vertices_known) {
  OrbRow row;
  row.line = line;
  for (const char* what : {"the index of an edge", "its colour"}) {
    const auto token = detail::take_token(text);
    if (!detail::parse_integer(token))
      refuse_orb(line, "expected " + std::string(what) + ", found " + quoted(std::string(token)));
  }
  const auto label = detail::take_token(text);
  try {
    row.angle = parse_cone_order(label);
  } catch (const InvalidInput& error) {
    refuse_orb(line, error.what());
  }
  if (vertices_known)
    for (int i = 0; i < 2; ++i)
      if (!detail::parse_integer(detail::take_token(text)))
        refuse_orb(line, "expected the indices of two vertices");
  for (auto token = detail::take_token(text); !token.empty(); token = detail::take_token(text))
    row.corners.push_back(parse_corner(token, line));
  if (row.corners.empty()) refuse_orb(line, "expected the corners of an edge, such as 6xv");
  return row;
}

/// The faces of a corner completed to a permutation: a1, a2, then the two others in Orb's order.
std::array<int, 4> completed_faces(const OrbCorner& corner) {
  const int a = corner.faces[0], b = corner.faces[1];
  return {a, b, kThirdFace[a][b], kThirdFace[b][a]};
}

/// Face a1 of the earlier corner is glued to face b2 of the later: a1 to b2, a2 to b1, a3 to b3, a4
/// to b4.
void glue_corners(const OrbCorner& earlier, const OrbCorner& later, std::size_t line,
                  Gluings& gluings) {
  const auto from = completed_faces(earlier);
  const auto b = completed_faces(later);
  const std::array<int, 4> to = {b[1], b[0], b[2], b[3]};
  std::array<int, 4> images{};
  for (std::size_t i = 0; i < 4; ++i) images[static_cast<std::size_t>(from[i])] = to[i];
  const Perm4 p = Perm4::from_images(images[0], images[1], images[2], images[3]);
  const auto set = [&](std::size_t t, int face, std::size_t other, Perm4 q) {
    if (gluings.is_open(t, face)) {
      gluings.set_one_side(t, face, static_cast<TetrahedronIndex>(other), q);
    } else if (gluings.neighbour(t, face) != other || gluings.gluing(t, face) != q) {
      refuse_orb(line, "face " + std::string(1, kFaceLetters[static_cast<std::size_t>(face)]) +
                           " of tetrahedron " + std::to_string(t + 1) +
                           " is glued in two ways; every edge around it must say the same");
    }
  };
  set(earlier.tetrahedron, earlier.faces[0], later.tetrahedron, p);
  set(later.tetrahedron, later.faces[1], earlier.tetrahedron, p.inverse());
}

/// Lines ended by \n, \r\n or \r.
std::vector<std::string_view> orb_lines(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = text.find_first_of("\r\n");
    lines.push_back(text.substr(0, end));
    if (end == std::string_view::npos) break;
    const bool both = text[end] == '\r' && end + 1 < text.size() && text[end + 1] == '\n';
    text.remove_prefix(end + (both ? 2 : 1));
  }
  return lines;
}

/// The same with all gluings odd: the vertices 2 and 3 of every other tetrahedron swapped. The
/// permutations that the format knows are odd.
NamedGluings oriented_for_orb(const NamedGluings& given) {
  const Triangulation triangulation(given.gluings);
  if (!triangulation.is_orientable())
    throw InvalidInput("the triangulation is not orientable; Orb's format has oriented ones only");
  constexpr Perm4 kSwap = Perm4::from_images(0, 1, 3, 2);
  Isomorphism relabelling;
  const std::size_t count = triangulation.tetrahedron_count();
  relabelling.perms.resize(count);
  for (std::size_t t = 0; t < count; ++t)
    relabelling.tetrahedron_images.push_back(static_cast<TetrahedronIndex>(t));
  std::vector<bool> seen(count);
  std::vector<std::size_t> todo;
  for (std::size_t start = 0; start < count; ++start) {
    if (seen[start]) continue;
    seen[start] = true;
    todo.push_back(start);
    while (!todo.empty()) {
      const std::size_t t = todo.back();
      todo.pop_back();
      for (int f = 0; f < 4; ++f) {
        const std::size_t other = given.gluings.neighbour(t, f);
        if (seen[other]) continue;
        seen[other] = true;
        todo.push_back(other);
        const bool upright = relabelling.perms[t] == Perm4();
        relabelling.perms[other] = given.gluings.gluing(t, f).is_odd() == upright ? Perm4() : kSwap;
      }
    }
  }
  NamedGluings result{given.name, relabelled(given.gluings, relabelling), {}};
  const Triangulation after(result.gluings);
  const auto angles = completed(given.cone_angles, triangulation.edge_count());
  result.cone_angles.resize(angles.size());
  for (std::size_t e = 0; e < angles.size(); ++e) {
    const EdgeCorner corner = triangulation.corners(e)[0];
    const auto& ends = kEdgeEnds[static_cast<std::size_t>(corner.edge())];
    const Perm4 p = relabelling.perms[corner.tetrahedron()];
    result.cone_angles[after.edge_class(
        corner.tetrahedron(),
        kEdgeNumber[static_cast<std::size_t>(p(ends[0]))][static_cast<std::size_t>(p(ends[1]))])] =
        angles[e];
  }
  return result;
}

int other_end(int face, int edge) {
  // The face that meets `face` in that edge: neither it nor an end.
  const auto& ends = kEdgeEnds[static_cast<std::size_t>(edge)];
  return 6 - face - ends[0] - ends[1];
}

}  // namespace

NamedGluings read_orb(std::string_view text) {
  const auto lines = orb_lines(text);
  NamedGluings result;
  if (lines.size() < 3 || !lines[0].starts_with("% orb"))
    throw InvalidInput("Orb file: expected \"% orb\", a name and a solution type in three lines");
  result.name = detail::trimmed(lines[1]);
  std::vector<OrbRow> rows;
  bool vertices_known = false;
  std::size_t tetrahedra = 0, corners = 0;
  for (std::size_t i = 2; i < lines.size(); ++i) {
    const std::string_view line = detail::trimmed(lines[i]);
    if (line.starts_with("SolutionType")) continue;
    if (line == "vertices_known") {
      vertices_known = true;
      continue;
    }
    if (line.empty()) {
      if (rows.empty()) continue;
      break;
    }
    rows.push_back(parse_row(line, i + 1, vertices_known));
    corners += rows.back().corners.size();
    for (const OrbCorner& corner : rows.back().corners)
      tetrahedra = std::max(tetrahedra, corner.tetrahedron + 1);
  }
  if (corners != 6 * tetrahedra)
    throw InvalidInput("Orb file: the rows have " + std::to_string(corners) + " corners, but " +
                       std::to_string(tetrahedra) + " tetrahedra have " +
                       std::to_string(6 * tetrahedra));
  result.gluings = Gluings(tetrahedra);
  for (const OrbRow& row : rows)
    for (std::size_t c = 0; c < row.corners.size(); ++c)
      glue_corners(row.corners[c], row.corners[(c + 1) % row.corners.size()], row.line,
                   result.gluings);
  require_consistent(result.gluings, OpenFaces::kRefused);
  if (tetrahedra == 0) return result;
  const Triangulation triangulation(result.gluings);
  result.cone_angles.resize(triangulation.edge_count());
  for (const OrbRow& row : rows) {
    const OrbCorner& corner = row.corners[0];
    int ends[2], count = 0;
    for (int v = 0; v < 4; ++v)
      if (v != corner.faces[0] && v != corner.faces[1]) ends[count++] = v;
    result.cone_angles[triangulation.edge_class(
        corner.tetrahedron,
        kEdgeNumber[static_cast<std::size_t>(ends[0])][static_cast<std::size_t>(ends[1])])] =
        row.angle;
  }
  if (all_full(result.cone_angles)) result.cone_angles.clear();
  return result;
}

std::string write_orb(const NamedGluings& given) {
  const NamedGluings named = oriented_for_orb(given);
  const Triangulation triangulation(named.gluings);
  const std::vector<ConeAngle>& angles = named.cone_angles;
  std::string out =
      "% orb\n" + (named.name.empty() ? "untitled" : named.name) + "\nSolutionType not_attempted\n";
  int colour = 0;
  for (std::size_t e = 0; e < angles.size(); ++e) {
    if (!angles[e].is_rational())
      throw InvalidInput("the cone angle of edge class " + std::to_string(e) +
                         " is not a rational multiple of pi; Orb's format has cone orders only");
    out += std::to_string(e + 1) + " " + std::to_string(angles[e].is_full() ? 0 : ++colour) + " " +
           angles[e].order_text();
    // Walk around the edge across the first face of each corner.
    const EdgeCorner first = triangulation.corners(e)[0];
    std::size_t t = first.tetrahedron();
    int edge = first.edge();
    int face = 0;
    while (face == kEdgeEnds[static_cast<std::size_t>(edge)][0] ||
           face == kEdgeEnds[static_cast<std::size_t>(edge)][1])
      ++face;
    for (std::size_t n = 0; n < triangulation.valence(e); ++n) {
      const int behind = other_end(face, edge);
      out += (n == 0 ? "  " : " ") + std::to_string(t + 1) +
             kFaceLetters[static_cast<std::size_t>(face)] +
             kFaceLetters[static_cast<std::size_t>(behind)];
      const Perm4 p = triangulation.gluings().gluing(t, face);
      const auto& ends = kEdgeEnds[static_cast<std::size_t>(edge)];
      const int next_edge =
          kEdgeNumber[static_cast<std::size_t>(p(ends[0]))][static_cast<std::size_t>(p(ends[1]))];
      const int next_face = p(behind);
      t = triangulation.gluings().neighbour(t, face);
      edge = next_edge;
      face = next_face;
    }
    out += "\n";
  }
  return out + "\n";
}

}  // namespace tripus::topology

namespace tripus::topology::registered_formats {
namespace {

bool starts_orb(std::string_view text) { return text.starts_with("% orb"); }

}  // namespace

std::span<const Format> orb() {
  static constexpr Format kRows[] = {{"Orb triangulation", starts_orb, read_one<read_orb>, 1}};
  return kRows;
}

}  // namespace tripus::topology::registered_formats
