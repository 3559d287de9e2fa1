#include <cmath>
#include <queue>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "meshing/detail/filling.hpp"
#include "meshing/predicates.hpp"

namespace tripus::meshing::detail {
namespace {

int sign_of(const TetrahedralMesh& mesh, const Tetrahedron& t) {
  const auto& p = mesh.points;
  return orientation(p[t[0]], p[t[1]], p[t[2]], p[t[3]]);
}

/// Whether it could be split: its first part keeps its place, the others come last.
bool split(TetrahedralMesh& mesh, std::size_t place) {
  const Tetrahedron whole = mesh.tetrahedra[place];
  Point centroid{};
  for (const std::uint32_t corner : whole)
    for (std::size_t k = 0; k < 3; ++k) centroid[k] += mesh.points[corner][k] / 4;
  const auto centre = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.push_back(centroid);
  std::array<Tetrahedron, 4> parts;
  const int sign = sign_of(mesh, whole);
  for (std::size_t k = 0; k < 4; ++k) {
    parts[k] = whole;
    parts[k][k] = centre;
    if (sign_of(mesh, parts[k]) == sign) continue;
    mesh.points.pop_back();
    return false;
  }
  mesh.tetrahedra[place] = parts[0];
  mesh.tetrahedra.insert(mesh.tetrahedra.end(), parts.begin() + 1, parts.end());
  return true;
}

}  // namespace

double volume_of(const TetrahedralMesh& mesh, const Tetrahedron& t) {
  const Point& o = mesh.points[t[0]];
  std::array<Point, 3> v;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) v[i][k] = mesh.points[t[i + 1]][k] - o[k];
  return std::fabs(v[0][0] * (v[1][1] * v[2][2] - v[1][2] * v[2][1]) +
                   v[0][1] * (v[1][2] * v[2][0] - v[1][0] * v[2][2]) +
                   v[0][2] * (v[1][0] * v[2][1] - v[1][1] * v[2][0])) /
         6;
}

void split_largest(TetrahedralMesh& mesh, const SplitOptions& options) {
  if (options.max_volume == 0 && options.tetrahedra == 0) return;
  std::priority_queue<std::pair<double, std::size_t>> largest;
  const auto add = [&](std::size_t place) {
    const double volume = volume_of(mesh, mesh.tetrahedra[place]);
    if (mesh.tetrahedra.size() < options.tetrahedra ||
        (options.max_volume > 0 && volume > options.max_volume))
      largest.emplace(volume, place);
  };
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) add(t);
  while (!largest.empty()) {
    const auto [volume, place] = largest.top();
    largest.pop();
    const bool too_large = options.max_volume > 0 && volume > options.max_volume;
    if (!too_large && mesh.tetrahedra.size() >= options.tetrahedra) return;
    if (mesh.tetrahedra.size() + 3 > options.most)
      throw Unsupported("so small a volume or so great a number would take more than " +
                        std::to_string(options.most) +
                        " tetrahedra, more than there is memory for");
    if (!split(mesh, place)) {
      if (too_large)
        throw Unsupported(
            "a tetrahedron larger than the largest volume allowed is too flat to be split; "
            "remesh the surface more evenly, or allow a larger volume");
      continue;
    }
    add(place);
    for (std::size_t t = mesh.tetrahedra.size() - 3; t < mesh.tetrahedra.size(); ++t) add(t);
  }
}

}  // namespace tripus::meshing::detail
