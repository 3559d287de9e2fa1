#include "viewer/inside/inside_manifold.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "base/error.hpp"
#include "viewer/scene.hpp"

namespace tripus::viewer {
namespace {

using geometry::lorentz_product;

/// Class numbers choose colours; larger ones would not be exact in single precision.
float as_class(std::uint32_t number) { return static_cast<float>(number % 4096); }

void write_record(float* texels, const InsideManifold& m, std::size_t t,
                  const std::vector<float>& first_disc) {
  const embedding::HyperboloidTetrahedron& shape = m.tetrahedra[t];
  const auto put = [&](std::size_t at, double x) { texels[at] = static_cast<float>(x); };
  // With their time negated, the usual product is the Lorentzian one.
  for (std::size_t i = 0; i < 8; ++i) {
    const auto& v = i < 4 ? shape.faces[i] : shape.vertices[i - 4];
    for (int k = 0; k < 4; ++k) put(4 * i + static_cast<std::size_t>(k), k < 3 ? v[k] : -v[k]);
  }
  for (std::size_t f = 0; f < 4; ++f) {
    for (int k = 0; k < 16; ++k)
      put(32 + 16 * f + static_cast<std::size_t>(k), m.crossing[t][f](k / 4, k % 4));
    put(96 + f, m.neighbour[t][f]);
    put(100 + f, m.entry[t][f]);
  }
  for (std::size_t e = 0; e < 6; ++e) {
    const auto [k, l] = faces_at_edge(e);
    const double cosine = lorentz_product(shape.faces[k], shape.faces[l]);
    put(104 + e, cosine);
    put(128 + e, shape.is_parabolic(e) ? -shape.parabolic_scale : 1 / (1 - cosine * cosine));
    texels[112 + e] = as_class(m.edge_class[t][e]);
    put(140 + e, m.singular_edges[t] >> e & 1);
  }
  for (std::size_t v = 0; v < 4; ++v) {
    texels[120 + v] = as_class(m.vertex_class[t][v]);
    texels[124 + v] = first_disc.empty() ? 0 : first_disc[4 * t + v];
    put(136 + v, shape.diagonal[v]);
  }
}

}  // namespace

int InsideManifold::kinds() const {
  int result = 0;
  for (const embedding::HyperboloidTetrahedron& shape : tetrahedra) {
    if (shape.parabolic_edges != 0) return 2;
    if (!std::ranges::all_of(shape.diagonal, [](double d) { return d > 0; })) result = 1;
  }
  return result;
}

InsideManifold inside_manifold(const embedding::Embedding& embedding,
                               const topology::Triangulation& triangulation,
                               std::vector<double> edge_lengths,
                               std::shared_ptr<const WallDiscs> discs) {
  InsideManifold m;
  m.tetrahedra = embedding.tetrahedra;
  m.singular_edges = embedding.singular_edges;
  m.edge_lengths = std::move(edge_lengths);
  m.discs = std::move(discs);
  for (std::size_t t = 0; t < m.tetrahedra.size(); ++t) {
    auto& neighbour = m.neighbour.emplace_back();
    auto& entry = m.entry.emplace_back();
    auto& crossing = m.crossing.emplace_back();
    for (int f = 0; f < 4; ++f) {
      const auto face = static_cast<std::size_t>(f);
      const std::size_t other = triangulation.gluings().neighbour(t, f);
      const int there = triangulation.gluings().gluing(t, f)(f);
      neighbour[face] = static_cast<std::uint32_t>(other);
      entry[face] = static_cast<std::uint8_t>(there);
      crossing[face] = embedding.face_pairings[other][static_cast<std::size_t>(there)];
    }
    auto& edges = m.edge_class.emplace_back();
    for (std::size_t e = 0; e < 6; ++e) edges[e] = triangulation.edge_classes()[6 * t + e];
    auto& vertices = m.vertex_class.emplace_back();
    for (std::size_t v = 0; v < 4; ++v) vertices[v] = triangulation.vertex_classes()[4 * t + v];
  }
  return m;
}

std::vector<float> inside_records(const InsideManifold& manifold,
                                  const std::vector<float>& first_disc) {
  const std::size_t count = manifold.tetrahedra.size(), row = 4 * std::size_t{2048};
  std::vector<float> texels(row * ((count + kInsidePerRow - 1) / kInsidePerRow));
  for (std::size_t t = 0; t < count; ++t)
    write_record(
        texels.data() + row * (t / kInsidePerRow) + 4 * kInsideTexels * (t % kInsidePerRow),
        manifold, t, first_disc);
  return texels;
}

std::string describe_inside(const InsideManifold& manifold, int kind, std::size_t tetrahedron,
                            std::size_t number) {
  if (kind == 1 && number < 4) {
    const bool is_cusp = manifold.tetrahedra[tetrahedron].is_ideal(number);
    return fmt::format("tetrahedron {}, {} {} of {} {}", tetrahedron,
                       is_cusp ? "horosphere" : "truncation", number,
                       is_cusp ? "cusp" : "boundary component",
                       manifold.vertex_class[tetrahedron][number]);
  }
  if (kind == 1 && number < 10) {
    const std::size_t edge = number - 4;
    return fmt::format("tetrahedron {}, horosphere of the parabolic edge {}{} of class {}",
                       tetrahedron, topology::kEdgeEnds[edge][0], topology::kEdgeEnds[edge][1],
                       manifold.edge_class[tetrahedron][edge]);
  }
  if (kind != 2 || number >= 6) return {};
  const std::uint32_t edge = manifold.edge_class[tetrahedron][number];
  std::string text =
      fmt::format("tetrahedron {}, edge {}{} of class {}", tetrahedron,
                  topology::kEdgeEnds[number][0], topology::kEdgeEnds[number][1], edge);
  if (edge < manifold.edge_lengths.size())
    text += fmt::format(", length {:.8g}", manifold.edge_lengths[edge]);
  const auto [k, l] = faces_at_edge(number);
  const auto& faces = manifold.tetrahedra[tetrahedron].faces;
  const double cosine = -lorentz_product(faces[k], faces[l]);
  return text + fmt::format(", angle {:.6g} degrees",
                            std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi);
}

}  // namespace tripus::viewer
