#include "topology/labelled_isosig.hpp"

#include <algorithm>
#include <tuple>

#include "topology/orientation.hpp"

namespace tripus::topology {
namespace {

bool is_less(const ConeAngle& a, const ConeAngle& b) {
  const auto key = [](const ConeAngle& k) {
    return std::tuple(k.is_rational(), k.radians(), k.numerator(), k.denominator());
  };
  return key(a) < key(b);
}

/// Of the isomorphisms from a triangulation to another those that `admits`, and of these the one
/// that makes the labels least. There is one.
template <class Admits>
std::pair<Isomorphism, std::vector<ConeAngle>> least(const Triangulation& from,
                                                     std::span<const ConeAngle> labels,
                                                     const Triangulation& to, Admits admits) {
  std::pair<Isomorphism, std::vector<ConeAngle>> best;
  for (Isomorphism& candidate : all_isomorphisms(from.gluings(), to.gluings())) {
    if (!admits(candidate)) continue;
    auto carried = relabelled_edges(from, labels, candidate, to);
    if (best.second.empty() || std::ranges::lexicographical_compare(carried, best.second, is_less))
      best = {std::move(candidate), std::move(carried)};
  }
  return best;
}

std::string with_labels(const std::string& isosig, std::span<const ConeAngle> labels) {
  return all_full(labels) ? isosig : isosig + " " + labels_text(labels);
}

/// Whether an isomorphism keeps the orientations that the labels 0123 of tetrahedron 0 give, in
/// both triangulations.
bool keeps_orientation(const Isomorphism& isomorphism, const std::vector<char>& disagreeing_to) {
  return isomorphism.perms[0].is_odd() == (disagreeing_to[isomorphism.tetrahedron_images[0]] != 0);
}

}  // namespace

std::vector<std::size_t> edge_images(const Triangulation& from, const Isomorphism& isomorphism,
                                     const Triangulation& to) {
  std::vector<std::size_t> images;
  for (std::size_t e = 0; e < from.edge_count(); ++e) {
    const EdgeCorner corner = from.corners(e)[0];
    const Perm4 p = isomorphism.perms[corner.tetrahedron()];
    const auto ends = kEdgeEnds[static_cast<std::size_t>(corner.edge())];
    const int edge =
        kEdgeNumber[static_cast<std::size_t>(p(ends[0]))][static_cast<std::size_t>(p(ends[1]))];
    images.push_back(to.edge_class(isomorphism.tetrahedron_images[corner.tetrahedron()], edge));
  }
  return images;
}

std::vector<ConeAngle> relabelled_edges(const Triangulation& from,
                                        std::span<const ConeAngle> labels,
                                        const Isomorphism& isomorphism, const Triangulation& to) {
  std::vector<ConeAngle> result(to.edge_count());
  const auto images = edge_images(from, isomorphism, to);
  for (std::size_t e = 0; e < labels.size(); ++e) result[images[e]] = labels[e];
  return result;
}

std::vector<ConeAngle> oriented_edges(const Triangulation& triangulation,
                                      std::span<const ConeAngle> labels,
                                      const Triangulation& turned) {
  const auto disagreeing = disagreeing_labels(triangulation.gluings());
  if (labels.empty() || !disagreeing) return {labels.begin(), labels.end()};
  Isomorphism in_place;
  for (std::size_t t = 0; t < disagreeing->size(); ++t) {
    in_place.tetrahedron_images.push_back(static_cast<TetrahedronIndex>(t));
    // As `oriented` does.
    in_place.perms.push_back((*disagreeing)[t] ? Perm4::from_images(0, 1, 3, 2) : Perm4());
  }
  return relabelled_edges(triangulation, labels, in_place, turned);
}

LabelledSignature labelled_signature(const Triangulation& triangulation,
                                     std::span<const ConeAngle> labels) {
  CanonicalLabelling canonical = canonical_labelling(triangulation.gluings());
  if (all_full(labels))
    return {canonical.signature, canonical.signature, {}, std::move(canonical.isomorphism)};
  const std::vector<ConeAngle> whole = completed(labels, triangulation.edge_count());
  const Triangulation decoded(decode_isosig(canonical.signature));
  auto [isomorphism, carried] =
      least(triangulation, whole, decoded, [](const Isomorphism&) { return true; });
  return {with_labels(canonical.signature, carried), canonical.signature, std::move(carried),
          std::move(isomorphism)};
}

std::string labelled_isosig(const Triangulation& triangulation, std::span<const ConeAngle> labels) {
  if (all_full(labels)) return isosig(triangulation.gluings());
  return labelled_signature(triangulation, labels).text;
}

std::string oriented_labelled_isosig(const Triangulation& triangulation,
                                     std::span<const ConeAngle> labels) {
  if (all_full(labels)) return full_isosig(triangulation.gluings()).oriented();
  const LabelledSignature plain = labelled_signature(triangulation, labels);
  const Triangulation decoded(decode_isosig(plain.isosig));
  const auto disagreeing = disagreeing_labels(decoded.gluings());
  if (!disagreeing) return plain.text;
  bool keeps = false, reverses = false;
  for (const Isomorphism& candidate :
       all_isomorphisms(triangulation.gluings(), decoded.gluings())) {
    if (relabelled_edges(triangulation, labels, candidate, decoded) != plain.labels) continue;
    (keeps_orientation(candidate, *disagreeing) ? keeps : reverses) = true;
  }
  return keeps && reverses ? plain.text : with_sign(plain, keeps ? '+' : '-');
}

std::string with_sign(const LabelledSignature& signature, char sign) {
  const std::string text = signature.isosig + sign;
  if (all_full(signature.labels)) return text;
  const Triangulation from(decode_isosig(signature.isosig)), to(decode_isosig(text));
  const std::vector<char> none_disagrees(to.tetrahedron_count());
  const auto [isomorphism, carried] =
      least(from, signature.labels, to, [&](const Isomorphism& candidate) {
        return keeps_orientation(candidate, none_disagrees) == (sign == '+');
      });
  return with_labels(text, carried);
}

std::string labels_text(std::span<const ConeAngle> labels) {
  std::string text;
  for (std::size_t e = 0; e < labels.size(); ++e) {
    if (labels[e].is_full()) continue;
    if (!text.empty()) text += ',';
    text += std::to_string(e) + "=" + labels[e].order_text();
  }
  return text;
}

}  // namespace tripus::topology
