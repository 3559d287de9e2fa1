#pragma once

#include <optional>
#include <string>

#include "topology/gluings.hpp"

namespace tripus::cli {

/// Throws InvalidInput unless the name of an output file tells a format: .json (gluing table), .sig
/// (signature), .rga (Regina) or .tri (SnapPea). To be asked before the work.
void require_triangulation_name(const std::string& path);

/// Writes the triangulation in the format that the name tells; `isosig` is its signature, if known.
/// Throws InvalidInput if the file cannot be written, or if the signature is wanted and not known.
void write_triangulation_file(const std::string& path, const std::string& name,
                              const topology::Gluings& gluings,
                              const std::optional<std::string>& isosig);

}  // namespace tripus::cli
