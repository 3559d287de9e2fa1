#include "canonical/proved.hpp"

#include <fmt/format.h>

#include "structure/proof/tilt_signs.hpp"
#include "topology/isosig.hpp"
#include "topology/labelled_isosig.hpp"

namespace tripus::canonical {
namespace {

using structure::ProvedSign;

constexpr std::size_t kFacesNamed = 8;

std::string named(const std::vector<FaceOfTetrahedron>& faces) {
  std::string text;
  for (std::size_t k = 0; k < faces.size() && k < kFacesNamed; ++k)
    text += fmt::format("{}{} of tetrahedron {}", k == 0 ? "" : ", ", faces[k].face,
                        faces[k].tetrahedron);
  if (faces.size() > kFacesNamed) text += fmt::format(", and {} more", faces.size() - kFacesNamed);
  return text;
}

}  // namespace

CanonicalProof prove_canonical(const CanonicalManifold& manifold, const Context& context) {
  CanonicalProof result;
  const topology::LabelledSignature signature =
      topology::labelled_signature(manifold.triangulation, manifold.cone_angles);
  result.triangulation = signature.text;
  const topology::Triangulation triangulation(topology::decode_isosig(signature.isosig));
  const auto edges =
      topology::edge_images(manifold.triangulation, signature.isomorphism, triangulation);
  std::vector<double> lengths(edges.size());
  for (std::size_t e = 0; e < edges.size(); ++e)
    lengths[edges[e]] = manifold.report.edge_lengths[e];
  structure::ProveOptions options;
  options.cone_angles = signature.labels;
  result.metric = structure::prove_near(triangulation, lengths, options, context);
  if (!result.metric.proved) {
    result.reason = result.metric.reason;
    return result;
  }
  const structure::TiltSigns tilts =
      structure::tilt_signs(triangulation, result.metric, {}, context);
  result.field = tilts.field;
  const topology::Gluings& gluings = manifold.triangulation.gluings();
  for (std::size_t t = 0; t < gluings.tetrahedron_count(); ++t)
    for (int f = 0; f < 4; ++f) {
      const std::size_t other = gluings.neighbour(t, f);
      const bool once = other > t || (other == t && gluings.gluing(t, f)(f) > f);
      if (!once) continue;
      const FaceOfTetrahedron face{signature.isomorphism.tetrahedron_images[t],
                                   signature.isomorphism.perms[t](f)};
      const ProvedSign sign = tilts.sign[face.tetrahedron][static_cast<std::size_t>(face.face)];
      const FaceKind kind = manifold.faces.kind[t][static_cast<std::size_t>(f)];
      if (sign == ProvedSign::kZero && kind == FaceKind::kTransparent)
        result.inside.push_back(face);
      else if (sign != ProvedSign::kNegative || kind != FaceKind::kTrue)
        result.unproved.push_back(face);
    }
  result.proved = result.unproved.empty();
  if (!result.proved)
    result.reason = fmt::format("the sign of the tilt sum is not proved at {} {} of {}",
                                result.unproved.size() == 1 ? "face" : "faces",
                                named(result.unproved), result.triangulation);
  return result;
}

structure::CanonicalProofText proof_text(const CanonicalProof& proof) {
  return {proof.proved,
          proof.reason,
          proof.triangulation,
          proof.unproved,
          proof.inside,
          proof.field,
          structure::proof_text(proof.metric)};
}

ComparisonProof prove_comparison(const Comparison& comparison, const Context& context) {
  const std::string& by = comparison.decided_by;
  if (comparison.verdict == Verdict::kUnresolved) return {false, "", "nothing was decided"};
  if (by == "boundary" || by == "orientability" || by == "homology") return {true, "integers", ""};
  if (by == "triangulation") return {true, by, ""};
  if (!comparison.first || !comparison.second)
    return {false, "", "it was decided by " + by + ", which is not proved"};
  const CanonicalProof a = prove_canonical(*comparison.first, context);
  const CanonicalProof b = prove_canonical(*comparison.second, context);
  if (!a.metric.proved || !b.metric.proved)
    return {false, "", a.metric.proved ? b.reason : a.reason};
  if (comparison.verdict == Verdict::kDifferent && (a.metric.volume.upper < b.metric.volume.lower ||
                                                    b.metric.volume.upper < a.metric.volume.lower))
    return {true, "volume", ""};
  if (by == "decomposition" && a.proved && b.proved) return {true, by, ""};
  return {false, "",
          fmt::format("the canonical decomposition of the {} is not proved: {}",
                      a.proved ? "second" : "first", a.proved ? b.reason : a.reason)};
}

std::string proof_message(const CanonicalProof& proof) {
  if (!proof.proved) return "Not proved: " + proof.reason + ".";
  if (proof.inside.empty())
    return "Proved: every face is one of the canonical decomposition, and the metric is there.";
  return fmt::format(
      "Proved: {} inside the cells, by exact arithmetic, and all others are faces of the canonical "
      "decomposition.",
      proof.inside.size() == 1 ? std::string("1 face lies")
                               : fmt::format("{} faces lie", proof.inside.size()));
}

}  // namespace tripus::canonical
