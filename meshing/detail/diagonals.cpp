#include "meshing/detail/diagonals.hpp"

#include <algorithm>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "meshing/detail/connectivity.hpp"
#include "meshing/detail/quad_diagonals.hpp"
#include "meshing/predicates.hpp"
#include "meshing/self_intersection.hpp"

namespace tripus::meshing::detail {
namespace {

/// The diagonal between two triangles (x, y, u) and (y, x, v) of one face.
struct Diagonal {
  std::size_t first, second;
  std::uint32_t x, y, u, v;
};

class Diagonals {
 public:
  Diagonals(SurfaceMesh& mesh, const SameFace& same_face) : mesh_(mesh), same_face_(same_face) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) enter(t);
  }

  /// The diagonal at side k of a triangle, if there is one.
  std::optional<Diagonal> at(std::size_t t, std::size_t k) const {
    const std::uint32_t x = corner(t, k), y = corner(t, k + 1);
    for (const std::size_t other : edges_.at(pair_key(x, y))) {
      if (other == t || !same_face_(t, other)) continue;
      for (std::size_t j = 0; j < 3; ++j)
        if (corner(other, j) == y && corner(other, j + 1) == x)
          return Diagonal{t, other, x, y, corner(t, k + 2), corner(other, j + 2)};
    }
    return std::nullopt;
  }

  bool is_crowded(const Diagonal& d) const { return edges_.at(pair_key(d.x, d.y)).size() > 2; }

  /// Whether the other diagonal is no edge yet, and makes no flat triangle.
  bool can_turn(const Diagonal& d) const {
    if (d.u == d.v) return false;
    const auto there = edges_.find(pair_key(d.u, d.v));
    if (there != edges_.end() && !there->second.empty()) return false;
    const auto& p = mesh_.points;
    return projection_axis(p[d.u], p[d.x], p[d.v]) >= 0 &&
           projection_axis(p[d.v], p[d.y], p[d.u]) >= 0;
  }

  /// Returns what turns it back.
  Diagonal turn(const Diagonal& d) {
    leave(d.first);
    leave(d.second);
    mesh_.triangles[d.first] = {d.u, d.x, d.v};
    mesh_.triangles[d.second] = {d.v, d.y, d.u};
    enter(d.first);
    enter(d.second);
    // (v, u, x) and (u, v, y)
    return {d.first, d.second, d.v, d.u, d.x, d.y};
  }

 private:
  std::uint32_t corner(std::size_t t, std::size_t k) const { return mesh_.triangles[t][k % 3]; }
  void enter(std::size_t t) {
    for (std::size_t k = 0; k < 3; ++k)
      edges_[pair_key(corner(t, k), corner(t, k + 1))].push_back(t);
  }
  void leave(std::size_t t) {
    for (std::size_t k = 0; k < 3; ++k)
      std::erase(edges_[pair_key(corner(t, k), corner(t, k + 1))], t);
  }

  SurfaceMesh& mesh_;
  const SameFace& same_face_;
  std::unordered_map<PairKey, std::vector<std::size_t>> edges_;
};

class Uncrossing {
 public:
  Uncrossing(SurfaceMesh& mesh, const SameFace& same_face)
      : mesh_(mesh), diagonals_(mesh, same_face) {}

  /// Nothing if crossings are left.
  std::optional<std::size_t> run() {
    std::size_t turned = 0;
    while (const auto pair = first_self_intersection(mesh_)) {
      std::vector<Diagonal> candidates;
      for (const std::uint32_t t : *pair)
        for (std::size_t k = 0; k < 3; ++k)
          if (const auto d = diagonals_.at(t, k); d && diagonals_.can_turn(*d))
            candidates.push_back(*d);
      const std::size_t count = improve(candidates);
      if (count == 0) return std::nullopt;
      turned += count;
    }
    return turned;
  }

