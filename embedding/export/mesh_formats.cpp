#include "embedding/export/mesh_formats.hpp"

#include <array>

namespace tripus::embedding {

std::span<const MeshFormat> mesh_formats() {
  static constexpr std::array<MeshFormat, 3> formats{{
      {"obj", "Wavefront OBJ: a group for each cell, vertex colours", write_obj},
      {"ply", "binary PLY: cell, tetrahedron, side and colour of each triangle", write_ply},
      {"vtk", "binary VTK legacy PolyData with cell data, for ParaView", write_vtk},
  }};
  return formats;
}

}  // namespace tripus::embedding
