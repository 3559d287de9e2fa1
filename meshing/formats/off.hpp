#pragma once

#include <string>
#include <string_view>

#include "meshing/formats/read_mesh.hpp"

namespace tripus::meshing {

/// Geomview's OFF, read by tokens as Geomview does, whatever the lines: optional braces, with how
/// it looks, a header of [ST][C][N][4][n]OFF that may touch the first count or be left out, counts,
/// points, faces, each with colours up to the end of its line. Also what other programs write: no
/// number of edges, colours of another number of columns behind the points, polygons, and the
/// binary form. Normals, colours and textures are skipped. Throws InvalidInput with the line or
/// byte.
SurfaceFile read_off(std::string_view text);

/// Whether a text begins as OFF does; a lone word is rather a signature. Numbers without the header
/// are OFF only by the name of their file.
bool starts_off(std::string_view content, bool by_name = false);

/// OFF with coordinates that read back to the same doubles.
std::string write_off(const SurfaceMesh& mesh);

}  // namespace tripus::meshing
