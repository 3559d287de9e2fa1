#include "meshing/formats/write_surface.hpp"

#include <array>

#include "base/error.hpp"
#include "meshing/detail/text.hpp"
#include "meshing/formats/formats.hpp"

namespace tripus::meshing {

std::span<const SurfaceFormat> surface_formats() {
  static constexpr std::array<SurfaceFormat, 4> kFormats{{
      {".off", "Geomview's OFF", write_off},
      {".obj", "Wavefront OBJ", write_obj},
      {".ply", "binary PLY", write_ply},
      {".stl", "binary STL, in single precision", write_stl},
  }};
  return kFormats;
}

const SurfaceFormat& surface_format_of(std::string_view name) {
  const std::string low = detail::lowered(name);
  std::string known;
  for (const SurfaceFormat& format : surface_formats()) {
    if (low.ends_with(format.ending)) return format;
    known += (known.empty() ? "" : ", ") + std::string(format.ending);
  }
  throw InvalidInput(quoted(std::string(name)) + ": the name must end with one of " + known);
}

}  // namespace tripus::meshing
