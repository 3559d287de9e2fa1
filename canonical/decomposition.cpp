#include "canonical/decomposition.hpp"

#include <algorithm>
#include <initializer_list>
#include <map>
#include <unordered_set>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.hpp"
#include "topology/triangulation.hpp"

namespace tripus::canonical {
namespace {

using topology::Gluings;
using topology::Perm4;
using topology::Triangulation;

/// Swaps of neighbouring places: p * kSwap[i] exchanges p(i) and p(i + 1).
constexpr std::array<Perm4, 3> kSwap{Perm4::from_images(1, 0, 2, 3), Perm4::from_images(0, 2, 1, 3),
                                     Perm4::from_images(0, 1, 3, 2)};

/// A flag of the triangulation: vertex p(0), edge p(0)p(1), face opposite p(3).
struct Place {
  std::size_t t;
  Perm4 p;
  std::size_t index() const { return 24 * t + static_cast<std::size_t>(p.rank()); }
};

/// True faces around an edge class: 0 inside a cell, 2 inside a polygon, more elsewhere. Two convex
/// cells around an edge have angles pi, both; one cell cannot have angle 2 pi there.
std::size_t count_true_faces(const Triangulation& triangulation, const FaceKinds& faces,
                             std::size_t edge) {
  std::size_t sides = 0;  // each face around the edge is met from both
  for (const auto& corner : triangulation.corners(edge)) {
    const auto ends = topology::kEdgeEnds[static_cast<std::size_t>(corner.edge())];
    for (int f = 0; f < 4; ++f) {
      sides += f != ends[0] && f != ends[1] &&
               faces.kind[corner.tetrahedron()][static_cast<std::size_t>(f)] == FaceKind::kTrue;
    }
  }
  return sides / 2;
}

}  // namespace

std::optional<std::size_t> edge_inside_cell(const Triangulation& triangulation,
                                            const FaceKinds& faces,
                                            std::span<const topology::ConeAngle> cone_angles) {
  for (std::size_t e = 0; e < cone_angles.size(); ++e)
    if (!cone_angles[e].is_full() && count_true_faces(triangulation, faces, e) == 0) return e;
  return std::nullopt;
}

/// Walks on the flags of the triangulation.
class FlagBuilder {
 public:
  FlagBuilder(const Gluings& gluings, const FaceKinds& faces,
              std::span<const topology::ConeAngle> cone_angles)
      : triangulation_(gluings), faces_(faces), cone_angles_(cone_angles) {
    if (const auto edge = edge_inside_cell(triangulation_, faces, cone_angles))
      throw InvalidInput(fmt::format("edge class {}, with a cone angle, is inside a cell", *edge));
    find_inner_edges();
  }

  void build(Decomposition& result) {
    number_flags();
    result.component_.resize(places_.size());
    for (auto& step : result.step_) step.resize(places_.size());
    for (FlagIndex flag = 0; flag < places_.size(); ++flag) {
      const Place here = places_[flag];
      result.component_[flag] = triangulation_.vertex_class(here.t, here.p(0));
      result.step_[0][flag] = number(swapped(here, 0));
      result.step_[1][flag] = number(next_edge(here));
      result.step_[2][flag] = number(next_face(here));
      result.step_[3][flag] = number(across(here));
    }
    if (!topology::all_full(cone_angles_)) label(result);
    orient(result);
    number_orbits(result, {0, 1, 2}, result.cell_);
    number_orbits(result, {1, 2}, result.vertex_);
    for (FlagIndex flag = 0; flag < places_.size(); ++flag)
      if (result.cell_[flag] == result.cell_start_.size()) result.cell_start_.push_back(flag);
    number_vertices_in_cells(result);
  }

 private:
  static Place swapped(Place place, std::size_t i) { return {place.t, place.p * kSwap[i]}; }
  bool is_true(Place place) const {
    return faces_.kind[place.t][static_cast<std::size_t>(place.p(3))] == FaceKind::kTrue;
  }
  std::size_t edge_class(Place place) const {
    return triangulation_.edge_class(place.t,
                                     topology::kEdgeNumber[static_cast<std::size_t>(place.p(0))]
                                                          [static_cast<std::size_t>(place.p(1))]);
  }
  Place across(Place place) const {
    const Gluings& gluings = triangulation_.gluings();
    return {gluings.neighbour(place.t, place.p(3)), gluings.gluing(place.t, place.p(3)) * place.p};
  }
  /// Around the edge, inside the cell, to its other face there.
  Place next_face(Place place) const {
    place = swapped(place, 2);
    while (!is_true(place)) place = swapped(across(place), 2);
    return place;
  }
  /// Around the vertex, inside the polygon, to its other edge there.
  Place next_edge(Place place) const {
    place = swapped(place, 1);
    while (inner_[edge_class(place)]) place = swapped(next_face(place), 1);
    return place;
  }

