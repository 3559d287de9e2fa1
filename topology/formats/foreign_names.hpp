#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tripus::topology {

/// What a text is that names a manifold in the tables of another program (SnapPy's `m004`, `L5a1`,
/// `8_19`, `o9_00001`), and how to get its signature, in a sentence; nothing if it is no such name.
std::optional<std::string> foreign_name(std::string_view text);

}  // namespace tripus::topology
