#pragma once

#include <optional>
#include <span>
#include <string>

#include "cli/json.hpp"
#include "structure/report.hpp"
#include "topology/cone_angle.hpp"
#include "topology/triangulation.hpp"

namespace tripus::cli {

/// A triangulation as the program received it.
struct Subject {
  std::string input;  ///< as typed
  std::string name;   ///< from the file, may be empty
  topology::Triangulation triangulation;
  std::optional<std::string> isosig;                  ///< nothing where it would take too long
  std::vector<topology::ConeAngle> cone_angles = {};  ///< [E]; empty if nothing is labelled
};

/// Loads an INPUT and computes its signature.
Subject load_subject(const std::string& input);
/// The same for what needs a metric with geodesic boundary; see load_solvable_input.
Subject load_solvable_subject(const std::string& input);
/// The same with the labels, for what knows them: those of the file, or behind the INPUT on a line
/// of a batch ("eLAkbbcddpuchf 0=7,1=2"). Vertices of every kind.
Subject load_labelled_subject(const std::string& input);
/// The same for gluings that are already there.
Subject make_subject(std::string input, std::string name, topology::Gluings gluings);

/// Text from outside made fit for a terminal: control characters as \xHH, all else as it is.
std::string printable(std::string_view text);

/// The signature for people: of a large triangulation its beginning and length, --json has it
/// whole.
std::string signature_text(const Subject& subject);

/// "1 edge class", "2 edge classes".
std::string counted(std::size_t count, std::string_view one, std::string_view many);

/// The kind of a vertex link without cone points in a word: geodesic, cusp or finite.
std::string_view link_kind(const topology::VertexLink& link);

/// Why `solve` would refuse it with these cone angles; empty if it would not.
std::string objection_to(const topology::Triangulation& triangulation,
                         std::span<const topology::ConeAngle> cone_angles = {});

/// Changes cone angles [E] by assignments "EDGE=ORDER" or, if they are angles, "EDGE=ANGLE", with
/// commas between several. An empty list stands for 2 pi everywhere, and stays if nothing changes.
/// Throws InvalidInput, naming the option, the assignment and the remedy; also for two on one edge.
void assign_cone_angles(std::vector<topology::ConeAngle>& cone_angles, std::size_t edge_count,
                        std::span<const std::string> orders, std::span<const std::string> angles);

/// The keys that `info` and `solve` share: name, isosig, counts, orientable, edge_valences.
void append_subject(JsonText& out, const Subject& subject);

/// , "vertices": [...]: the links by vertex class.
void append_vertices(JsonText& out, const topology::Triangulation& triangulation);

/// , "cone_orders": [...], only if the triangulation is labelled: numbers, or strings for
/// fractions.
void append_cone_orders(JsonText& out, const Subject& subject);

/// "edge_classes": [[6] per tetrahedron].
void append_edge_classes(JsonText& out, const topology::Triangulation& triangulation);

/// One line for people: "2 tetrahedra, 1 edge class (valence 12), orientable, boundary of genus 2".
std::string one_line(const topology::Triangulation& triangulation);

/// A list of numbers for people, shortened in the middle of the long ones.
std::string shortened(const std::vector<std::string>& items, std::size_t limit = 12);

}  // namespace tripus::cli
