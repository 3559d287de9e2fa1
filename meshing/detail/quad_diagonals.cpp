#include "meshing/detail/quad_diagonals.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "meshing/detail/connectivity.hpp"
#include "meshing/detail/triangle_tree.hpp"
#include "meshing/detail/two_choices.hpp"
#include "meshing/predicates.hpp"
#include "meshing/self_intersection.hpp"

namespace tripus::meshing::detail {
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
