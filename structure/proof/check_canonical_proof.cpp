// The checker of canonical decompositions. It shares nothing with the prover but the triangulation,
// the kinds of its vertices, the theorems and FLINT.
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "base/error.hpp"
#include "structure/proof/canonical_proof_text.hpp"
#include "structure/proof/detail/arb_number.hpp"
#include "structure/proof/detail/checked_exact.hpp"
#include "structure/proof/detail/checked_tetrahedron.hpp"
#include "topology/cone_angle.hpp"
#include "topology/isosig.hpp"
#include "topology/labelled_isosig.hpp"
#include "topology/requirements.hpp"

namespace tripus::structure {
namespace {

using detail::Arb;
using topology::Triangulation;
using topology::VertexKind;

constexpr long kLengthBits = 256;

/// All numbers that tilts are made of, as balls.
struct Numbers {
  std::vector<detail::CheckedCofactors<Arb>> tetrahedra;  // [T]
  std::vector<Arb> horosphere;                            // [V] what terms are multiplied by
};

struct Checker {
  const Triangulation& triangulation;
  const CanonicalProofText& proof;
  std::vector<topology::ConeAngle> cone_angles;
  std::vector<topology::OrbifoldLink> links;
  std::vector<std::array<bool, 4>> inside;  // [T]
  std::vector<Arb> lengths{};               // [E]

  VertexKind kind(std::size_t t, int v) const {
    return links[triangulation.vertex_class(t, v)].kind;
  }
  bool has_kind(std::size_t t, VertexKind wanted) const {
    for (int v = 0; v < 4; ++v)
      if (kind(t, v) == wanted) return true;
    return false;
  }

  std::string read_faces() {
    if (!proof.unproved.empty()) return "it names faces that are not proved";
    for (const FaceOfTetrahedron& face : proof.inside) {
      if (face.tetrahedron >= triangulation.tetrahedron_count())
        return fmt::format("there is no tetrahedron {}, of an inner face", face.tetrahedron);
      const topology::Gluings& gluings = triangulation.gluings();
      const std::size_t other = gluings.neighbour(face.tetrahedron, face.face);
      const int g = gluings.gluing(face.tetrahedron, face.face)(face.face);
      bool& here = inside[face.tetrahedron][static_cast<std::size_t>(face.face)];
      if (here)
        return fmt::format("face {} of tetrahedron {} is named twice", face.face, face.tetrahedron);
      here = inside[other][static_cast<std::size_t>(g)] = true;
    }
    return {};
  }

  /// From the lengths and radii of the metric's proof.
  Numbers from_lengths() const {
    Numbers result;
    std::vector<Arb> area(links.size());
    for (std::size_t t = 0; t < triangulation.tetrahedron_count(); ++t) {
      std::array<Arb, 6> l;
      std::array<int, 4> kinds;
      for (int e = 0; e < 6; ++e)
        l[static_cast<std::size_t>(e)] = lengths[triangulation.edge_class(t, e)];
      for (int v = 0; v < 4; ++v)
        kinds[static_cast<std::size_t>(v)] = kind(t, v) == VertexKind::kHyperideal ? 1 : 0;
      const detail::CheckedGram gram(l, kinds);
      result.tetrahedra.push_back({gram.c, -gram.det});
      // theory 9.7: sqrt D / (2 a_ij a_ik a_il).
      for (std::size_t i = 0; i < 4; ++i) {
        if (kinds[i] != 0) continue;
        Arb product(-2.0);
        for (std::size_t j = 0; j < 4; ++j)
          if (j != i) product = product * gram.g[i][j];
        Arb& sum = area[triangulation.vertex_class(t, static_cast<int>(i))];
        sum = sum + square_root(-gram.det) / product;
      }
    }
    for (const Arb& a : area)
      result.horosphere.push_back(arb_is_zero(a.get()) != 0 ? Arb(1.0) : Arb(1.0) / square_root(a));
    return result;
  }

  Numbers from_field(const detail::CheckedExact& exact) const {
    Numbers result;
    for (std::size_t t = 0; t < triangulation.tetrahedron_count(); ++t)
      result.tetrahedra.push_back(exact.cofactors(t));
    for (std::size_t v = 0; v < links.size(); ++v) result.horosphere.push_back(exact.horosphere(v));
    return result;
  }

  /// The terms of a tilt that belong to vertices of one kind, docs/canonical.md (T3), (T7).
  Arb tilt(const Numbers& numbers, std::size_t t, int f, VertexKind wanted) const {
    const auto& [c, D] = numbers.tetrahedra[t];
    const auto i = static_cast<std::size_t>(f);
    Arb sum;
    for (int j = 0; j < 4; ++j)
      if (kind(t, j) == wanted)
        sum = sum + c[i][static_cast<std::size_t>(j)] *
                        numbers.horosphere[triangulation.vertex_class(t, j)];
    return -sum / square_root(-c[i][i] * D);
  }

  Arb tilt_sum(const Numbers& numbers, std::size_t t, int f, VertexKind wanted) const {
    const topology::Gluings& gluings = triangulation.gluings();
    return tilt(numbers, t, f, wanted) +
           tilt(numbers, gluings.neighbour(t, f), gluings.gluing(t, f)(f), wanted);
  }

