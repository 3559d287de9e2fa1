#pragma once

#include <string_view>

#include "topology/formats/formats.hpp"

namespace tripus::topology {

/// Reads an isomorphism signature with what programs put behind it: SnapPy's decoration, from "_"
/// on (cPcbbbiht_BaCB), and Regina's locks, from "." on (cPcbbbihq.qa), which are skipped; Dehn
/// fillings as in cPcbbbiht_BaCB(1,2) are refused unless they are all (0,0). Throws what
/// decode_isosig throws; Unsupported for fillings.
NamedGluings read_signature(std::string_view text);

/// Whether a text, but for white space around it, looks like that.
bool looks_like_signature(std::string_view text);

}  // namespace tripus::topology
