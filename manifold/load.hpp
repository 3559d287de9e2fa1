#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/context.hpp"
#include "base/error.hpp"
#include "meshing/formats/read_mesh.hpp"
#include "topology/formats/formats.hpp"
#include "topology/requirements.hpp"

namespace tripus {

/// Reads an INPUT as typed: a file, FILE#LABEL for one of the triangulations in a Regina data file,
/// `-` for standard input, an isomorphism signature with or without a sign, or a name of the
/// shipped census. A boundary is coned off. What of a file is not read, or was mended or changed,
/// the context is told as notes. A surface or a tetrahedral mesh becomes a small ideal
/// triangulation of its solid (meshing::manifold_of); of a ball, which has no boundary left when it
/// is filled in, a triangulation with a finite vertex. Throws InvalidInput if it is none of them or
/// its content cannot be read; Stopped if a stop is requested meanwhile; Unsupported for a file
/// with cone angles other than 2 pi. Reports its progress once the content has been read.
topology::NamedGluings load_input(const std::string& input, const Context& context = {});
/// The same with open faces left open.
topology::NamedGluings load_unconed_input(const std::string& input, const Context& context = {});
/// The same as a manifold, without finite vertices, be there a metric or not.
topology::NamedGluings load_manifold_input(const std::string& input, const Context& context = {});

/// Throws where there can be no metric; the program's own names a command that helps.
using Requirement = std::function<void(const topology::Triangulation&)>;

/// The same for what needs a metric with geodesic boundary: finite vertices are removed. Throws
/// also, naming the input, what topology::require_geodesic_boundary throws, and InvalidInput for a
/// ball.
topology::NamedGluings load_solvable_input(
    const std::string& input, const Context& context = {},
    const Requirement& require = topology::require_geodesic_boundary);
/// Whether a surface that bounds a ball is let through: there is a triangulation, but no metric.
enum class Balls { kAllowed, kRefused };
/// The same with the cone angles of a file, for what knows them and vertices of every kind: of the
/// above it throws only InvalidInput for a ball, and that only if balls are refused.
topology::NamedGluings load_labelled_input(const std::string& input, Balls balls,
                                           const Context& context = {});

/// The surface or tetrahedral mesh in a file, or in standard input for `-`.
/// Throws InvalidInput if the content has no mesh format or cannot be read.
meshing::MeshFile load_mesh(const std::string& input);

/// The lines of a batch file; of a Regina data file FILE#LABEL for each of its triangulations.
std::vector<topology::BatchLine> read_batch_file(const std::string& path);

/// The whole of a file, or of standard input for `-`, decompressed if it is gzip's.
/// Throws InvalidInput, naming the file and the system's reason.
std::string read_file(const std::string& path);

}  // namespace tripus
