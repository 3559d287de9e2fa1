#include <algorithm>
#include <array>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "meshing/detail/connectivity.hpp"
#include "meshing/detail/mending.hpp"
#include "meshing/detail/triangle_tree.hpp"
#include "meshing/detail/two_choices.hpp"
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

namespace {

using Answer = TwoChoices::Answer;
/// A face of two triangles, as they are (0) and with the other diagonal (1).
struct Quad {
  std::array<std::size_t, 2> places;
  std::array<std::array<Triangle, 2>, 2> triangles;
  std::array<PairKey, 2> diagonals;
};

std::vector<Quad> quads_of(const SurfaceMesh& mesh, const SameFace& same_face) {
  std::unordered_map<PairKey, std::vector<std::uint32_t>> at_edge;
  const auto corner = [&](std::size_t t, std::size_t k) { return mesh.triangles[t][k % 3]; };
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  for (std::uint32_t t = 0; t < count; ++t)
    for (std::size_t k = 0; k < 3; ++k)
      at_edge[pair_key(corner(t, k), corner(t, k + 1))].push_back(t);
  // The sides of each triangle that are diagonals: one in each half of a quadrilateral.
  std::vector<std::uint8_t> sides(count, 0);
  std::vector<Quad> quads;
  for (std::uint32_t t = 0; t < count; ++t)
    for (std::size_t k = 0; k < 3; ++k)
      for (const std::uint32_t other : at_edge.at(pair_key(corner(t, k), corner(t, k + 1))))
        if (other != t && same_face(t, other)) ++sides[t];
  for (std::uint32_t t = 0; t < count; ++t) {
    if (sides[t] != 1) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t x = corner(t, k), y = corner(t, k + 1), u = corner(t, k + 2);
      for (const std::uint32_t other : at_edge.at(pair_key(x, y))) {
        if (other <= t || sides[other] != 1 || !same_face(t, other)) continue;
        for (std::size_t j = 0; j < 3; ++j) {
          const std::uint32_t v = corner(other, j + 2);
          if (corner(other, j) != y || corner(other, j + 1) != x || u == v) continue;
          Quad quad;
          quad.places = {t, other};
          quad.triangles[0] = {mesh.triangles[t], mesh.triangles[other]};
          quad.triangles[1] = {Triangle{u, x, v}, Triangle{v, y, u}};
          quad.diagonals = {pair_key(x, y), pair_key(u, v)};
          quads.push_back(quad);
        }
      }
    }
  }
  return quads;
}

/// All triangles that there may be, and whose answers they are.
class TriangleChoices {
 public:
  TriangleChoices(const SurfaceMesh& mesh, const std::vector<Quad>& quads)
      : choices_(quads.size()) {
    all_.points = mesh.points;
    std::vector<std::uint8_t> is_half(mesh.triangles.size(), 0);
    for (std::uint32_t q = 0; q < quads.size(); ++q)
      for (std::uint32_t a = 0; a < 2; ++a) {
        is_half[quads[q].places[a]] = 1;
        for (const Triangle& t : quads[q].triangles[a]) add(t, 2 * q + a);
      }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      if (is_half[t] == 0) add(mesh.triangles[t], kAlways);
  }

  /// Nothing if triangles that stay collide, or if there are no answers.
  std::optional<std::vector<std::uint8_t>> answers(const std::vector<Quad>& quads) {
    exclude_crowded(quads);
    const TriangleTree tree(all_);
    for (std::uint32_t s = 0; s < all_.triangles.size() && !is_hopeless_; ++s) {
      const Box box = box_of(all_, s);
      tree.for_each([&](const Box& other) { return box.meets(other); },
                    [&](std::uint32_t t) {
                      if (t > s && collide(s, t)) exclude(answer_[s], answer_[t]);
                      return !is_hopeless_;
                    });
    }
    return is_hopeless_ ? std::nullopt : choices_.answers();
  }

 private:
  static constexpr Answer kAlways = UINT32_MAX;

  void add(const Triangle& t, Answer answer) {
    const auto& p = all_.points;
    if (projection_axis(p[t[0]], p[t[1]], p[t[2]]) < 0) {
      exclude(answer, answer);  // without area
      return;
    }
    all_.triangles.push_back(t);
    answer_.push_back(answer);
  }
  /// Diagonals that are edges of other triangles as well.
  void exclude_crowded(const std::vector<Quad>& quads) {
    std::unordered_map<PairKey, std::vector<Answer>> by_diagonal;
    for (std::uint32_t q = 0; q < quads.size(); ++q)
      for (std::uint32_t a = 0; a < 2; ++a) by_diagonal[quads[q].diagonals[a]].push_back(2 * q + a);
    for (const auto& [key, answers] : by_diagonal)
      for (std::size_t i = 0; i < answers.size(); ++i)
        for (std::size_t j = i + 1; j < answers.size(); ++j) exclude(answers[i], answers[j]);
    for (std::size_t t = 0; t < all_.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        const Triangle& c = all_.triangles[t];
        const auto found = by_diagonal.find(pair_key(c[k], c[(k + 1) % 3]));
        if (found == by_diagonal.end()) continue;
        for (const Answer answer : found->second)
          if (answer != answer_[t]) exclude(answer, answer_[t]);
      }
  }
  bool collide(std::uint32_t s, std::uint32_t t) const {
    // The two ways of one face are never there together.
    if (answer_[s] != kAlways && answer_[t] != kAlways && answer_[s] == (answer_[t] ^ 1))
      return false;
    Triangle a = all_.triangles[s], b = all_.triangles[t];
    std::sort(a.begin(), a.end());
    std::sort(b.begin(), b.end());
    return a == b || triangles_cross(all_, s, t);
  }
  void exclude(Answer a, Answer b) {
    if (a == kAlways) std::swap(a, b);
    if (a == kAlways) {
      is_hopeless_ = true;
    } else {
      choices_.exclude(a, b == kAlways ? a : b);
    }
  }

  TwoChoices choices_;
  SurfaceMesh all_;
  std::vector<Answer> answer_;
  bool is_hopeless_ = false;
};

}  // namespace

std::size_t choose_diagonals(SurfaceMesh& mesh, const SameFace& same_face) {
  const std::vector<Quad> quads = quads_of(mesh, same_face);
  const auto answers = TriangleChoices(mesh, quads).answers(quads);
  if (!answers) return 0;
  std::size_t turned = 0;
  for (std::size_t q = 0; q < quads.size(); ++q) {
    if ((*answers)[q] == 0) continue;
    ++turned;
    for (std::size_t half = 0; half < 2; ++half)
      mesh.triangles[quads[q].places[half]] = quads[q].triangles[1][half];
  }
  return turned;
}

}  // namespace tripus::meshing::detail
