#include "orthospectrum/detail/steps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <Eigen/Dense>
#include <fmt/format.h>

#include "base/error.hpp"
#include "geometry/mixed_tetrahedron.hpp"

namespace tripus::orthospectrum::detail {
namespace {

// Everything here is done once, in the widest type, so that the steps carry no error of their own.
using Wide = long double;
using Wide3 = Eigen::Matrix<Wide, 3, 3>;
using Wide4 = Eigen::Matrix<Wide, 4, 4>;
using WideVector3 = Eigen::Matrix<Wide, 3, 1>;

Wide4 gram_of(const topology::Triangulation& triangulation, std::span<const double> lengths,
              std::size_t t) {
  std::array<double, 6> l{}, theta{};
  for (int e = 0; e < 6; ++e)
    l[static_cast<std::size_t>(e)] = lengths[triangulation.edge_class(t, e)];
  std::array<double, 4> diagonal{};
  for (int i = 0; i < 4; ++i)
    diagonal[static_cast<std::size_t>(i)] =
        triangulation.link(triangulation.vertex_class(t, i)).euler_characteristic == 0 ? 0 : 1;
  for (std::size_t e = 0; e < 6; ++e) {
    const auto [i, j] = topology::kEdgeEnds[e];
    const bool is_compact =
        diagonal[static_cast<std::size_t>(i)] != 0 && diagonal[static_cast<std::size_t>(j)] != 0;
    if (!std::isfinite(l[e]) || (is_compact && !(l[e] > 0)))
      throw InvalidInput(fmt::format("edge {} of tetrahedron {} has the length {}", e, t, l[e]));
  }
  if (geometry::mixed_dihedral_angles(l, diagonal, theta) !=
      geometry::TetrahedronKind::kTruncated) {
    throw InvalidInput("tetrahedron " + std::to_string(t) +
                       " is flat: arcs are unfolded through true truncated tetrahedra only");
  }
  Wide4 gram = Wide4::Zero();
  for (int i = 0; i < 4; ++i) gram(i, i) = diagonal[static_cast<std::size_t>(i)];
  for (std::size_t e = 0; e < 6; ++e) {
    const auto [i, j] = topology::kEdgeEnds[e];
    const int ideal_ends = (gram(i, i) == 0) + (gram(j, j) == 0);
    gram(i, j) = gram(j, i) =
        ideal_ends == 0 ? -std::cosh(Wide(l[e])) : -ideal_ends * std::exp(Wide(l[e]));
  }
  return gram;
}

/// w' beyond face f: in the plane of the face it has the products that its own tetrahedron says,
/// and its height over that plane is that of the vertex opposite to the face there.
Step step_across(const topology::Gluings& gluings, std::span<const Wide4> grams, std::size_t t,
                 int f) {
  const topology::Perm4 p = gluings.gluing(t, f);
  const std::size_t beyond = gluings.neighbour(t, f);
  Step step;
  step.tetrahedron = static_cast<std::uint32_t>(beyond);
  for (int i = 0; i < 4; ++i)
    step.labels[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(p(i));
  Wide3 face;
  WideVector3 products;
  for (int r = 0, i = 0; i < 4; ++i) {
    if (i == f) continue;
    for (int c = 0, j = 0; j < 4; ++j)
      if (j != f) face(r, c++) = grams[t](i, j);
    products[r++] = grams[beyond](p(f), p(i));
  }
  const WideVector3 within = face.fullPivLu().solve(products);
  const Wide4 here = grams[t].inverse(), there = grams[beyond].inverse();
  // <w', n> = 1 / sqrt(N'_ff) and n = - sum_i N_fi w_i / sqrt(N_ff), N = G^-1.
  const Wide scale = -1 / std::sqrt(here(f, f) * there(p(f), p(f)));
  for (int r = 0, i = 0; i < 4; ++i) {
    const Wide along = i == f ? 0 : within[r++];
    step.combination[static_cast<std::size_t>(i)] = static_cast<double>(along + scale * here(f, i));
  }
  return step;
}

Triangle triangle_at(const Wide4& gram, int i) {
  Triangle triangle;
  std::array<Wide, 3> sinh{};
  for (std::size_t k = 0, j = 0; j < 4; ++j) {
    if (static_cast<int>(j) == i) continue;
    const Wide g = gram(i, static_cast<int>(j));
    triangle.corners[k] = static_cast<std::uint8_t>(j);
    triangle.gram[k] = static_cast<double>(g);
    const int corner = static_cast<int>(j);
    sinh[k++] = gram(corner, corner) == 0 ? -g : std::sqrt((g - 1) * (g + 1));
  }
  // cosh of the sides, side k between the other two corners.
  std::array<Wide, 3> side{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
    const int p = triangle.corners[a], q = triangle.corners[b];
    side[k] = (gram(i, p) * gram(i, q) - gram(p, q)) / (sinh[a] * sinh[b]);
  }
  // The middle is the normalised sum of the corners; directions to the corners by their angles.
  const Wide size = std::sqrt(3 + 2 * (side[0] + side[1] + side[2]));
  std::array<Wide, 3> height{}, radius{};
  for (std::size_t k = 0; k < 3; ++k) {
    height[k] = (1 + side[(k + 1) % 3] + side[(k + 2) % 3]) / size;
    radius[k] = std::sqrt((height[k] - 1) * (height[k] + 1));
  }
  const auto angle = [&](std::size_t a, std::size_t b) {
    return std::acos((height[a] * height[b] - side[3 - a - b]) / (radius[a] * radius[b]));
  };
  const std::array<Wide, 3> direction{0, angle(0, 1), -angle(0, 2)};
  Wide3 products;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::array<Wide, 3> foot{sinh[k] * radius[k] * std::cos(direction[k]),
                                   sinh[k] * radius[k] * std::sin(direction[k]),
                                   sinh[k] * height[k]};
    const int row = static_cast<int>(k);
    products.row(row) << foot[0], foot[1], -foot[2];
    for (std::size_t c = 0; c < 3; ++c) triangle.feet[k][c] = static_cast<double>(foot[c]);
  }
  const Wide3 inverse = products.inverse();
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c)
      triangle.project[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)] =
          static_cast<double>(inverse(r, c));
  return triangle;
}

