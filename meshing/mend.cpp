#include "meshing/mend.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "base/error.hpp"
#include "base/tolerances.hpp"
#include "meshing/detail/connectivity.hpp"
#include "meshing/detail/faces.hpp"
#include "meshing/detail/mending.hpp"
#include "meshing/detail/point_hash.hpp"
#include "meshing/predicates.hpp"

// Mending is by trial: a trial changes a copy, and is kept only if every edge is then in exactly
// two triangles. So nothing is welded, split or left out that was good as it stood.

namespace tripus::meshing {
namespace {

using detail::counted;
using detail::OpenEdge;
using detail::PointHash;

constexpr std::uint32_t kNone = UINT32_MAX;

/// A surface with the places in the file of its points and triangles.
struct Patch {
  SurfaceMesh mesh;
  std::vector<std::uint32_t> point_of, cell_of;
};

template <class Cells>
bool is_usable(const std::vector<Point>& points, const Cells& cells) {
  for (const Point& p : points)
    for (const double x : p)
      if (!in_exact_range(x)) return false;
  for (const auto& cell : cells)
    for (const std::uint32_t corner : cell)
      if (corner >= points.size()) return false;
  return !cells.empty() && points.size() < kNone;
}

std::vector<std::uint32_t> numbers_up_to(std::size_t count) {
  std::vector<std::uint32_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0u);
  return numbers;
}

/// The first of the points in the same place, for each point.
std::vector<std::uint32_t> first_equal(const std::vector<Point>& points, std::size_t& merged) {
  std::unordered_map<Point, std::uint32_t, PointHash> numbers;
  numbers.reserve(points.size());
  std::vector<std::uint32_t> first(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    Point point = points[i];
    for (double& x : point)
      if (x == 0) x = 0;  // -0 and 0 are equal, and hash alike
    first[i] = numbers.try_emplace(point, i).first->second;
    if (first[i] != i) ++merged;
  }
  return first;
}

template <class Cells>
void renumber(Cells& cells, const std::vector<std::uint32_t>& numbers) {
  for (auto& cell : cells)
    for (std::uint32_t& corner : cell) corner = numbers[corner];
}

template <std::size_t Corners>
bool has_repeated_corner(std::array<std::uint32_t, Corners> cell) {
  std::sort(cell.begin(), cell.end());
  return std::adjacent_find(cell.begin(), cell.end()) != cell.end();
}

/// Leaves out the triangles that `drop` names; returns how many.
template <class Drop>
std::size_t drop_triangles(Patch& patch, Drop drop) {
  auto& triangles = patch.mesh.triangles;
  std::size_t kept = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (drop(t)) continue;
    triangles[kept] = triangles[t];
    patch.cell_of[kept++] = patch.cell_of[t];
  }
  const std::size_t dropped = triangles.size() - kept;
  triangles.resize(kept);
  patch.cell_of.resize(kept);
  return dropped;
}

std::size_t drop_repeated_corners(Patch& patch) {
  return drop_triangles(
      patch, [&](std::size_t t) { return has_repeated_corner(patch.mesh.triangles[t]); });
}

std::size_t drop_collinear(Patch& patch) {
  return drop_triangles(patch, [&](std::size_t t) {
    const auto& [points, triangles] = patch.mesh;
    return projection_axis(points[triangles[t][0]], points[triangles[t][1]],
                           points[triangles[t][2]]) < 0;
  });
}

template <class Cells>
std::size_t count_unused(std::size_t points, const Cells& cells) {
  std::vector<bool> used(points, false);
  for (const auto& cell : cells)
    for (const std::uint32_t corner : cell) used[corner] = true;
  return static_cast<std::size_t>(std::count(used.begin(), used.end(), false));
}

/// Drops the points that no cell has; `point_of` is shortened alongside.
template <class Cells>
void drop_unused(std::vector<Point>& points, Cells& cells, std::vector<std::uint32_t>& point_of) {
  std::vector<std::uint32_t> number(points.size(), kNone);
  for (const auto& cell : cells)
    for (const std::uint32_t corner : cell) number[corner] = 0;
  std::uint32_t used = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (number[i] == kNone) continue;
    number[i] = used;
    points[used] = points[i];
    point_of[used++] = point_of[i];
  }
  points.resize(used);
  point_of.resize(used);
  renumber(cells, number);
}

/// For each triangle whether another one before it has the same corners (1), or one after it (2).
std::vector<std::uint8_t> twins(const std::vector<Triangle>& triangles) {
  std::vector<std::pair<Triangle, std::uint32_t>> sorted;
  sorted.reserve(triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    Triangle corners = triangles[t];
    std::sort(corners.begin(), corners.end());
    sorted.emplace_back(corners, t);
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::uint8_t> twin(triangles.size(), 0);
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i].first != sorted[i - 1].first) continue;
    twin[sorted[i - 1].second] |= 2;
    twin[sorted[i].second] |= 1;
  }
  return twin;
}

