#include "meshing/formats/obj.hpp"

#include <algorithm>
#include <array>

#include "meshing/detail/scanner.hpp"
#include "meshing/detail/text.hpp"

namespace tripus::meshing {
namespace {

using detail::Scanner;

constexpr std::array<std::string_view, 13> kSkipped{
    "vt", "vn", "vp", "o", "g", "s", "mg", "usemtl", "mtllib", "usemap", "maplib", "l", "p"};

/// The point of a corner "7", "7/1", "7//3" or "-1/2/3", counted from 0. It may come later in the
/// file, so only its sign is checked here.
std::uint32_t read_corner(const Scanner& in, std::string_view word, std::size_t points_so_far) {
  std::string_view digits = word.substr(0, word.find('/'));
  const bool relative = digits.starts_with('-');
  if (relative) digits.remove_prefix(1);
  const std::uint32_t value = in.natural(digits, "the number of a point");
  if (value == 0) in.fail("point 0 does not exist; OBJ numbers points from 1");
  if (!relative) return value - 1;
  if (value > points_so_far)
    in.fail("point -" + std::to_string(value) + " does not exist; so far there are " +
            std::to_string(points_so_far) + " points");
  return static_cast<std::uint32_t>(points_so_far) - value;
}

void read_face(Scanner& in, SurfaceFile& file) {
  Triangle triangle{};
  std::size_t sides = 0;
  for (std::string_view word = in.word_of_line(); !word.empty(); word = in.word_of_line()) {
    const std::uint32_t corner = read_corner(in, word, file.mesh.points.size());
    if (sides < 3) triangle[sides] = corner;
    ++sides;
  }
  if (sides != 3)
    in.fail("face " + std::to_string(file.mesh.triangles.size()) + detail::not_a_triangle(sides));
  file.mesh.triangles.push_back(triangle);
  file.lines.cells.push_back(in.line());
}

}  // namespace

SurfaceFile read_obj(std::string_view text) {
  Scanner in("OBJ", text, '#');
  SurfaceFile file;
  do {
    const std::string_view key = in.word_of_line();
    if (key.empty()) continue;
    if (key == "v") {
      Point point;
      for (double& x : point) x = in.number(in.word_of_line(), "a coordinate");
      file.mesh.points.push_back(point);
      file.lines.points.push_back(in.line());
    } else if (key == "f") {
      read_face(in, file);
    } else if (std::find(kSkipped.begin(), kSkipped.end(), key) == kSkipped.end()) {
      in.fail(quoted(std::string(key.substr(0, 32))) +
              " is not supported; save the surface as plain triangles (v and f lines)");
    }
  } while (in.next_line());
  for (std::size_t t = 0; t < file.mesh.triangles.size(); ++t)
    for (const std::uint32_t corner : file.mesh.triangles[t])
      if (corner >= file.mesh.points.size())
        in.fail_at(file.lines.cells[t], "point " + std::to_string(corner + std::uint64_t{1}) +
                                            " does not exist; the file has " +
                                            std::to_string(file.mesh.points.size()) +
                                            " points, numbered from 1");
  return file;
}

}  // namespace tripus::meshing
