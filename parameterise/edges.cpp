#include "parameterise/edges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include <Eigen/Dense>

#include "base/error.hpp"

namespace tripus::parameterise {

using topology::slot_of;

namespace {

struct MeshEdge {
  std::uint32_t a, b;   // a < b
  std::uint32_t place;  // 6 t + e
  friend auto operator<=>(const MeshEdge&, const MeshEdge&) = default;
};

/// Every edge of every tetrahedron, those of one edge of the mesh together.
std::vector<MeshEdge> mesh_edges(const MarkedSolid& solid) {
  std::vector<MeshEdge> all;
  all.reserve(6 * solid.mesh.tetrahedra.size());
  for (std::uint32_t t = 0; t < solid.mesh.tetrahedra.size(); ++t)
    for (std::uint32_t e = 0; e < 6; ++e) {
      const auto [i, j] = topology::kEdgeEnds[e];
      const auto& corners = solid.mesh.tetrahedra[t];
      const auto [a, b] =
          std::minmax(corners[static_cast<std::size_t>(i)], corners[static_cast<std::size_t>(j)]);
      all.push_back({a, b, 6 * t + e});
    }
  std::ranges::sort(all);
  return all;
}

/// g_ab as seen from this place: the frame of b to that of a.
std::uint32_t transformation(MarkedSolid& solid, const MeshEdge& edge) {
  const std::size_t t = edge.place / 6;
  auto [i, j] = topology::kEdgeEnds[edge.place % 6];
  if (solid.mesh.tetrahedra[t][static_cast<std::size_t>(i)] != edge.a) std::swap(i, j);
  return solid.group->product(solid.group->inverse(solid.corners[slot_of(t, i)]),
                              solid.corners[slot_of(t, j)]);
}

}  // namespace

std::array<double, 6> element_weights(const std::array<geometry::Vector3, 4>& x, double& volume) {
  std::array<geometry::Vector3, 4> normal;  // outward, twice the area of the face
  for (std::size_t f = 0; f < 4; ++f) {
    const std::size_t a = (f + 1) % 4, b = (f + 2) % 4, c = (f + 3) % 4;
    normal[f] = (x[b] - x[a]).cross(x[c] - x[a]);
    if (normal[f].dot(x[f] - x[a]) > 0) normal[f] *= -1;
  }
  volume = std::abs((x[1] - x[0]).cross(x[2] - x[0]).dot(x[3] - x[0])) / 6;
  std::array<double, 6> weights{};
  for (std::size_t e = 0; e < 6; ++e) {
    const auto [i, j] = topology::kEdgeEnds[e];
    weights[e] = -normal[static_cast<std::size_t>(i)].dot(normal[static_cast<std::size_t>(j)]) /
                 (36 * volume);
  }
  return weights;
}

Weights weights_of(std::string_view name) {
  if (name == "finite-elements") return Weights::kFiniteElements;
  if (name == "cotangent") return Weights::kCotangent;
  if (name == "uniform") return Weights::kUniform;
  throw InvalidInput(quoted(std::string(name)) +
                     " is none of the weights finite-elements, cotangent and uniform");
}

WeightedEdges weighted_edges(MarkedSolid& solid, Weights weights) {
  WeightedEdges result;
  std::vector<double> by_place;
  double scale = 1;
  if (weights != Weights::kUniform) {
    double volume = 0;
    for (const meshing::Tetrahedron& t : solid.mesh.tetrahedra) {
      std::array<geometry::Vector3, 4> x;
      for (std::size_t v = 0; v < 4; ++v)
        x[v] = Eigen::Map<const geometry::Vector3>(solid.mesh.points[t[v]].data());
      double part = 0;
      for (const double w : element_weights(x, part)) by_place.push_back(std::isfinite(w) ? w : 0);
      volume += part;
    }
    scale = 1 / std::cbrt(volume);
  }
  const std::vector<MeshEdge> all = mesh_edges(solid);
  for (std::size_t i = 0; i < all.size();) {
    energies::HarmonicEdge edge{all[i].a, all[i].b, transformation(solid, all[i]), 1};
    std::size_t j = i;
    double sum = 0;
    for (; j < all.size() && all[j].a == edge.a && all[j].b == edge.b; ++j)
      if (!by_place.empty()) sum += by_place[all[j].place];
    if (!by_place.empty()) edge.weight = scale * sum;
    result.edges.push_back(edge);
    i = j;
  }
  if (weights != Weights::kCotangent) return result;
  double mean = 0;
  for (const energies::HarmonicEdge& edge : result.edges) mean += std::max(edge.weight, 0.0);
  mean /= static_cast<double>(result.edges.size());
  for (energies::HarmonicEdge& edge : result.edges)
    if (!(edge.weight >= kLeastWeight * mean)) {
      edge.weight = kLeastWeight * mean;
      ++result.clipped;
    }
  return result;
}

double equivariance_defect(MarkedSolid& solid) {
  double largest = 0;
  const std::vector<MeshEdge> all = mesh_edges(solid);
  std::vector<std::uint32_t> forward(all.size());  // by place
  for (std::size_t i = 0; i < all.size(); ++i) {
    forward[all[i].place] = transformation(solid, all[i]);
    if (i == 0 || all[i].a != all[i - 1].a || all[i].b != all[i - 1].b) continue;
    const Matrix4 difference =
        solid.group->matrix(forward[all[i].place]) - solid.group->matrix(forward[all[i - 1].place]);
    largest = std::max(largest, difference.cwiseAbs().maxCoeff());
  }
  for (std::size_t t = 0; t < solid.mesh.tetrahedra.size(); ++t) {
    const auto g = [&](int i, int j) -> Matrix4 {
      const auto& corners = solid.mesh.tetrahedra[t];
      const auto e = static_cast<std::size_t>(
          topology::kEdgeNumber[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]);
      const Matrix4& m = solid.group->matrix(forward[6 * t + e]);
      const bool turned =
          corners[static_cast<std::size_t>(i)] > corners[static_cast<std::size_t>(j)];
      return turned ? Matrix4(geometry::lorentz_inverse(m)) : m;
    };
    for (int f = 0; f < 4; ++f) {
      const int a = (f + 1) % 4, b = (f + 2) % 4, c = (f + 3) % 4;
      largest = std::max(largest, (g(a, b) * g(b, c) - g(a, c)).cwiseAbs().maxCoeff());
    }
  }
  return largest;
}

}  // namespace tripus::parameterise
