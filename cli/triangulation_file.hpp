#pragma once

#include <span>
#include <string>

#include "manifold/subject.hpp"
#include "topology/cone_angle.hpp"

namespace tripus::cli {

/// Throws InvalidInput unless the name of an output file tells a format: .json (gluing table), .sig
/// (signature), .rga (Regina) or .tri (SnapPea). To be asked before the work.
void require_triangulation_name(const std::string& path);

/// Throws InvalidInput if there are cone angles and the format does not keep them: .json does.
void require_format_for(const std::string& path, std::span<const topology::ConeAngle> cone_angles);

/// Writes the triangulation in the format that the name tells, with a note on standard error where
/// it is a signature that tells no orientation. Throws InvalidInput if the file cannot be written,
/// or if the signature is wanted and not known, and as `require_format_for`.
void write_triangulation_file(const std::string& path, const Subject& subject);

}  // namespace tripus::cli
