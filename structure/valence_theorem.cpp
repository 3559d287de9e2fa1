// What is known from the valences alone. The answer names what proves it.
#include "structure/valence_theorem.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace tripus::structure {
namespace {

constexpr std::size_t kGeometricValence = 9;   // arXiv 2601.15174
constexpr std::size_t kHyperbolicValence = 6;  // arXiv math/0402339
constexpr std::size_t kCuspValence = 6;        // of edges with an ideal end, docs/theory.md (119)

/// The condition of docs/theory.md (119): one ideal vertex a tetrahedron at most, edges at it of
/// valence 6, all other edges with the same numbers of corners in tetrahedra without and with one.
bool are_alike(const topology::Triangulation& triangulation) {
  const auto is_ideal = [&](std::size_t t, int v) {
    return triangulation.link(triangulation.vertex_class(t, v)).euler_characteristic == 0;
  };
  std::vector<int> ideal_vertex(triangulation.tetrahedron_count(), -1);
  for (std::size_t t = 0; t < ideal_vertex.size(); ++t)
    for (int v = 0; v < 4; ++v) {
      if (!is_ideal(t, v)) continue;
      if (ideal_vertex[t] >= 0) return false;
      ideal_vertex[t] = v;
    }
  std::array<std::size_t, 2> common = {};
  for (std::size_t e = 0; e < triangulation.edge_count(); ++e) {
    std::array<std::size_t, 2> corners = {};
    bool at_cusp = false;
    for (const auto corner : triangulation.corners(e)) {
      const int ideal = ideal_vertex[corner.tetrahedron()];
      const auto ends = topology::kEdgeEnds[static_cast<std::size_t>(corner.edge())];
      at_cusp = at_cusp || std::ranges::count(ends, ideal) > 0;
      ++corners[ideal >= 0];
    }
    if (at_cusp) {
      if (triangulation.valence(e) != kCuspValence) return false;
      continue;
    }
    if (common == std::array<std::size_t, 2>{}) common = corners;
    if (corners != common) return false;
  }
  return common[0] + common[1] > 6;
}

}  // namespace

ValenceTheorem::Claim ValenceTheorem::claim() const {
  return condition == Condition::kAtLeastSix ? Claim::kHyperbolic : Claim::kGeometric;
}

std::string_view ValenceTheorem::source() const {
  switch (condition) {
    case Condition::kAtLeastNine:
      return "arXiv 2601.15174";
    case Condition::kAlike:
      return "docs/theory.md (119)";
    case Condition::kAtLeastSix:
      break;
  }
  return "arXiv math/0402339";
}

std::string_view to_string(ValenceTheorem::Claim claim) {
  return claim == ValenceTheorem::Claim::kGeometric ? "geometric" : "hyperbolic";
}

std::string message(const ValenceTheorem& theorem) {
  using Condition = ValenceTheorem::Condition;
  const bool geometric = theorem.claim() == ValenceTheorem::Claim::kGeometric;
  std::string condition = "every valence is at least " +
                          std::to_string(geometric ? kGeometricValence : kHyperbolicValence);
  if (theorem.condition == Condition::kAlike)
    condition =
        theorem.least_valence == kCuspValence
            ? "all edges between geodesic boundary are alike, and those to cusps have valence 6"
            : "all edges have the same valence";
  return condition +
         (geometric ? ", so this triangulation carries the metric ("
                    : ", so the manifold is hyperbolic (") +
         std::string(theorem.source()) + ")";
}

std::optional<ValenceTheorem> valence_theorem(const topology::Triangulation& triangulation,
                                              std::span<const topology::ConeAngle> cone_angles) {
  if (!topology::all_full(cone_angles) || !triangulation.is_connected()) return std::nullopt;
  bool has_cusps = false;
  for (std::size_t v = 0; v < triangulation.vertex_count(); ++v) {
    const auto characteristic = triangulation.link(v).euler_characteristic;
    if (characteristic > 0) return std::nullopt;
    has_cusps = has_cusps || characteristic == 0;
  }
  std::size_t least = triangulation.valence(0);
  for (std::size_t e = 1; e < triangulation.edge_count(); ++e)
    least = std::min<std::size_t>(least, triangulation.valence(e));
  using Condition = ValenceTheorem::Condition;
  if (!has_cusps && least >= kGeometricValence)
    return ValenceTheorem{Condition::kAtLeastNine, least};
  if (least < kHyperbolicValence) return std::nullopt;
  if (are_alike(triangulation)) return ValenceTheorem{Condition::kAlike, least};
  if (has_cusps) return std::nullopt;
  return ValenceTheorem{Condition::kAtLeastSix, least};
}

}  // namespace tripus::structure
