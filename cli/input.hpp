#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "meshing/formats/read_mesh.hpp"
#include "topology/formats/formats.hpp"

namespace tripus::cli {

/// Whether cone angles that a file gives are wanted.
enum class Labels { kRefused, kKept };

/// Reads an INPUT as typed: a file, `-` for standard input, or an isomorphism signature. A surface
/// or a tetrahedral mesh becomes a small ideal triangulation of its solid (meshing::manifold_of);
/// of a ball, which has no boundary left when it is filled in, a triangulation with a finite
/// vertex. Throws InvalidInput if it is none of them or its content cannot be read;
/// meshing::Stopped if interrupted.
/// With Labels::kRefused, throws Unsupported for a file with cone angles other than 2 pi.
topology::NamedGluings load_input(const std::string& input, Labels labels = Labels::kRefused);
/// The same for what needs a metric with geodesic boundary. Throws also, naming the input, what
/// topology::require_geodesic_boundary throws, and InvalidInput for a ball.
topology::NamedGluings load_solvable_input(const std::string& input);
/// For `solve`, which knows labels and vertices of every kind: throws InvalidInput for a ball.
topology::NamedGluings load_labelled_input(const std::string& input);

/// The surface or tetrahedral mesh in a file, or in standard input for `-`; nothing if the content
/// has no mesh format. Throws InvalidInput if the content cannot be read.
std::optional<meshing::MeshFile> load_mesh(const std::string& input);

/// The whole of a file, or of standard input for `-`.
/// Throws InvalidInput, naming the file and the system's reason.
std::string read_file(const std::string& path);

}  // namespace tripus::cli
