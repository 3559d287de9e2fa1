#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "meshing/surface_mesh.hpp"
#include "meshing/tetrahedral_mesh.hpp"

namespace tripus::meshing {

struct SurfaceFile {
  SurfaceMesh mesh;
  SourceLines lines;
};

struct TetrahedralFile {
  TetrahedralMesh mesh;
  SourceLines lines;
};

}  // namespace tripus::meshing
