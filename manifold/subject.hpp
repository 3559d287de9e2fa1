#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/context.hpp"
#include "manifold/json_text.hpp"
#include "manifold/load.hpp"
#include "topology/cone_angle.hpp"
#include "topology/triangulation.hpp"

namespace tripus {

/// A triangulation as it was received.
struct Subject {
  std::string input;  ///< as typed
  std::string name;   ///< from the file, may be empty
  topology::Triangulation triangulation;
  std::optional<std::string> isosig;                  ///< nothing where it would take too long
  std::vector<topology::ConeAngle> cone_angles = {};  ///< [E]; empty if nothing is labelled
  /// The signature with its sign; nothing where the orientation is not known, and for
  /// triangulations that are not connected or not orientable.
  std::optional<std::string> oriented_isosig = {};
  /// False if the INPUT says nothing about the orientation: a signature without a sign.
  bool orientation_known = true;
  std::vector<std::string> notes = {};  ///< what was changed in reading the INPUT

  /// The signature with its sign where there is one.
  const std::optional<std::string>& best_signature() const {
    return oriented_isosig ? oriented_isosig : isosig;
  }
};

/// Faces visited before the search for a signature is given up: some tenths of a second.
inline constexpr std::size_t kSignatureWorkLimit = 20'000'000;

/// Loads an INPUT (load_input) and computes its signature.
Subject load_subject(const std::string& input, const Context& context = {});
/// The same for what needs a metric; see load_solvable_input.
Subject load_solvable_subject(const std::string& input, const Context& context = {},
                              const Requirement& require = topology::require_geodesic_boundary);
/// The same without finite vertices; see load_manifold_input.
Subject load_manifold_subject(const std::string& input, const Context& context = {});
/// The same with the labels, for what knows them: those of the file, or behind the INPUT on a line
/// of a batch ("eLAkbbcddpuchf 0=7,1=2"). Vertices of every kind.
Subject load_labelled_subject(const std::string& input, Balls balls, const Context& context = {});
/// The same with finite vertices removed where nothing is labelled, which the context is told;
/// `require` is given what is left, and what it throws names the input.
using LabelledRequirement = std::function<void(const topology::Triangulation& triangulation,
                                               std::span<const topology::ConeAngle> cone_angles)>;
Subject load_ideal_subject(const std::string& input, Balls balls, const Context& context,
                           const LabelledRequirement& require);
/// The same for gluings that are already there.
Subject make_subject(std::string input, topology::NamedGluings loaded);
/// The same for another triangulation of the subject's manifold, with its name and notes; its
/// orientation is known if that of the subject is.
Subject make_subject(const Subject& subject, topology::Gluings gluings);

/// The kind of a vertex link without cone points in a word: geodesic, cusp or finite.
std::string_view link_kind(const topology::VertexLink& link);

/// The keys that `info` and `solve` share: name, isosig, counts, orientable, edge_valences; and
/// notes where there are any.
void append_subject(JsonText& out, const Subject& subject);

/// , "oriented_isosig": the signature with its sign, or null.
void append_oriented(JsonText& out, const Subject& subject);

/// , "vertices": [...]: the links by vertex class.
void append_vertices(JsonText& out, const topology::Triangulation& triangulation);

/// , "cone_orders": [...], only if it is labelled: numbers, or strings for fractions.
void append_cone_orders(JsonText& out, const Subject& subject);

/// "edge_classes": [[6] per tetrahedron].
void append_edge_classes(JsonText& out, const topology::Triangulation& triangulation);

}  // namespace tripus
