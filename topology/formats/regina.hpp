#pragma once

#include <string>
#include <string_view>

#include "topology/formats/formats.hpp"

namespace tripus::topology {

/// Reads the first 3-manifold triangulation of an uncompressed Regina data file, of the third
/// generation (<tri dim="3">, Regina 7) or the second (<packet type="3-Manifold Triangulation">).
/// Throws InvalidInput naming the tetrahedron and what was expected.
/// Source: files written by Regina 7.3 in both formats.
NamedGluings read_regina_xml(std::string_view text);

/// Reads the gluing table that Regina prints (`detail()`): the rows under "Tet | glued to:", or
/// "Tet | face:", with entries like 1 (230) or "boundary".
/// Throws InvalidInput naming the line, tetrahedron and face.
NamedGluings read_regina_table(std::string_view text);

/// The table as Regina prints it. The name is not part of it.
std::string write_regina_table(const NamedGluings& triangulation);

}  // namespace tripus::topology