  /// Those inside cells and polygons.
  void find_inner_edges() {
    inner_.resize(triangulation_.edge_count());
    for (std::size_t e = 0; e < inner_.size(); ++e) {
      if (!cone_angles_.empty() && !cone_angles_[e].is_full()) continue;
      const std::size_t count = count_true_faces(triangulation_, faces_, e);
      inner_[e] = count <= 2;
      if (count == 1) {
        throw InternalError(
            fmt::format("edge class {} has one true face around it: a tilt has the wrong sign", e));
      }
    }
  }

  void label(Decomposition& result) const {
    const auto descending = [](const topology::ConeAngle& a, const topology::ConeAngle& b) {
      return a.radians() > b.radians();
    };
    auto& angles = result.cone_angles_;
    for (const Place& place : places_) angles.push_back(cone_angles_[edge_class(place)]);
    std::ranges::sort(angles, descending);
    angles.erase(std::unique(angles.begin(), angles.end()), angles.end());
    for (const Place& place : places_) {
      const auto found = std::ranges::find(angles, cone_angles_[edge_class(place)]);
      result.label_.push_back(static_cast<std::uint32_t>(found - angles.begin()));
    }
  }

  void number_flags() {
    number_.assign(24 * triangulation_.tetrahedron_count(), kNoFlag);
    for (std::size_t t = 0; t < triangulation_.tetrahedron_count(); ++t) {
      for (int rank = 0; rank < 24; ++rank) {
        const Place place{t, Perm4::from_rank(rank)};
        if (!is_true(place) || inner_[edge_class(place)]) continue;
        number_[place.index()] = static_cast<FlagIndex>(places_.size());
        places_.push_back(place);
      }
    }
  }
  FlagIndex number(Place place) const { return number_[place.index()]; }

  void orient(Decomposition& result) const {
    // +1 or -1: the sign of each tetrahedron's labels 0123, from tetrahedron 0.
    std::vector<int> sign(triangulation_.tetrahedron_count());
    const Gluings& gluings = triangulation_.gluings();
    std::vector<std::size_t> todo{0};
    sign[0] = 1;
    while (!todo.empty()) {
      const std::size_t t = todo.back();
      todo.pop_back();
      for (int f = 0; f < 4; ++f) {
        const std::size_t other = gluings.neighbour(t, f);
        const int expected = gluings.gluing(t, f).is_odd() ? sign[t] : -sign[t];
        if (sign[other] == 0) todo.push_back(other), sign[other] = expected;
        if (sign[other] != expected) result.orientable_ = false;
      }
    }
    for (const Place& place : places_)
      result.negative_.push_back((sign[place.t] < 0) != place.p.is_odd());
  }

  static void number_orbits(const Decomposition& result, std::initializer_list<int> steps,
                            std::vector<std::uint32_t>& orbit) {
    orbit.assign(result.component_.size(), kNoFlag);
    std::uint32_t count = 0;
    std::vector<FlagIndex> todo;
    for (FlagIndex start = 0; start < orbit.size(); ++start) {
      if (orbit[start] != kNoFlag) continue;
      orbit[start] = count;
      todo.push_back(start);
      while (!todo.empty()) {
        const FlagIndex flag = todo.back();
        todo.pop_back();
        for (const int i : steps) {
          const FlagIndex next = result.step(i, flag);
          if (orbit[next] != kNoFlag) continue;
          orbit[next] = count;
          todo.push_back(next);
        }
      }
      ++count;
    }
  }

  /// From numbers of vertices all over to numbers in each cell, by first appearance.
  static void number_vertices_in_cells(Decomposition& result) {
    std::vector<std::uint32_t> in_cell(result.vertex_.size(), kNoFlag);
    std::vector<std::uint32_t> count(result.cell_start_.size());
    for (FlagIndex flag = 0; flag < result.vertex_.size(); ++flag) {
      std::uint32_t& local = in_cell[result.vertex_[flag]];
      if (local == kNoFlag) local = count[result.cell_[flag]]++;
      result.vertex_[flag] = local;
    }
  }

