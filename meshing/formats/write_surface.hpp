#pragma once

#include <span>
#include <string>
#include <string_view>

#include "meshing/surface_mesh.hpp"

namespace tripus::meshing {

struct SurfaceFormat {
  std::string_view ending;   ///< ".off"
  std::string_view summary;  ///< one line for people
  std::string (*write)(const SurfaceMesh& mesh);
};

/// Every format that surfaces are written in. To add one: a line in write_surface.cpp.
std::span<const SurfaceFormat> surface_formats();

/// The format that the name of a file tells, in any case of the letters.
/// Throws InvalidInput, naming the endings that there are.
const SurfaceFormat& surface_format_of(std::string_view name);

}  // namespace tripus::meshing
