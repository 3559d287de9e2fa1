#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tripus::meshing {

/// What a content is that holds a mesh in a format which is not read (glTF, 3MF, COLLADA, ...), and
/// how to bring it into one that is, in a sentence; nothing if it is none of those known by a mark.
std::optional<std::string> foreign_mesh(std::string_view content);

}  // namespace tripus::meshing
