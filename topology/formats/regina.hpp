#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "topology/formats/formats.hpp"

namespace tripus::topology {

/// Reads all 3-manifold triangulations of an uncompressed Regina data file, in their order: of the
/// third generation (<tri dim="3">, Regina 7), the second (<packet type="3-Manifold
/// Triangulation">, in Regina 3 and 4 "Triangulation"), and SnapPea triangulations in either. Locks
/// and descriptions are skipped. Throws InvalidInput naming the tetrahedron and what was expected,
/// or the byte where the XML breaks off; if there is none; Unsupported for Dehn fillings. Source:
/// files written by Regina 4.5, 7.3 and 7.4.1.
std::vector<NamedGluings> read_regina_xml(std::string_view text);

/// Whether the first element of an XML text is one of Regina's.
bool starts_regina_xml(std::string_view text);

/// A data file of the third generation, uncompressed, with one triangulation.
std::string write_regina_xml(const NamedGluings& triangulation);

/// Reads the gluing table that Regina prints (`detail()`): the rows under "Tet | glued to:", "Tet |
/// gluing:" (7.4), or "Tet | face:", with entries like 1 (230) or "boundary". Throws InvalidInput
/// naming the line, tetrahedron and face.
NamedGluings read_regina_table(std::string_view text);

/// The table as Regina prints it. The name is not part of it.
std::string write_regina_table(const NamedGluings& triangulation);

}  // namespace tripus::topology