  Triangulation triangulation_;
  const FaceKinds& faces_;
  std::span<const topology::ConeAngle> cone_angles_;
  std::vector<char> inner_;        // [E] not an edge of the decomposition
  std::vector<Place> places_;      // of each flag
  std::vector<FlagIndex> number_;  // [24 T]
};

Decomposition::Decomposition(const Gluings& gluings, const FaceKinds& faces,
                             std::span<const topology::ConeAngle> cone_angles) {
  FlagBuilder(gluings, faces, cone_angles).build(*this);
}

namespace {

/// Number of flags in the orbit of a flag under two steps, taken in turn.
std::size_t orbit_size(const Decomposition& decomposition, FlagIndex start, int a, int b) {
  std::size_t size = 0;
  FlagIndex flag = start;
  do {
    flag = decomposition.step(b, decomposition.step(a, flag));
    size += 2;
  } while (flag != start);
  return size;
}

struct NamedType {
  const char* name;
  std::size_t vertex_count;
  std::vector<std::size_t> face_sizes;
  std::vector<std::size_t> valences;  ///< of the vertices, ascending
};

const std::vector<NamedType>& named_types() {
  static const std::vector<NamedType> kTypes{
      {"tetrahedron", 4, {3, 3, 3, 3}, {3, 3, 3, 3}},
      {"pyramid", 5, {3, 3, 3, 3, 4}, {3, 3, 3, 3, 4}},
      {"triangular bipyramid", 5, {3, 3, 3, 3, 3, 3}, {3, 3, 4, 4, 4}},
      {"octahedron", 6, {3, 3, 3, 3, 3, 3, 3, 3}, {4, 4, 4, 4, 4, 4}},
      {"prism", 6, {3, 3, 4, 4, 4}, {3, 3, 3, 3, 3, 3}},
      {"cube", 8, {4, 4, 4, 4, 4, 4}, {3, 3, 3, 3, 3, 3, 3, 3}},
  };
  return kTypes;
}

/// The steps 0, 1 and 2 stay in the cell and reach all of it.
std::vector<FlagIndex> flags_of_cell(const Decomposition& decomposition, std::size_t cell) {
  std::vector<FlagIndex> flags{decomposition.first_flag(cell)};
  std::unordered_set<FlagIndex> known{flags[0]};
  for (std::size_t k = 0; k < flags.size(); ++k)
    for (int i = 0; i < 3; ++i)
      if (const FlagIndex next = decomposition.step(i, flags[k]); known.insert(next).second)
        flags.push_back(next);
  return flags;
}

std::string plural(const std::string& name) {
  if (name == "tetrahedron" || name == "octahedron") return name.substr(0, name.size() - 2) + "a";
  return name + "s";
}

}  // namespace

CellType cell_type(const Decomposition& decomposition, std::size_t cell) {
  CellType type;
  // Every orbit is met once for each of its flags.
  std::map<std::size_t, std::size_t> flags_in_faces, flags_at_vertices;
  for (const FlagIndex flag : flags_of_cell(decomposition, cell)) {
    ++flags_in_faces[orbit_size(decomposition, flag, 0, 1)];
    ++flags_at_vertices[orbit_size(decomposition, flag, 1, 2)];
  }
  std::vector<std::size_t> valences;
  for (const auto& [size, flags] : flags_in_faces)
    type.face_sizes.insert(type.face_sizes.end(), flags / size, size / 2);
  for (const auto& [size, flags] : flags_at_vertices)
    valences.insert(valences.end(), flags / size, size / 2);
  type.vertex_count = valences.size();
  for (const NamedType& named : named_types()) {
    if (named.vertex_count == type.vertex_count && named.face_sizes == type.face_sizes &&
        named.valences == valences)
      type.name = named.name;
  }
  if (type.name.empty()) type.name = fmt::format("polyhedron {}", fmt::join(type.face_sizes, "."));
  return type;
}

bool is_cell_type_name(std::string_view text) {
  for (const NamedType& named : named_types())
    if (named.name == text) return true;
  constexpr std::string_view kPolyhedron = "polyhedron ";
  if (!text.starts_with(kPolyhedron)) return false;
  text.remove_prefix(kPolyhedron.size());
  return text.find_first_not_of("0123456789.") == std::string_view::npos && !text.empty();
}

std::string known_cell_names() {
  std::string names;
  for (const NamedType& named : named_types()) names += std::string(named.name) + ", ";
  return names + "polyhedron 5.5.4.3.3 (the sizes of its faces)";
}

std::string describe_cells(const Decomposition& decomposition) {
  // Tetrahedra first, then by number of vertices.
  std::map<std::pair<std::size_t, std::string>, std::size_t> counts;
  for (std::size_t cell = 0; cell < decomposition.cell_count(); ++cell) {
    const CellType type = cell_type(decomposition, cell);
    ++counts[{type.vertex_count, type.name}];
  }
  std::vector<std::string> parts;
  parts.reserve(counts.size());
  for (const auto& [key, count] : counts)
    parts.push_back(fmt::format("{} {}", count, count == 1 ? key.second : plural(key.second)));
  return fmt::format("{}", fmt::join(parts, " + "));
}

}  // namespace tripus::canonical
