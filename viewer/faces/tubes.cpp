#include "viewer/faces/tubes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace tripus::viewer {
namespace {

using geometry::lorentz_product;

/// A piece leaves its chord by at most this part of its length.
constexpr double kStraight = 1.0 / 16;
/// Edges are halved so often at most.
constexpr int kMostHalvings = 5;
/// Two edges are one if their middles are nearer than this, in their lengths.
constexpr double kSamePlace = 1e-6;

Vector4 on_hyperboloid(const Vector4& sum) {
  return sum / std::sqrt(std::max(-lorentz_product(sum, sum), 1e-300));
}

/// <n, X> times the factor of the model, as a polynomial.
HalfSpace level(Model model, const Vector4& n) {
  if (model == Model::kKleinBall) return {0, n.head<3>(), -n[3]};
  return half_space(model, n);
}

/// The factor of the model; its square in the Klein ball.
HalfSpace factor(Model model) {
  if (model == Model::kUpperHalfSpace) return {0, {0, 0, 1}, 0};
  if (model == Model::kPoincareBall) return {-0.5, {0, 0, 0}, 0.5};
  return {-1, {0, 0, 0}, 1};
}

/// Two orthonormal vectors orthogonal to an edge: from the normals of its faces.
std::array<Vector4, 2> across(const SceneCell& cell, std::size_t edge) {
  constexpr std::array<std::array<std::size_t, 2>, 6> kFaces{
      {{2, 3}, {1, 3}, {1, 2}, {0, 3}, {0, 2}, {0, 1}}};
  const Vector4 &n = cell.walls[kFaces.at(edge)[0]], &m = cell.walls[kFaces.at(edge)[1]];
  const double cosine = lorentz_product(n, m);
  return {n, (m - cosine * n) / std::sqrt((1 - cosine) * (1 + cosine))};
}

/// The unit tangent at a point of the hyperboloid away from another one.
Vector4 away_from(const Vector4& other, const Vector4& at) {
  const Vector4 tangent = -other - lorentz_product(other, at) * at;
  return tangent / std::sqrt(std::max(lorentz_product(tangent, tangent), 1e-300));
}

/// How far Euclidean length in the model goes at most for hyperbolic length.
double scale_at(Model model, const Vector3& p) {
  if (model == Model::kUpperHalfSpace) return p.z();
  const double rest = std::max(1 - p.squaredNorm(), 0.0);
  return model == Model::kPoincareBall ? rest / 2 : std::sqrt(rest);
}

}  // namespace

TubeSet::TubeSet(Model model, const Scene& scene, const FaceSet& faces) : model_(model) {
  for (const Edge& edge : find_edges(scene, faces)) add_edge(scene, edge);
}

std::vector<TubeSet::Edge> TubeSet::find_edges(const Scene& scene, const FaceSet& faces) const {
  // Along a line that no symmetry knows, the copies of an edge are neighbours.
  const Vector3 line(1, 0.6180339887, 0.3247179572);
  std::vector<Edge> edges;
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t number = 0; number < scene.cells.size(); ++number) {
    const SceneCell& cell = scene.cells[number];
    std::size_t e = 0;
    for (std::size_t v = 0; v < 4; ++v) {
      for (std::size_t w = v + 1; w < 4; ++w, ++e) {
        if (parabolic_edge(cell, e) != nullptr) continue;
        Edge& edge = edges.emplace_back();
        edge.begin = cell.corners[3 * v + w - 1];
        edge.end = cell.corners[3 * w + v];
        edge.middle = geometry::to_model(model_, on_hyperboloid(edge.begin + edge.end));
        edge.cell = static_cast<std::uint32_t>(number);
        edge.number = static_cast<std::uint8_t>(e);
        edge.is_inner = true;
        for (std::size_t f = 0; f < 4; ++f)
          if (f != v && f != w)
            edge.is_inner =
                edge.is_inner && faces.faces()[faces.walls_per_cell() * number + f].is_shared();
        order.emplace_back(edge.middle.dot(line), edges.size() - 1);
      }
    }
  }
  std::ranges::sort(order);
  std::vector<bool> is_known(edges.size());
  std::vector<Edge> result;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (is_known[order[i].second]) continue;
    Edge edge = edges[order[i].second];
    const double near =
        kSamePlace *
        (geometry::to_model(model_, edge.begin) - geometry::to_model(model_, edge.end)).norm();
    for (std::size_t j = i + 1; j < order.size() && order[j].first - order[i].first <= 2 * near;
         ++j) {
      const Edge& other = edges[order[j].second];
      if ((other.middle - edge.middle).norm() > near) continue;
      is_known[order[j].second] = true;
      edge.is_inner = edge.is_inner && other.is_inner;
    }
    result.push_back(edge);
  }
  return result;
}

