#pragma once

#include <functional>
#include <optional>
#include <string>

#include "base/context.hpp"
#include "base/error.hpp"
#include "meshing/formats/read_mesh.hpp"
#include "topology/formats/formats.hpp"
#include "topology/requirements.hpp"

namespace tripus {

/// Reads an INPUT as typed: a file, `-` for standard input, an isomorphism signature with or
/// without a sign, or a name of the shipped census. A boundary is coned off, with a note. A surface
/// or a tetrahedral mesh becomes a small ideal triangulation of its solid (meshing::manifold_of);
/// of a ball, which has no boundary left when it is filled in, a triangulation with a finite
/// vertex. Throws InvalidInput if it is none of them or its content cannot be read; Stopped if a
/// stop is requested meanwhile. Reports its progress once the content has been read.
topology::NamedGluings load_input(const std::string& input, const Context& context = {});
/// The same with open faces left open.
topology::NamedGluings load_unconed_input(const std::string& input, const Context& context = {});
/// The same as a manifold, without finite vertices, be there a metric or not.
topology::NamedGluings load_manifold_input(const std::string& input, const Context& context = {});

/// Throws where there can be no metric; the program's own names a command that helps.
using Requirement = std::function<void(const topology::Triangulation&)>;

/// The same for what needs a metric: finite vertices are removed, with a note. Throws also, naming
/// the input, what
/// topology::require_solvable throws, and InvalidInput for a ball.
topology::NamedGluings load_solvable_input(const std::string& input, const Context& context = {},
                                           const Requirement& require = topology::require_solvable);

/// The surface or tetrahedral mesh in a file, or in standard input for `-`; nothing if the content
/// is a triangulation. Throws InvalidInput if the content cannot be read, or is neither.
std::optional<meshing::MeshFile> load_mesh(const std::string& input);

/// What to throw for a content in which nothing was recognised: says what was looked for.
InvalidInput unrecognised(const std::string& content);

/// The whole of a file, or of standard input for `-`.
/// Throws InvalidInput, naming the file and the system's reason.
std::string read_file(const std::string& path);

}  // namespace tripus
