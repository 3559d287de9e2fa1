#include "structure/detail/small_decision.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "structure/detail/small_programme.hpp"

namespace tripus::structure::detail {
namespace {

using topology::Triangulation;
using Multipliers = std::vector<std::array<std::int64_t, 4>>;

/// The certificate from vertex multipliers, as certificate_from makes it (candidate.hpp), in
/// machine numbers.
std::optional<Certificate> small_certificate(const Triangulation& triangulation, Multipliers w) {
  std::int64_t divisor = 0, r = 0;
  for (const auto& four : w)
    for (const std::int64_t each : four) divisor = std::gcd(divisor, each);
  if (divisor == 0) return std::nullopt;
  for (auto& four : w)
    for (std::int64_t& each : four) r += each /= divisor;
  Certificate certificate;
  certificate.edge.reserve(triangulation.edge_count());
  for (std::size_t e = 0; e < triangulation.edge_count(); ++e) {
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    for (const auto corner : triangulation.corners(e)) {
      const auto& four = w[corner.tetrahedron()];
      const auto& ends = topology::kEdgeEnds[static_cast<std::size_t>(corner.edge())];
      least = std::min(
          least, four[static_cast<std::size_t>(ends[0])] + four[static_cast<std::size_t>(ends[1])]);
    }
    certificate.edge.emplace_back(least);
    r -= 2 * least;
  }
  if (r > 0) return std::nullopt;
  certificate.kind = r < 0 ? Certificate::Kind::kNone : Certificate::Kind::kSemi;
  certificate.vertex.resize(w.size());
  for (std::size_t t = 0; t < w.size(); ++t)
    for (std::size_t v = 0; v < 4; ++v) certificate.vertex[t][v] = w[t][v];
  return certificate;
}

/// One vertex sum that holds a whole edge angle of 2 pi, if there is one: an edge of valence 1, or
/// one of valence 2 whose corners are at one tetrahedron's vertex.
std::optional<Certificate> by_one_vertex(const Triangulation& triangulation) {
  for (std::size_t e = 0; e < triangulation.edge_count(); ++e) {
    const auto corners = triangulation.corners(e);
    if (corners.size() > 2 || corners[0].tetrahedron() != corners.back().tetrahedron()) continue;
    for (const int v : topology::kEdgeEnds[static_cast<std::size_t>(corners[0].edge())]) {
      const auto& other = topology::kEdgeEnds[static_cast<std::size_t>(corners.back().edge())];
      if (other[0] != v && other[1] != v) continue;
      Multipliers w(triangulation.tetrahedron_count());
      w[corners[0].tetrahedron()][static_cast<std::size_t>(v)] = 1;
      return small_certificate(triangulation, std::move(w));
    }
  }
  return std::nullopt;
}

bool is_plain(const Triangulation& triangulation,
              std::span<const topology::ConeAngle> cone_angles) {
  if (!topology::all_full(cone_angles)) return false;
  for (std::size_t v = 0; v < triangulation.vertex_count(); ++v)
    if (triangulation.link(v).euler_characteristic >= 0) return false;
  return true;
}

/// Exactly: angles >= 0, vertex sums <= 1, edge sums 2.
bool is_structure(const Triangulation& triangulation, const SmallProgramme& programme) {
  const std::int64_t one = programme.denominator();
  std::vector<std::int64_t> edge_sum(triangulation.edge_count());
  const auto angles = programme.angles();
  for (std::size_t t = 0; t < angles.size(); ++t) {
    std::array<std::int64_t, 4> vertex_sum{};
    for (std::size_t e = 0; e < 6; ++e) {
      if (angles[t][e] < 0) return false;
      edge_sum[triangulation.edge_class(t, static_cast<int>(e))] += angles[t][e];
      for (const int v : topology::kEdgeEnds[e])
        vertex_sum[static_cast<std::size_t>(v)] += angles[t][e];
    }
    if (std::ranges::any_of(vertex_sum, [&](std::int64_t sum) { return sum > one; })) return false;
  }
  return std::ranges::all_of(edge_sum, [&](std::int64_t sum) { return sum == 2 * one; });
}

/// Whether some angle structure consists of true tetrahedra and of flat ones, those of `flat` among
/// these; docs/theory.md (53'). A tetrahedron that is never a true one must be flat, in one of
/// three ways, and so on with what that leaves. Nothing if numbers grew too large.
std::optional<bool> may_be_degenerate(const Triangulation& triangulation,
                                      const SmallProgramme& programme, std::vector<int>& flat) {
  if (programme.sign() > 0) return false;
  const auto t = programme.never_true();
  if (!t) return true;
  for (int pair = 0; pair < 3; ++pair) {
    if (!programme.may_be_positive(*t, static_cast<std::size_t>(pair)) ||
        !programme.may_be_positive(*t, static_cast<std::size_t>(5 - pair)))
      continue;
    flat[*t] = pair;
    SmallProgramme rest(triangulation, flat);
    if (!rest.solve()) return std::nullopt;
    const auto possible = may_be_degenerate(triangulation, rest, flat);
    flat[*t] = -1;
    if (!possible || *possible) return possible;
  }
  return false;
}

}  // namespace

bool has_low_valence(const Triangulation& triangulation) {
  for (std::size_t e = 0; e < triangulation.edge_count(); ++e)
    if (triangulation.valence(e) <= 2) return true;
  return false;
}

std::optional<SmallDecision> decide_small(const Triangulation& triangulation,
                                          std::span<const topology::ConeAngle> cone_angles) {
  if (triangulation.tetrahedron_count() > SmallProgramme::kMostTetrahedra ||
      !is_plain(triangulation, cone_angles))
    return std::nullopt;
  if (auto certificate = by_one_vertex(triangulation))
    return SmallDecision{.certificate = std::move(certificate)};
  SmallProgramme programme(triangulation);
  if (!programme.solve()) return std::nullopt;
  if (programme.sign() < 0) return SmallDecision{};
  auto certificate = small_certificate(triangulation, programme.vertex_multipliers());
  const auto kind = programme.sign() > 0 ? Certificate::Kind::kNone : Certificate::Kind::kSemi;
  if (!certificate || certificate->kind != kind) return std::nullopt;
  if (kind == Certificate::Kind::kNone) return SmallDecision{.certificate = std::move(certificate)};
  std::vector<int> flat(triangulation.tetrahedron_count(), -1);
  const auto degenerate = may_be_degenerate(triangulation, programme, flat);
  if (!degenerate || !is_structure(triangulation, programme)) return std::nullopt;
  return SmallDecision{.certificate = std::move(certificate), .may_be_degenerate = *degenerate};
}

}  // namespace tripus::structure::detail