void TubeSet::add_edge(const Scene& scene, const Edge& edge) {
  const SceneCell& cell = scene.cells[edge.cell];
  Vector4 begin = edge.begin, end = edge.end;
  // Tubes that meet in a finite vertex go on beyond it.
  const bool is_singular = (cell.singular_edges >> edge.number & 1) != 0;
  const double more = std::tanh(is_singular ? kSingularTubeRadius : kTubeRadius);
  const auto [v, w] = [&]() -> std::array<std::size_t, 2> {
    std::size_t e = 0;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j, ++e)
        if (e == edge.number) return {i, j};
    return {0, 1};
  }();
  if (cell.diagonal[v] < 0) begin = on_hyperboloid(begin + more * away_from(edge.end, begin));
  if (cell.diagonal[w] < 0) end = on_hyperboloid(end + more * away_from(edge.begin, end));
  const auto place = [&](const Vector4& x) { return geometry::to_model(model_, x); };
  const auto cut = [&](const auto& self, const Vector4& from, const Vector4& to,
                       int halvings) -> void {
    const Vector4 between = on_hyperboloid(from + to);
    const Vector3 p = place(from), q = place(to);
    const double leaves = (place(between) - (p + q) / 2).norm();
    if (halvings == kMostHalvings || leaves <= kStraight * (q - p).norm()) {
      add_piece(cell, edge, from, to);
      return;
    }
    self(self, from, between, halvings + 1);
    self(self, between, to, halvings + 1);
  };
  cut(cut, begin, end, 0);
}

void TubeSet::add_piece(const SceneCell& cell, const Edge& edge, const Vector4& begin,
                        const Vector4& end) {
  const Vector4 between = on_hyperboloid(begin + end);
  const Vector3 p = geometry::to_model(model_, begin), q = geometry::to_model(model_, end),
                m = geometry::to_model(model_, between);
  const bool is_singular = (cell.singular_edges >> edge.number & 1) != 0;
  const double radius = std::sinh(is_singular ? kSingularTubeRadius : kTubeRadius);
  // The scale changes along the tube's radius by no more than this.
  const double wide =
      1.1 * radius * std::max({scale_at(model_, p), scale_at(model_, q), scale_at(model_, m)});
  TubePiece& piece = pieces_.emplace_back();
  piece.cell = edge.cell;
  piece.edge = edge.number;
  piece.is_singular = is_singular;
  piece.is_inner = edge.is_inner;
  piece.begin = p.cast<float>();
  piece.end = q.cast<float>();
  piece.radius = static_cast<float>(radius * scale_at(model_, m));
  piece.margin = static_cast<float>(1.1 * (m - (p + q) / 2).norm() + wide);

  const BoundingBall ball{(p + q) / 2, (q - p).norm() / 2 + piece.margin};
  const std::array<Vector4, 2> normals = across(cell, edge.number);
  const std::array<HalfSpace, 5> polynomials{
      in_local_frame(level(model_, normals[0]), ball.centre, ball.radius),
      in_local_frame(level(model_, normals[1]), ball.centre, ball.radius),
      in_local_frame(factor(model_), ball.centre, ball.radius),
      in_local_frame(half_space(model_, away_from(end, begin)), ball.centre, ball.radius),
      in_local_frame(half_space(model_, away_from(begin, end)), ball.centre, ball.radius)};
  // The square of the factor has one more factor 1 / scale than the factor.
  const double share = model_ == Model::kKleinBall ? 1 / ball.radius : 1;
  const auto append = [&](double x) { records_.push_back(static_cast<float>(x)); };
  for (std::size_t i = 0; i < 5; ++i) {
    const double times = i == 2 ? share : 1;
    for (int k = 0; k < 3; ++k) append(times * polynomials[i].b[k]);
    append(times * polynomials[i].a);
  }
  for (std::size_t i = 0; i < 4; ++i) append((i == 2 ? share : 1) * polynomials[i].c);
  append(polynomials[4].c);
  append(radius * radius);
  append(is_singular ? 1 : 0);
  append(0);
  for (int k = 0; k < 3; ++k) append(ball.centre[k]);
  append(ball.radius);
  for (int k = 0; k < 4; ++k) append(0);  // colour
}

}  // namespace tripus::viewer
