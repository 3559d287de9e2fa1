#include "meshing/formats/off.hpp"

#include "meshing/detail/scanner.hpp"
#include "meshing/detail/text.hpp"

namespace tripus::meshing {
namespace {

using detail::Scanner;

void read_points(Scanner& in, std::uint32_t count, SurfaceFile& file) {
  for (std::uint32_t i = 0; i < count; ++i) {
    file.mesh.points.push_back(in.point());
    file.lines.points.push_back(in.line());
    while (!in.word_of_line().empty()) {
    }  // normals, colours
  }
}

void read_faces(Scanner& in, std::uint32_t count, SurfaceFile& file) {
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::string_view corners = in.word();
    if (corners.empty())
      in.fail("the file ends after " + std::to_string(i) + " of " + std::to_string(count) +
              " faces");
    if (const std::uint32_t sides = in.natural(corners, "the number of corners of a face");
        sides != 3)
      in.fail("face " + std::to_string(i) + detail::not_a_triangle(sides));
    Triangle triangle;
    for (std::uint32_t& corner : triangle)
      corner = in.index(in.word_of_line(), 0, file.mesh.points.size());
    file.mesh.triangles.push_back(triangle);
    file.lines.cells.push_back(in.line());
    while (!in.word_of_line().empty()) {
    }  // colours
  }
}

}  // namespace

SurfaceFile read_off(std::string_view text) {
  Scanner in("OFF", text, '#');
  const std::string_view head = in.word();
  if (!head.ends_with("OFF")) in.fail("the file does not begin with OFF");
  if (head != "OFF" && head != "COFF" && head != "NOFF" && head != "CNOFF" && head != "STOFF")
    in.fail(quoted(std::string(head.substr(0, 16))) +
            " is not supported; save it as OFF in three "
            "dimensions");
  if (in.word_of_line() == "BINARY") in.fail("binary OFF is not supported; save it as text");
  in = Scanner("OFF", text, '#');
  in.word();
  SurfaceFile file;
  const std::uint32_t points = in.count("the number of points", 6);
  const std::uint32_t faces = in.count("the number of faces", 8);
  // The number of edges is often missing or wrong; nobody needs it.
  in.word_of_line();
  file.mesh.points.reserve(points);
  file.mesh.triangles.reserve(faces);
  read_points(in, points, file);
  read_faces(in, faces, file);
  if (const std::string_view extra = in.word(); !extra.empty())
    in.fail(quoted(std::string(extra.substr(0, 64))) + " after the last of " +
            std::to_string(faces) + " faces; are the counts at the top right?");
  return file;
}

std::string write_off(const SurfaceMesh& mesh) {
  std::string out = "OFF\n" + std::to_string(mesh.points.size()) + " " +
                    std::to_string(mesh.triangles.size()) + " 0\n";
  for (const Point& point : mesh.points) detail::append_numbers(out, point);
  for (const Triangle& t : mesh.triangles)
    out += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) +
           "\n";
  return out;
}

}  // namespace tripus::meshing