enum class Twins { kKeep, kKeepFirst, kDrop };

std::size_t drop_twins(Patch& patch, Twins how) {
  if (how == Twins::kKeep) return 0;
  const auto twin = twins(patch.mesh.triangles);
  return drop_triangles(patch, [&](std::size_t t) {
    return how == Twins::kKeepFirst ? (twin[t] & 1) != 0 : twin[t] != 0;
  });
}

bool has_twins(const std::vector<Triangle>& triangles) {
  const auto twin = twins(triangles);
  return std::any_of(twin.begin(), twin.end(), [](std::uint8_t each) { return each != 0; });
}

bool has_collinear(const SurfaceMesh& mesh) {
  return std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) {
    return projection_axis(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]) < 0;
  });
}

/// Whether validation will find every edge in two triangles, which are different and proper.
bool is_good(const SurfaceMesh& mesh) {
  return !mesh.triangles.empty() && detail::edges_of(mesh.triangles).is_closed() &&
         !has_collinear(mesh) && !has_twins(mesh.triangles);
}

/// The distances to try, beginning with none.
std::vector<double> tolerances(const std::vector<Point>& points) {
  Point low = points[0], high = points[0];
  double largest = 0;
  for (const Point& p : points)
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
      largest = std::max(largest, std::fabs(p[k]));
    }
  const double size = std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
  std::vector<double> distances{0};
  for (double part = tolerance::kLeastWelding; part <= tolerance::kMostWelding * 1.01; part *= 10)
    distances.push_back(
        std::min(part * std::max(size, largest), tolerance::kMostWeldingOfSize * size));
  return distances;
}

struct Trial {
  double distance = 0;
  Twins twins = Twins::kKeep;
  bool split = false;
};

/// What a trial did, as notes.
std::vector<std::string> attempt(Patch& patch, const Trial& trial) {
  std::vector<std::string> notes;
  char distance[32];
  std::snprintf(distance, sizeof distance, "%.2g", trial.distance);
  std::size_t flat = 0;
  if (trial.distance > 0) {
    const auto open = detail::edges_of(patch.mesh.triangles).open;
    const std::size_t welded = detail::weld(patch.mesh, open, trial.distance);
    if (welded > 0)
      notes.push_back(counted(welded, "point", "points") + " on open edges merged with another, " +
                      "at most " + distance + " away");
    flat += drop_repeated_corners(patch);
  }
  if (const std::size_t dropped = drop_twins(patch, trial.twins); dropped > 0)
    notes.push_back(counted(dropped, "triangle", "triangles") +
                    " with the corners of another left out");
  if (trial.split) {
    flat += drop_collinear(patch);
    const auto open = detail::edges_of(patch.mesh.triangles).open;
    const std::size_t split =
        detail::split_at_points(patch.mesh, patch.cell_of, open, trial.distance);
    if (split > 0)
      notes.push_back(counted(split, "triangle", "triangles") +
                      " split at points in the middle of a side");
  }
  if (flat > 0) notes.push_back(counted(flat, "triangle", "triangles") + " without area left out");
  return notes;
}

/// Tries until the surface is good; the notes of what was done, or nothing.
std::vector<std::string> close(Patch& patch) {
  const auto edges = detail::edges_of(patch.mesh.triangles);
  const bool any_twins = has_twins(patch.mesh.triangles);
  for (const double distance : tolerances(patch.mesh.points)) {
    // Only points on open edges are moved.
    if (distance > 0 && edges.open.empty() && !has_collinear(patch.mesh)) break;
    for (const Twins how : {Twins::kKeep, Twins::kKeepFirst, Twins::kDrop})
      for (const bool split : {false, true}) {
        if (how != Twins::kKeep && !any_twins && distance == 0) continue;
        Patch trial = patch;
        auto notes = attempt(trial, {distance, how, split});
        if (!is_good(trial.mesh)) continue;
        patch = std::move(trial);
        return notes;
      }
  }
  return {};
}

std::vector<std::uint32_t> picked(const std::vector<std::uint32_t>& all,
                                  const std::vector<std::uint32_t>& places) {
  std::vector<std::uint32_t> result;
  for (const std::uint32_t place : places)
    if (place < all.size()) result.push_back(all[place]);
  return result;
}

/// Carries lines and numbers over to what is left.
void keep_places(SourceLines& lines, const std::vector<std::uint32_t>& point_of,
                 const std::vector<std::uint32_t>& cell_of) {
  lines.point_numbers =
      lines.point_numbers.empty() ? point_of : picked(lines.point_numbers, point_of);
  lines.cell_numbers = lines.cell_numbers.empty() ? cell_of : picked(lines.cell_numbers, cell_of);
  lines.points = picked(lines.points, point_of);
  lines.cells = picked(lines.cells, cell_of);
}

