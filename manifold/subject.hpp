#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/context.hpp"
#include "manifold/json_text.hpp"
#include "topology/triangulation.hpp"

namespace tripus {

/// A triangulation as it was received.
struct Subject {
  std::string input;  ///< as typed
  std::string name;   ///< from the file, may be empty
  topology::Triangulation triangulation;
  std::optional<std::string> isosig;  ///< nothing where it would take too long
};

/// Faces visited before the search for a signature is given up: some tenths of a second.
inline constexpr std::size_t kSignatureWorkLimit = 20'000'000;

/// Loads an INPUT (load_input) and computes its signature.
Subject load_subject(const std::string& input, const Context& context = {});
/// The same for what needs a metric; see load_solvable_input.
Subject load_solvable_subject(const std::string& input, const Context& context = {});
/// The same for gluings that are already there.
Subject make_subject(std::string input, std::string name, topology::Gluings gluings);

/// The kind of a vertex link in a word: geodesic, cusp, finite, or unsupported.
std::string_view link_kind(const topology::VertexLink& link);

/// The keys that `info` and `solve` share: name, isosig, counts, orientable, edge_valences.
void append_subject(JsonText& out, const Subject& subject);

/// , "vertices": [...]: the links by vertex class.
void append_vertices(JsonText& out, const topology::Triangulation& triangulation);

/// "edge_classes": [[6] per tetrahedron].
void append_edge_classes(JsonText& out, const topology::Triangulation& triangulation);

}  // namespace tripus
