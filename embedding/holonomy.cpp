#include "embedding/holonomy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/tolerances.hpp"
#include "embedding/detail/orientations.hpp"
#include "embedding/detail/wide_product.hpp"
#include "embedding/developing_map.hpp"
#include "topology/dual_graph.hpp"

namespace tripus::embedding {
namespace {

using geometry::MoebiusMap;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A product of two 2x2 matrices is off by less than this times the product of their norms: four
/// roundings in each of two terms of a complex sum, and those of the factors themselves.
constexpr double kProductRounding = 16 * std::numeric_limits<double>::epsilon();

double norm(const MoebiusMap& map) {
  return std::sqrt(std::norm(map.a) + std::norm(map.b) + std::norm(map.c) + std::norm(map.d));
}

/// Overflow, and infinity minus infinity, count as infinite.
double or_infinity(double value) { return std::isfinite(value) ? value : kInfinity; }

/// [T] bounds on the errors of the developing map: those of the parent are carried on, and each
/// product adds its own.
std::vector<double> errors_of(const std::vector<MoebiusMap>& places,
                              const std::vector<std::array<MoebiusMap, 4>>& pairings,
                              const topology::SpanningForest& forest) {
  std::vector<double> errors(places.size(), 0.0);
  for (const std::uint32_t t : forest.order) {
    const std::uint32_t parent = forest.parent[t];
    if (parent == topology::kNoTetrahedron) continue;
    errors[t] = (errors[parent] + kProductRounding * norm(places[parent])) *
                norm(pairings[parent][forest.face[t]]);
  }
  return errors;
}

MoebiusMap factor(const Holonomy& holonomy, topology::Letter letter) {
  const MoebiusMap& map = holonomy.moebius[topology::generator_of(letter)];
  return letter > 0 ? map : geometry::inverse(map);
}

/// In doubles, as whoever multiplies the maps gets it.
MoebiusMap product_of(const Holonomy& holonomy, const topology::Word& word) {
  MoebiusMap product;
  for (const topology::Letter letter : word) product = product * factor(holonomy, letter);
  return product;
}

std::vector<MoebiusMap> factors(const Holonomy& holonomy, const topology::Word& word) {
  std::vector<MoebiusMap> maps;
  for (const topology::Letter letter : word) maps.push_back(factor(holonomy, letter));
  return maps;
}

double distance(const MoebiusMap& p, const MoebiusMap& q) {
  return norm({p.a - q.a, p.b - q.b, p.c - q.c, p.d - q.d});
}

void measure_edges(Holonomy& holonomy, const Embedding& embedding,
                   const topology::Triangulation& triangulation,
                   const std::vector<MoebiusMap>& places) {
  const std::vector<double> defects = edge_defects(embedding, triangulation);
  for (std::size_t e = 0; e < defects.size(); ++e) {
    const double size = norm(places[triangulation.corners(e)[0].tetrahedron()]);
    holonomy.local_defect = std::max(holonomy.local_defect, defects[e]);
    holonomy.carried_defect =
        std::max(holonomy.carried_defect, or_infinity(defects[e] * size * size));
  }
}

}  // namespace

Holonomy holonomy(const Embedding& embedding, const topology::Triangulation& triangulation) {
  Holonomy result;
  result.group = topology::orbifold_group(triangulation, embedding.cone_angles);
  result.orientable = triangulation.is_orientable();
  const topology::Gluings& gluings = triangulation.gluings();
  const auto pairings = detail::moebius_pairings(embedding, gluings);
  const std::vector<MoebiusMap> places = developing_map(embedding, gluings);
  const std::vector<double> errors =
      errors_of(places, pairings, topology::spanning_forest(gluings));
  const std::size_t count = result.group.presentation.generator_count;
  result.isometries.resize(count);
  result.moebius.resize(count);
  result.rounding.resize(count);
  for (std::size_t slot = 0; slot < result.group.face_letters.size(); ++slot) {
    const topology::Letter letter = result.group.face_letters[slot];
    if (letter <= 0) continue;
    const std::size_t t = slot / 4, f = slot % 4;
    const std::size_t other = gluings.neighbour(t, static_cast<int>(f));
    const std::size_t g = topology::generator_of(letter);
    const MoebiusMap& across = pairings[t][f];
    const MoebiusMap product = places[t] * across * geometry::inverse(places[other]);
    result.moebius[g] = detail::on_group(product);
    result.isometries[g] = geometry::to_matrix(result.moebius[g]);
    const double here = norm(places[t]), there = norm(places[other]);
    result.rounding[g] = or_infinity(norm(across) * (errors[t] * there + here * errors[other] +
                                                     2 * kProductRounding * here * there) +
                                     distance(product, result.moebius[g]));
  }
  measure_edges(result, embedding, triangulation, places);
  return result;
}

Matrix4 isometry_of(const Holonomy& holonomy, const topology::Word& word) {
  return detail::matrix_of_product(factors(holonomy, word));
}

geometry::MoebiusMap moebius_of(const Holonomy& holonomy, const topology::Word& word) {
  return detail::product_of(factors(holonomy, word));
}

std::vector<double> relator_defects(const Holonomy& holonomy) {
  std::vector<double> defects;
  for (const topology::Word& relator : holonomy.group.presentation.relators) {
    const MoebiusMap product = product_of(holonomy, relator);
    defects.push_back(std::isfinite(norm(product)) ? geometry::difference(product, {}) : kInfinity);
  }
  return defects;
}

std::vector<double> relator_bounds(const Holonomy& holonomy) {
  std::vector<double> bounds;
  for (const topology::Word& relator : holonomy.group.presentation.relators) {
    // What is wrong in one factor is multiplied by what stands before and behind it.
    std::vector<double> behind(relator.size() + 1);
    MoebiusMap product;
    behind.back() = norm(product);
    for (std::size_t n = relator.size(); n-- > 0;) {
      product = factor(holonomy, relator[n]) * product;
      behind[n] = norm(product);
    }
    product = {};
    double bound = holonomy.carried_defect;
    for (std::size_t n = 0; n < relator.size(); ++n) {
      const MoebiusMap next = factor(holonomy, relator[n]);
      bound +=
          norm(product) * behind[n + 1] *
          (holonomy.rounding[topology::generator_of(relator[n])] + kProductRounding * norm(next));
      product = product * next;
    }
    bounds.push_back(or_infinity(bound));
  }
  return bounds;
}

bool RelatorDefect::holds() const { return defect <= tolerance::kRelator; }

RelatorDefect relator_defect(const Holonomy& holonomy) {
  const auto largest = [](const std::vector<double>& values) {
    return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
  };
  return {largest(relator_defects(holonomy)), largest(relator_bounds(holonomy))};
}

}  // namespace tripus::embedding