/// `apart`: what -<v, w_i> is at least.
Lid lid_over(const Wide4& gram, int f, const std::array<Wide, 4>& apart) {
  Wide3 face;
  WideVector3 products;
  for (int r = 0, i = 0; i < 4; ++i) {
    if (i == f) continue;
    for (int c = 0, j = 0; j < 4; ++j)
      if (j != f) face(r, c++) = gram(i, j);
    products[r++] = -apart[static_cast<std::size_t>(i)];
  }
  const WideVector3 within = face.fullPivLu().solve(products);
  const Wide height_square = 1 - within.dot(products);
  const Wide4 inverse = gram.inverse();
  Lid lid;
  lid.exists = height_square > 0;
  if (!lid.exists) return lid;
  const Wide scale = -std::sqrt(height_square / inverse(f, f));
  for (int r = 0, i = 0; i < 4; ++i) {
    const Wide along = i == f ? 0 : within[r++];
    lid.combination[static_cast<std::size_t>(i)] =
        static_cast<double>(along + scale * inverse(f, i));
  }
  return lid;
}

/// [4 T] the largest c for which the horoball -<x, w_i> <= c of an ideal vertex meets neither the
/// face opposite to it nor another truncation, in any tetrahedron around it; 0 for the others.
std::vector<double> horoballs_of(const topology::Triangulation& triangulation,
                                 std::span<const Wide4> grams) {
  std::vector<Wide> of_class(triangulation.vertex_count(), std::numeric_limits<Wide>::infinity());
  std::vector<double> result(4 * grams.size());
  const auto for_each_ideal = [&](auto&& visit) {
    for (std::size_t t = 0; t < grams.size(); ++t)
      for (int i = 0; i < 4; ++i)
        if (grams[t](i, i) == 0) visit(t, i, of_class[triangulation.vertex_class(t, i)]);
  };
  for_each_ideal([&](std::size_t t, int i, Wide& level) {
    const Wide4& gram = grams[t];
    level = std::min(level, 1 / std::sqrt(gram.inverse()(i, i)));
    for (int j = 0; j < 4; ++j)
      if (gram(j, j) != 0) level = std::min(level, -gram(i, j));
  });
  for_each_ideal([&](std::size_t t, int i, Wide level) {
    result[4 * t + static_cast<std::size_t>(i)] = static_cast<double>(level);
  });
  return result;
}

}  // namespace

std::vector<Lid> Steps::lids(double shortest) const {
  std::vector<Lid> result;
  result.reserve(triangles_.size());
  for (std::size_t t = 0; t < tetrahedron_count(); ++t) {
    Wide4 gram;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) gram(i, j) = -Wide(cosh_length(t, i, j));
    std::array<Wide, 4> apart{};
    for (int i = 0; i < 4; ++i)
      apart[static_cast<std::size_t>(i)] =
          is_ideal(t, i) ? Wide(horoball(t, i)) : std::cosh(Wide(shortest));
    for (int f = 0; f < 4; ++f) result.push_back(lid_over(gram, f, apart));
  }
  return result;
}

Steps::Steps(const topology::Triangulation& triangulation, std::span<const double> edge_lengths) {
  if (edge_lengths.size() != triangulation.edge_count()) {
    throw InvalidInput(std::to_string(edge_lengths.size()) + " edge lengths for " +
                       std::to_string(triangulation.edge_count()) + " edge classes");
  }
  const std::size_t count = triangulation.tetrahedron_count();
  std::vector<Wide4> grams;
  grams.reserve(count);
  for (std::size_t t = 0; t < count; ++t) grams.push_back(gram_of(triangulation, edge_lengths, t));
  horoballs_ = horoballs_of(triangulation, grams);
  steps_.reserve(4 * count);
  triangles_.reserve(4 * count);
  cosh_.reserve(16 * count);
  for (std::size_t t = 0; t < count; ++t) {
    for (int i = 0; i < 4; ++i) {
      steps_.push_back(step_across(triangulation.gluings(), grams, t, i));
      triangles_.push_back(grams[t](i, i) == 0 ? Triangle() : triangle_at(grams[t], i));
      for (int j = 0; j < 4; ++j) cosh_.push_back(static_cast<double>(-grams[t](i, j)));
    }
  }
}

}  // namespace tripus::orthospectrum::detail
