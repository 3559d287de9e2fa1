// Everything here goes through the flags in canonical order and breaks every tie by it, so that
// isomorphic decompositions give isomorphic triangulations.
#include "canonical/subdivision.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>

#include "base/error.hpp"
#include "topology/labelled_isosig.hpp"

namespace tripus::canonical {
namespace {

using topology::Gluings;
using topology::Perm4;

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// A face of a cell: the corners in the sense of its flags of the first orientation. Corners are
/// vertices with numbers of their own in every cell.
struct Side {
  std::uint32_t cell = 0;
  std::uint32_t mate = kNone;              ///< the side that it is glued to
  std::vector<std::uint32_t> corners;      ///< vertices
  std::vector<std::uint32_t> mate_corner;  ///< the vertex of the mate's cell at each corner
  std::uint32_t fan = kNone;               ///< place of the corner that the diagonals start from
};

struct Tetrahedron {
  std::array<std::uint32_t, 4> vertices;
};

class Subdivider {
 public:
  Subdivider(const Decomposition& decomposition, const CanonicalOrder& order)
      : decomposition_(decomposition), order_(order) {
    number_vertices();
    collect_sides();
  }

  Gluings run() {
    std::vector<std::uint32_t> cells;  // in canonical order
    std::vector<char> seen(decomposition_.cell_count());
    for (const FlagIndex flag : order_.flags) {
      const std::uint32_t cell = decomposition_.cell(flag);
      if (!seen[cell]) cells.push_back(cell);
      seen[cell] = 1;
    }
    // Cells first that leave their faces free, then those that must bend to what is there.
    std::vector<std::uint32_t> apex(decomposition_.cell_count(), kNone);
    for (const std::uint32_t cell : cells) apex[cell] = choose_apex(cell, false);
    for (const std::uint32_t cell : cells) {
      if (apex[cell] == kNone) apex[cell] = choose_apex(cell, true);
      if (apex[cell] != kNone) fix_fans(cell, apex[cell]);
    }
    for (Side& side : sides_)
      if (side.fan == kNone) set_fan(side, 0);
    for (const std::uint32_t cell : cells) {
      if (apex[cell] == kNone) apex[cell] = vertex_count_++;
      cone(cell, apex[cell]);
    }
    return glue();
  }

  /// Of what `run` made: edges of cells keep their cone angles, all others have 2 pi.
  std::vector<topology::ConeAngle> cone_angles(const topology::Triangulation& made) const {
    if (decomposition_.cone_angles().empty()) return {};
    std::map<Pair, topology::ConeAngle> of_edge;
    for (const FlagIndex flag : order_.flags)
      of_edge[sorted_pair(vertex_[flag], vertex_[decomposition_.step(0, flag)])] =
          decomposition_.cone_angles()[decomposition_.label(flag)];
    std::vector<topology::ConeAngle> result(made.edge_count());
    for (std::size_t t = 0; t < tetrahedra_.size(); ++t) {
      for (int e = 0; e < 6; ++e) {
        const auto ends = topology::kEdgeEnds[static_cast<std::size_t>(e)];
        const auto& at = tetrahedra_[t].vertices;
        const auto found = of_edge.find(sorted_pair(at[static_cast<std::size_t>(ends[0])],
                                                    at[static_cast<std::size_t>(ends[1])]));
        if (found != of_edge.end()) result[made.edge_class(t, e)] = found->second;
      }
    }
    return result;
  }

 private:
  /// Vertices of cells in canonical order; place by flag.
  void number_vertices() {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> numbers;
    vertex_.resize(order_.flags.size());
    for (const FlagIndex flag : order_.flags) {
      const auto [found, is_new] = numbers.try_emplace(
          std::pair(decomposition_.cell(flag), decomposition_.vertex(flag)), vertex_count_);
      if (is_new) cell_vertices_.emplace_back(found->first.first, vertex_count_++);
      vertex_[flag] = found->second;
    }
  }