  /// The edge class that joins vertex v of tetrahedron t, a cusp, to its three other vertices,
  /// which are hyperideal; -1 if there is no such class.
  std::int64_t spokes(std::size_t t, int v) const {
    if (kind(t, v) != VertexKind::kIdeal) return -1;
    std::int64_t common = -1;
    for (int e = 0; e < 6; ++e) {
      const int *ends = detail::kCheckedEnds[e], other = ends[0] == v ? ends[1] : ends[0];
      if (ends[0] != v && ends[1] != v) continue;
      const std::int64_t edge = triangulation.edge_class(t, e);
      if (kind(t, other) != VertexKind::kHyperideal || (common >= 0 && common != edge)) return -1;
      common = edge;
    }
    return common;
  }

  /// Whether the first terms add up to 0 without any numbers: theory (102), or no such terms.
  bool has_no_first_term(std::size_t t, int f) const {
    const std::size_t other = triangulation.gluings().neighbour(t, f);
    if (!has_kind(t, VertexKind::kHyperideal) && !has_kind(other, VertexKind::kHyperideal))
      return true;
    const topology::Perm4 across = triangulation.gluings().gluing(t, f);
    for (int v = 0; v < 4; ++v)
      if (v != f && spokes(t, v) >= 0 && spokes(t, v) == spokes(other, across(v))) return true;
    return false;
  }

  std::string check_face(std::size_t t, int f, const std::vector<Numbers>& routes,
                         const detail::CheckedExact* exact) const {
    const bool first_is_zero =
        has_no_first_term(t, f) ||
        (exact != nullptr && exact->sum_is_zero(t, f, VertexKind::kHyperideal));
    if (inside[t][static_cast<std::size_t>(f)]) {
      if (exact == nullptr)
        return fmt::format("face {} of tetrahedron {}: no field shows that its tilt sum is 0", f,
                           t);
      if (first_is_zero && exact->sum_is_zero(t, f, VertexKind::kIdeal)) return {};
      return fmt::format("face {} of tetrahedron {}: its tilt sum is not 0 in the field", f, t);
    }
    const VertexKind deciding = first_is_zero ? VertexKind::kIdeal : VertexKind::kHyperideal;
    for (const Numbers& numbers : routes)
      if (tilt_sum(numbers, t, f, deciding).negative()) return {};
    return fmt::format("face {} of tetrahedron {}: its tilt sum < 0 fails, it is near {:.6g}", f, t,
                       tilt_sum(routes.back(), t, f, deciding).mid());
  }

  std::string run(const Context& context) {
    if (std::string why = read_faces(); !why.empty()) return why;
    std::optional<detail::CheckedExact> exact;
    if (proof.field) {
      exact.emplace(triangulation, cone_angles, links, *proof.field);
      if (std::string why = exact->refusal(); !why.empty()) return why;
    }
    const detail::Precision precision(kLengthBits);
    for (std::size_t e = 0; e < triangulation.edge_count(); ++e)
      lengths.push_back(detail::read_number(proof.metric.lengths[e])
                            .widened_by(detail::read_number(proof.metric.radii[e])));
    std::vector<Numbers> routes{from_lengths()};
    if (exact && exact->has_horospheres()) routes.push_back(from_field(*exact));
    for (std::size_t t = 0; t < triangulation.tetrahedron_count(); ++t) {
      if (context.stop_requested() || context.expired()) return "stopped before it was decided";
      for (int f = 0; f < 4; ++f)
        if (std::string why = check_face(t, f, routes, exact ? &*exact : nullptr); !why.empty())
          return why;
    }
    return {};
  }
};

}  // namespace

ProofCheck check_canonical_proof(const Triangulation& given,
                                 std::span<const topology::ConeAngle> labels,
                                 const CanonicalProofText& proof, const Context& context) {
  topology::require_solvable(given, labels);
  if (!proof.proved) return {false, "nothing is claimed"};
  const auto signature = topology::labelled_signature(given, labels);
  if (signature.text != proof.triangulation)
    return {false, fmt::format("it is about the triangulation {}, and this is {}",
                               quoted(proof.triangulation), quoted(signature.text))};
  // With the numbers that the proof means.
  const Triangulation triangulation(topology::decode_isosig(signature.isosig));
  const auto& cone_angles = signature.labels;
  if (!topology::same_angles(cone_angles, proof.metric.cone_angles, triangulation.edge_count()))
    return {false, "the metric has other cone angles than the triangulation"};
  if (proof.metric.claim != Proof::Claim::kMetric) return {false, "it claims no metric"};
  if (ProofCheck metric = check_proof(triangulation, proof.metric, context); !metric) {
    metric.reason = "the metric: " + metric.reason;
    return metric;
  }
  Checker checker{triangulation, proof,
                  topology::completed(cone_angles, triangulation.edge_count()),
                  topology::orbifold_links(triangulation, cone_angles),
                  std::vector<std::array<bool, 4>>(triangulation.tetrahedron_count())};
  if (std::ranges::any_of(checker.links,
                          [](const auto& link) { return link.kind == VertexKind::kFinite; }))
    return {false, "a vertex is finite: there is no canonical decomposition"};
  std::string reason = checker.run(context);
  return {reason.empty(), std::move(reason)};
}

}  // namespace tripus::structure
