#pragma once

#include <span>
#include <string>
#include <vector>

#include "topology/cone_angle.hpp"
#include "topology/isosig.hpp"
#include "topology/triangulation.hpp"

namespace tripus::topology {

/// [E] the edge class of `to` to which an isomorphism carries each of `from`.
std::vector<std::size_t> edge_images(const Triangulation& from, const Isomorphism& isomorphism,
                                     const Triangulation& to);

/// The labels [E] of a triangulation's edge classes carried to another one by an isomorphism from
/// the first to the second.
std::vector<ConeAngle> relabelled_edges(const Triangulation& from,
                                        std::span<const ConeAngle> labels,
                                        const Isomorphism& isomorphism, const Triangulation& to);

/// Labels [E] of a triangulation as those of `turned`, of its gluings made `oriented`.
std::vector<ConeAngle> oriented_edges(const Triangulation& triangulation,
                                      std::span<const ConeAngle> labels,
                                      const Triangulation& turned);

/// A labelled triangulation in its canonical labelling.
struct LabelledSignature {
  std::string text;               ///< see labelled_isosig
  std::string isosig;             ///< the part of it before the labels
  std::vector<ConeAngle> labels;  ///< [E] of decode_isosig(isosig); empty if there are none
  Isomorphism isomorphism;        ///< carries the triangulation and its labels there
};

/// The isomorphism signature with the labels of the edge classes of the triangulation that it
/// decodes to: "cPcbbbiht 0=2,1=3", as an INPUT of the program is written. Of the automorphisms of
/// that triangulation one is taken that makes the list of labels least, so that two labelled
/// triangulations have the same text exactly when an isomorphism carries one to the other, labels
/// included. Without labels it is `isosig`. Cost: that of `canonical_labelling` and of
/// `all_isomorphisms`.
///   labels  [E]; empty for none
/// Throws InvalidInput if the triangulation is not connected and has labels, and as `completed`.
LabelledSignature labelled_signature(const Triangulation& triangulation,
                                     std::span<const ConeAngle> labels);
std::string labelled_isosig(const Triangulation& triangulation, std::span<const ConeAngle> labels);

/// The same with its sign, in front of the labels: "cPcbbbihq- 0=3". The labels are those of the
/// triangulation that `decode_isosig` makes of the text before them. No sign where there is no
/// orientation, or where an automorphism that keeps the labels reverses it.
std::string oriented_labelled_isosig(const Triangulation& triangulation,
                                     std::span<const ConeAngle> labels);

/// A labelled signature with a sign that is known: '+' if the manifold meant has the orientation of
/// decode_isosig(signature.isosig), '-' if it has the other one.
std::string with_sign(const LabelledSignature& signature, char sign);

/// "0=2,3=5/2": the labels other than 2 pi by edge class, as cone orders.
std::string labels_text(std::span<const ConeAngle> labels);

}  // namespace tripus::topology
