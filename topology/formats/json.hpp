#pragma once

#include <string>
#include <string_view>

#include "topology/formats/formats.hpp"

namespace tripus::topology {

/// Reads {"name": ..., "gluings": [[[1, "1230"], ...4 faces...], ...T tetrahedra...]}: for each
/// tetrahedron, for its faces 0..3, the other tetrahedron and the permutation p(0)p(1)p(2)p(3);
/// null for an open face. Other keys are ignored.
/// Throws InvalidInput naming tetrahedron and face, or the byte where the JSON breaks off.
NamedGluings read_json(std::string_view text);

/// One line, the inverse of read_json.
std::string write_json(const NamedGluings& triangulation);

}  // namespace tripus::topology
