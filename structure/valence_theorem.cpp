// What is known from the valences alone. The theorems are not proved here: the answer names them.
#include "structure/valence_theorem.hpp"

#include <algorithm>

namespace tripus::structure {
namespace {

constexpr std::size_t kGeometricValence = 9;   // arXiv 2601.15174
constexpr std::size_t kHyperbolicValence = 6;  // arXiv math/0402339

}  // namespace

std::string_view ValenceTheorem::source() const {
  return claim == Claim::kGeometric ? "arXiv 2601.15174" : "arXiv math/0402339";
}

std::string_view to_string(ValenceTheorem::Claim claim) {
  return claim == ValenceTheorem::Claim::kGeometric ? "geometric" : "hyperbolic";
}

std::string message(const ValenceTheorem& theorem) {
  const bool geometric = theorem.claim == ValenceTheorem::Claim::kGeometric;
  return "every valence is at least " +
         std::to_string(geometric ? kGeometricValence : kHyperbolicValence) +
         (geometric ? ", so this triangulation carries the metric ("
                    : ", so the manifold is hyperbolic (") +
         std::string(theorem.source()) + ")";
}

std::optional<ValenceTheorem> valence_theorem(const topology::Triangulation& triangulation,
                                              std::span<const topology::ConeAngle> cone_angles) {
  if (!topology::all_full(cone_angles) || !triangulation.is_connected()) return std::nullopt;
  for (std::size_t v = 0; v < triangulation.vertex_count(); ++v)
    if (triangulation.link(v).euler_characteristic >= 0) return std::nullopt;
  std::size_t least = triangulation.valence(0);
  for (std::size_t e = 1; e < triangulation.edge_count(); ++e)
    least = std::min<std::size_t>(least, triangulation.valence(e));
  if (least < kHyperbolicValence) return std::nullopt;
  using Claim = ValenceTheorem::Claim;
  return ValenceTheorem{least >= kGeometricValence ? Claim::kGeometric : Claim::kHyperbolic, least};
}

}  // namespace tripus::structure