  void collect_sides() {
    std::vector<std::uint32_t> side_of(order_.flags.size(), kNone);
    const bool sign = decomposition_.is_negative(order_.flags[0]);
    for (const FlagIndex start : order_.flags) {
      if (side_of[start] != kNone) continue;
      if (decomposition_.is_orientable() && decomposition_.is_negative(start) != sign) continue;
      Side side;
      side.cell = decomposition_.cell(start);
      FlagIndex flag = start;
      do {
        const FlagIndex turned = decomposition_.step(0, flag);
        side_of[flag] = side_of[turned] = static_cast<std::uint32_t>(sides_.size());
        side.corners.push_back(vertex_[flag]);
        side.mate_corner.push_back(vertex_[decomposition_.step(3, flag)]);
        flag = decomposition_.step(1, turned);
      } while (flag != start);
      sides_.push_back(std::move(side));
    }
    for (const FlagIndex flag : order_.flags)
      sides_[side_of[flag]].mate = side_of[decomposition_.step(3, flag)];
    sides_of_cell_.resize(decomposition_.cell_count());
    for (std::uint32_t s = 0; s < sides_.size(); ++s) sides_of_cell_[sides_[s].cell].push_back(s);
  }

  static std::uint32_t place_of(const std::vector<std::uint32_t>& corners, std::uint32_t vertex) {
    const auto found = std::ranges::find(corners, vertex);
    return found == corners.end() ? kNone : static_cast<std::uint32_t>(found - corners.begin());
  }

  /// Whether the diagonals from a corner can be, or are already, those of the side.
  static bool is_fan(const Side& side, std::uint32_t place) {
    const auto size = static_cast<std::uint32_t>(side.corners.size());
    if (size == 3 || side.fan == kNone || side.fan == place) return true;
    return size == 4 && (side.fan + 2) % 4 == place;
  }

  void set_fan(Side& side, std::uint32_t place) {
    side.fan = place;
    Side& mate = sides_[side.mate];
    mate.fan = place_of(mate.corners, side.mate_corner[place]);
  }

  /// The first vertex of the cell from which it can be coned; without `bend` only if that does not
  /// touch any face that has diagonals.
  std::uint32_t choose_apex(std::uint32_t cell, bool bend) const {
    for (const auto& of_cell : cell_vertices_) {
      if (of_cell.first != cell) continue;
      const std::uint32_t vertex = of_cell.second;
      const bool fits = std::ranges::all_of(sides_of_cell_[cell], [&](std::uint32_t s) {
        const std::uint32_t place = place_of(sides_[s].corners, vertex);
        if (place == kNone || sides_[s].corners.size() == 3) return true;
        return bend && is_fan(sides_[s], place) && !meets_own_mate(sides_[s], cell, vertex);
      });
      if (fits) return vertex;
    }
    return kNone;
  }

  /// Whether the mate is of the same cell and the diagonals from the vertex would not do there.
  bool meets_own_mate(const Side& side, std::uint32_t cell, std::uint32_t vertex) const {
    const Side& mate = sides_[side.mate];
    if (mate.cell != cell) return false;
    const std::uint32_t place = place_of(mate.corners, vertex);
    if (place == kNone) return false;
    const std::uint32_t image =
        place_of(mate.corners, side.mate_corner[place_of(side.corners, vertex)]);
    return image != place && !(mate.corners.size() == 4 && (image + 2) % 4 == place);
  }

  void fix_fans(std::uint32_t cell, std::uint32_t apex) {
    for (const std::uint32_t s : sides_of_cell_[cell]) {
      const std::uint32_t place = place_of(sides_[s].corners, apex);
      if (place != kNone && sides_[s].fan == kNone) set_fan(sides_[s], place);
    }
  }

  /// The corners of triangle k of a side: from the corner of the fan.
  static std::array<std::uint32_t, 3> triangle(const std::vector<std::uint32_t>& corners,
                                               std::uint32_t fan, std::uint32_t k) {
    const auto size = static_cast<std::uint32_t>(corners.size());
    return {corners[fan], corners[(fan + k + 1) % size], corners[(fan + k + 2) % size]};
  }

  void cone(std::uint32_t cell, std::uint32_t apex) {
    for (const std::uint32_t s : sides_of_cell_[cell]) {
      const Side& side = sides_[s];
      if (place_of(side.corners, apex) != kNone) continue;
      for (std::uint32_t k = 0; k + 2 < side.corners.size(); ++k) {
        const auto [a, b, c] = triangle(side.corners, side.fan, k);
        tetrahedra_.push_back({{a, b, c, apex}});
      }
    }
  }

  using Pair = std::pair<std::uint32_t, std::uint32_t>;
  static Pair sorted_pair(std::uint32_t a, std::uint32_t b) { return std::minmax(a, b); }

