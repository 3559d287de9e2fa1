#pragma once

#include <optional>
#include <string>

#include "cli/json.hpp"
#include "structure/report.hpp"
#include "topology/formats/formats.hpp"
#include "topology/triangulation.hpp"

namespace tripus::cli {

/// A triangulation as the program received it.
struct Subject {
  std::string input;  ///< as typed
  std::string name;   ///< from the file, may be empty
  topology::Triangulation triangulation;
  std::optional<std::string> isosig;  ///< nothing where it would take too long
  /// The signature with its sign; nothing where the orientation is not known, and for triangulations
  /// that are not connected or not orientable.
  std::optional<std::string> oriented_isosig = {};
  /// False if the INPUT says nothing about the orientation: a signature without a sign.
  bool orientation_known = true;
  std::vector<std::string> notes = {};  ///< what was changed in reading the INPUT

  /// The signature with its sign where there is one.
  const std::optional<std::string>& best_signature() const {
    return oriented_isosig ? oriented_isosig : isosig;
  }
};

/// Loads an INPUT and computes its signature.
Subject load_subject(const std::string& input);
/// The same without finite vertices; see load_manifold_input.
Subject load_manifold_subject(const std::string& input);
/// The same for what needs a metric; see load_solvable_input.
Subject load_solvable_subject(const std::string& input);
/// The same for gluings that are already there.
Subject make_subject(std::string input, topology::NamedGluings loaded);
/// The same for another triangulation of the subject's manifold, with its name and notes; its
/// orientation is known if that of the subject is.
Subject make_subject(const Subject& subject, topology::Gluings gluings);

/// Text from outside made fit for a terminal: control characters as \xHH, all else as it is.
std::string printable(std::string_view text);

/// The signature for people: of a large triangulation its beginning and length, --json has it
/// whole.
std::string signature_text(const std::optional<std::string>& isosig);

/// "1 edge class", "2 edge classes".
std::string counted(std::size_t count, std::string_view one, std::string_view many);

/// The kind of a vertex link in a word: geodesic, cusp, finite, or unsupported.
std::string_view link_kind(const topology::VertexLink& link);

/// Why `solve` would refuse it; empty if it would not.
std::string objection_to(const topology::Triangulation& triangulation);

/// The keys that `info` and `solve` share: name, isosig, counts, orientable, edge_valences; and notes
/// where there are any.
void append_subject(JsonText& out, const Subject& subject);

/// , "oriented_isosig": the signature with its sign, or null.
void append_oriented(JsonText& out, const Subject& subject);

/// , "vertices": [...]: the links by vertex class.
void append_vertices(JsonText& out, const topology::Triangulation& triangulation);

/// "edge_classes": [[6] per tetrahedron].
void append_edge_classes(JsonText& out, const topology::Triangulation& triangulation);

/// One line for people: "2 tetrahedra, 1 edge class (valence 12), orientable, boundary of genus 2".
std::string one_line(const topology::Triangulation& triangulation);

/// A list of numbers for people, shortened in the middle of the long ones.
std::string shortened(const std::vector<std::string>& items, std::size_t limit = 12);

}  // namespace tripus::cli
