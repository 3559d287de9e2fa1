// A format of meshes of one's own: a triangle a line, as nine numbers, by the name .raw. This file
// is all that it takes: `tripus solve FILE.raw` reads it, mends it and checks it as it does any
// surface.
#include <map>
#include <sstream>
#include <string>

#include "base/error.hpp"
#include "meshing/formats/read_mesh.hpp"

namespace tripus::meshing::registered_mesh_formats {
namespace {

bool is_raw(std::string_view, std::string_view name) { return name.ends_with(".raw"); }

/// The format repeats every corner; equal ones become one point.
MeshFile read(std::string_view content, std::string_view, const ReadFile&) {
  SurfaceFile file;
  std::map<Point, std::uint32_t> numbers;
  std::istringstream lines{std::string(content)};
  std::string line;
  for (std::uint32_t number = 1; std::getline(lines, line); ++number) {
    std::istringstream fields(line);
    if (!(fields >> std::ws) || fields.eof()) continue;
    Triangle triangle{};
    for (std::uint32_t& corner : triangle) {
      Point p{};
      if (!(fields >> p[0] >> p[1] >> p[2]))
        throw InvalidInput("line " + std::to_string(number) + ": expected nine numbers");
      const auto next = static_cast<std::uint32_t>(file.mesh.points.size());
      const auto [place, is_new] = numbers.emplace(p, next);
      if (is_new) file.mesh.points.push_back(p);
      corner = place->second;
    }
    if (!(fields >> std::ws).eof())
      throw InvalidInput("line " + std::to_string(number) + ": more than nine numbers");
    file.mesh.triangles.push_back(triangle);
    file.lines.cells.push_back(number);
  }
  return file;
}

}  // namespace

std::span<const MeshFormat> raw_triangles() {
  static constexpr MeshFormat kRows[] = {{"raw triangles", is_raw, read}};
  return kRows;
}

}  // namespace tripus::meshing::registered_mesh_formats
