#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <vector>

#include "base/error.hpp"
#include "meshing/detail/mending.hpp"
#include "meshing/detail/point_hash.hpp"
#include "meshing/validate.hpp"

namespace tripus::meshing::detail {
namespace {

/// The points that are in one place with others.
std::vector<std::uint32_t> doubled_points(const std::vector<Point>& points) {
  std::unordered_map<Point, std::vector<std::uint32_t>, PointHash> at;
  at.reserve(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    Point point = points[i];
    for (double& x : point)
      if (x == 0) x = 0;  // -0 and 0 are equal, and hash alike
    at[point].push_back(i);
  }
  std::vector<std::uint32_t> doubled;
  for (const auto& [point, numbers] : at)
    if (numbers.size() > 1) doubled.insert(doubled.end(), numbers.begin(), numbers.end());
  std::sort(doubled.begin(), doubled.end());
  return doubled;
}

/// The middle of the neighbours of each point, every neighbour as often as triangles have both.
std::vector<Point> middles_of_neighbours(const SurfaceMesh& mesh) {
  std::vector<Point> sums(mesh.points.size(), Point{});
  std::vector<double> counts(mesh.points.size(), 0);
  for (const Triangle& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      for (const std::size_t j : {(k + 1) % 3, (k + 2) % 3}) {
        for (std::size_t c = 0; c < 3; ++c) sums[t[k]][c] += mesh.points[t[j]][c];
        ++counts[t[k]];
      }
  for (std::size_t i = 0; i < sums.size(); ++i)
    for (double& x : sums[i]) x /= std::max(counts[i], 1.0);
  return sums;
}

bool is_valid(const SurfaceMesh& mesh) {
  try {
    (void)require_valid(mesh);
    return true;
  } catch (const InvalidInput&) {
    return false;
  }
}

}  // namespace

std::optional<SheetsApart> sheets_apart(const SurfaceMesh& mesh) {
  const std::vector<std::uint32_t> doubled = doubled_points(mesh.points);
  if (doubled.empty() || !edges_of(mesh.triangles).is_closed()) return std::nullopt;
  const std::vector<Point> middles = middles_of_neighbours(mesh);
  // Large parts first: what is wide apart is easy to fill.
  for (const double part : {0.03, 0.003, 3e-4, 3e-5}) {
    SheetsApart result{mesh, doubled.size(), 0};
    for (const std::uint32_t i : doubled) {
      Point& p = result.mesh.points[i];
      double square = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        const double step = part * (middles[i][c] - p[c]);
        p[c] += step;
        square += step * step;
      }
      result.distance = std::max(result.distance, std::sqrt(square));
    }
    if (is_valid(result.mesh)) return result;
  }
  return std::nullopt;
}

}  // namespace tripus::meshing::detail