 private:
  /// Turns the one of the diagonals that takes most crossings away, or two together where none does
  /// it alone. Returns how many were turned.
  std::size_t improve(const std::vector<Diagonal>& candidates) {
    std::ptrdiff_t best = 0;
    std::size_t first = 0, second = 0;
    const auto consider = [&](std::size_t i, std::size_t j) {
      const std::ptrdiff_t gain = gain_of(candidates[i], i == j ? nullptr : &candidates[j]);
      if (gain <= best) return;
      best = gain;
      first = i;
      second = j;
    };
    for (std::size_t i = 0; i < candidates.size(); ++i) consider(i, i);
    for (std::size_t i = 0; best == 0 && i < candidates.size(); ++i)
      for (std::size_t j = i + 1; j < candidates.size(); ++j)
        if (are_apart(candidates[i], candidates[j])) consider(i, j);
    if (best == 0) return turn_unseen(candidates);
    diagonals_.turn(candidates[first]);
    if (second == first) return 1;
    diagonals_.turn(candidates[second]);
    return 2;
  }

  /// Where nothing helps at once, one that does no harm, each once only.
  std::size_t turn_unseen(const std::vector<Diagonal>& candidates) {
    for (const Diagonal& d : candidates) {
      const PairKey face =
          pair_key(static_cast<std::uint32_t>(d.first), static_cast<std::uint32_t>(d.second));
      if (gain_of(d, nullptr) < 0 || !unhelpful_.insert(face).second) continue;
      diagonals_.turn(d);
      return 1;
    }
    return 0;
  }

  static bool are_apart(const Diagonal& a, const Diagonal& b) {
    return a.first != b.first && a.first != b.second && a.second != b.first && a.second != b.second;
  }

  /// How many crossings fewer there are with the diagonals turned.
  std::ptrdiff_t gain_of(const Diagonal& one, const Diagonal* other) {
    std::vector<std::size_t> moved{one.first, one.second};
    if (other != nullptr) moved.insert(moved.end(), {other->first, other->second});
    const std::ptrdiff_t before = crossings_of(moved);
    const Diagonal back = diagonals_.turn(one);
    std::ptrdiff_t after = before;
    if (other == nullptr) {
      after = crossings_of(moved);
    } else if (diagonals_.can_turn(*other)) {
      const Diagonal other_back = diagonals_.turn(*other);
      after = crossings_of(moved);
      diagonals_.turn(other_back);
    }
    diagonals_.turn(back);
    return before - after;
  }

  std::ptrdiff_t crossings_of(const std::vector<std::size_t>& moved) const {
    std::ptrdiff_t count = 0;
    for (std::size_t m = 0; m < moved.size(); ++m)
      for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
        // Each pair of moved ones once.
        const auto place = std::find(moved.begin(), moved.end(), t) - moved.begin();
        if (place <= static_cast<std::ptrdiff_t>(m)) continue;
        count += may_meet(moved[m], t) && triangles_cross(mesh_, moved[m], t);
      }
    return count;
  }

  bool may_meet(std::size_t s, std::size_t t) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low_s, high_s] = range(s, k);
      const auto [low_t, high_t] = range(t, k);
      if (high_s < low_t || high_t < low_s) return false;
    }
    return true;
  }
  std::pair<double, double> range(std::size_t t, std::size_t k) const {
    const auto& [a, b, c] = mesh_.triangles[t];
    return std::minmax({mesh_.points[a][k], mesh_.points[b][k], mesh_.points[c][k]});
  }

  SurfaceMesh& mesh_;
  Diagonals diagonals_;
  std::unordered_set<PairKey> unhelpful_;
};

}  // namespace

std::size_t uncrowd_diagonals(SurfaceMesh& mesh, const SameFace& same_face) {
  Diagonals diagonals(mesh, same_face);
  std::size_t turned = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      if (const auto d = diagonals.at(t, k);
          d && diagonals.is_crowded(*d) && diagonals.can_turn(*d)) {
        diagonals.turn(*d);
        ++turned;
        break;
      }
  return turned;
}

std::size_t uncross_diagonals(SurfaceMesh& mesh, const SameFace& same_face) {
  SurfaceMesh trial = mesh;
  const auto turned = Uncrossing(trial, same_face).run();
  if (!turned) return choose_diagonals(mesh, same_face);
  if (*turned > 0) mesh = std::move(trial);
  return *turned;
}

}  // namespace tripus::meshing::detail