  using Triangle = std::array<std::uint32_t, 3>;
  struct FacePlace {
    std::uint32_t tetrahedron;
    int face;
  };

  static Triangle sorted(Triangle triangle) {
    std::ranges::sort(triangle);
    return triangle;
  }

  Triangle face_triangle(std::uint32_t t, int face) const {
    Triangle result{};
    std::size_t k = 0;
    for (int v = 0; v < 4; ++v)
      if (v != face) result[k++] = tetrahedra_[t].vertices[static_cast<std::size_t>(v)];
    return sorted(result);
  }

  /// Glues a face to another, vertex `from[k]` to vertex `to[k]`.
  void glue_faces(Gluings& gluings, FacePlace here, const Triangle& from, FacePlace there,
                  const Triangle& to) const {
    std::array<int, 4> image{};
    image[static_cast<std::size_t>(here.face)] = there.face;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& a = tetrahedra_[here.tetrahedron].vertices;
      const auto& b = tetrahedra_[there.tetrahedron].vertices;
      image[static_cast<std::size_t>(std::ranges::find(a, from[k]) - a.begin())] =
          static_cast<int>(std::ranges::find(b, to[k]) - b.begin());
    }
    gluings.glue(here.tetrahedron, here.face, there.tetrahedron,
                 Perm4::from_images(image[0], image[1], image[2], image[3]));
  }

  /// Inside cells faces meet where their vertices are the same; at sides as the sides are glued.
  Gluings glue() const {
    Gluings gluings(tetrahedra_.size());
    std::map<Triangle, FacePlace> open;
    for (std::uint32_t t = 0; t < tetrahedra_.size(); ++t) {
      for (int face = 0; face < 4; ++face) {
        const Triangle key = face_triangle(t, face);
        const auto [found, is_new] = open.try_emplace(key, FacePlace{t, face});
        if (is_new) continue;
        glue_faces(gluings, {t, face}, key, found->second, key);
        open.erase(found);
      }
    }
    for (const Side& side : sides_) {
      for (std::uint32_t k = 0; k + 2 < side.corners.size(); ++k) {
        const Triangle from = triangle(side.corners, side.fan, k);
        const Triangle to = triangle(side.mate_corner, side.fan, k);
        const auto here = open.find(sorted(from)), there = open.find(sorted(to));
        if (here == open.end() || there == open.end())
          throw InternalError("the cells were not cut alike on both sides of a face");
        glue_faces(gluings, here->second, from, there->second, to);
      }
    }
    return gluings;
  }

  const Decomposition& decomposition_;
  const CanonicalOrder& order_;
  std::vector<std::uint32_t> vertex_;  // of each flag
  std::uint32_t vertex_count_ = 0;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> cell_vertices_;  // cell, vertex
  std::vector<Side> sides_;
  std::vector<std::vector<std::uint32_t>> sides_of_cell_;
  std::vector<Tetrahedron> tetrahedra_;
};

}  // namespace

Gluings subdivision(const Decomposition& decomposition, const CanonicalOrder& order) {
  return Subdivider(decomposition, order).run();
}

LabelledSubdivision labelled_subdivision(const Decomposition& decomposition,
                                         const CanonicalOrder& order) {
  Subdivider subdivider(decomposition, order);
  topology::Triangulation triangulation(subdivider.run());
  auto cone_angles = subdivider.cone_angles(triangulation);
  return {std::move(triangulation), std::move(cone_angles)};
}

IsometrySignature isometry_signature(const Decomposition& decomposition,
                                     const CanonicalOrder& order, bool is_amphicheiral) {
  const LabelledSubdivision made = labelled_subdivision(decomposition, order);
  const auto canonical = topology::labelled_signature(made.triangulation, made.cone_angles);
  IsometrySignature result{canonical.text, canonical.text};
  if (!decomposition.is_orientable() || is_amphicheiral) return result;
  const auto& images = canonical.isomorphism.tetrahedron_images;
  const auto first = static_cast<std::size_t>(std::ranges::find(images, 0u) - images.begin());
  const bool reversed = canonical.isomorphism.perms[first].is_odd();
  const bool mirrored = reversed != decomposition.is_negative(order.flags[0]);
  result.oriented = topology::with_sign(canonical, mirrored ? '-' : '+');
  return result;
}

}  // namespace tripus::canonical
