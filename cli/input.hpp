#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "meshing/formats/read_mesh.hpp"
#include "topology/formats/formats.hpp"

namespace tripus::cli {

/// Reads an INPUT as typed: a file, `-` for standard input, or an isomorphism signature. A surface
/// or a tetrahedral mesh becomes a small ideal triangulation of its solid (meshing::manifold_of).
/// Throws InvalidInput if it is none of them, its content cannot be read, or the solid is a ball;
/// meshing::Stopped if interrupted.
topology::NamedGluings load_input(const std::string& input);

/// The surface or tetrahedral mesh in a file, or in standard input for `-`; nothing if the content
/// has no mesh format. Throws InvalidInput if the content cannot be read.
std::optional<meshing::MeshFile> load_mesh(const std::string& input);

/// The whole of a file, or of standard input for `-`.
/// Throws InvalidInput, naming the file and the system's reason.
std::string read_file(const std::string& path);

}  // namespace tripus::cli