/// Parts of one face of the file that reading cut into triangles; halves of one triangle are not.
detail::SameFace same_face(const Patch& patch, const std::vector<std::uint32_t>& numbers) {
  return [&patch, &numbers](std::size_t s, std::size_t t) {
    const std::uint32_t a = patch.cell_of[s], b = patch.cell_of[t];
    return a != b && std::max(a, b) < numbers.size() && numbers[a] == numbers[b];
  };
}

bool is_closed_manifold(const SurfaceMesh& mesh) {
  const SourceLines no_lines;
  try {
    (void)detail::require_closed_manifold(
        mesh.triangles, mesh.points.size(), [](std::size_t) { return std::string(); },
        detail::Places(no_lines, "triangle"));
    return true;
  } catch (const InvalidInput&) {
    return false;
  }
}

/// Where merging points made sheets meet in edges or points, the surface as it was given, with the
/// sheets apart. Whether it was so, and could be.
bool part_sheets(Patch& given, Patch& patch, std::vector<std::string>& notes) {
  if (is_closed_manifold(patch.mesh)) return false;
  drop_unused(given.mesh.points, given.mesh.triangles, given.point_of);
  auto apart = detail::sheets_apart(given.mesh);
  if (!apart) return false;
  patch = std::move(given);
  patch.mesh = std::move(apart->mesh);
  char distance[32];
  std::snprintf(distance, sizeof distance, "%.2g", apart->distance);
  notes = {counted(apart->moved, "point", "points") +
           " in one place with others, where sheets of the surface touch, moved apart by at most " +
           distance};
  return true;
}

void note(std::vector<std::string>& notes, std::size_t count, const char* one, const char* many) {
  if (count > 0) notes.push_back(counted(count, one, many));
}

}  // namespace

SurfaceFile mend(SurfaceFile file) {
  if (!is_usable(file.mesh.points, file.mesh.triangles)) return file;
  std::size_t merged = 0;
  Patch patch{std::move(file.mesh), {}, {}};
  patch.point_of = numbers_up_to(patch.mesh.points.size());
  patch.cell_of = numbers_up_to(patch.mesh.triangles.size());
  const std::size_t unused = count_unused(patch.mesh.points.size(), patch.mesh.triangles);
  const auto first = first_equal(patch.mesh.points, merged);
  Patch given;
  if (merged > 0) given = patch;
  renumber(patch.mesh.triangles, first);
  std::size_t flat = drop_repeated_corners(patch);
  std::vector<std::string> notes;
  const std::vector<std::uint32_t> faces = file.lines.cell_numbers;
  std::size_t turned = 0;
  if (!faces.empty()) turned = detail::uncrowd_diagonals(patch.mesh, same_face(patch, faces));
  if (!patch.mesh.triangles.empty() && !is_good(patch.mesh)) notes = close(patch);
  if (!faces.empty() && is_good(patch.mesh))
    turned += detail::uncross_diagonals(patch.mesh, same_face(patch, faces));
  drop_unused(patch.mesh.points, patch.mesh.triangles, patch.point_of);
  if (merged > 0 && part_sheets(given, patch, notes)) merged = flat = turned = 0;
  note(file.notes, merged, "point merged with another in the same place",
       "points merged with others in the same place");
  note(file.notes, flat, "triangle without area left out", "triangles without area left out");
  file.notes.insert(file.notes.end(), notes.begin(), notes.end());
  note(file.notes, turned, "face cut along its other diagonal, the first being in the way",
       "faces cut along their other diagonals, the first being in the way");
  note(file.notes, unused, "point that no triangle has left out",
       "points that no triangle has left out");
  file.mesh = std::move(patch.mesh);
  keep_places(file.lines, patch.point_of, patch.cell_of);
  return file;
}

TetrahedralFile mend(TetrahedralFile file) {
  auto& [points, tetrahedra] = file.mesh;
  if (!is_usable(points, tetrahedra)) return file;
  std::size_t merged = 0;
  const std::size_t unused = count_unused(points.size(), tetrahedra);
  std::vector<Tetrahedron> renumbered = tetrahedra;
  renumber(renumbered, first_equal(points, merged));
  if (std::any_of(renumbered.begin(), renumbered.end(), has_repeated_corner<4>)) {
    merged = 0;
  } else {
    tetrahedra = std::move(renumbered);
  }
  std::vector<std::uint32_t> point_of = numbers_up_to(points.size());
  drop_unused(points, tetrahedra, point_of);
  note(file.notes, merged, "point merged with another in the same place",
       "points merged with others in the same place");
  note(file.notes, unused, "point that no tetrahedron has left out",
       "points that no tetrahedron has left out");
  keep_places(file.lines, point_of, numbers_up_to(tetrahedra.size()));
  return file;
}

}  // namespace tripus::meshing
