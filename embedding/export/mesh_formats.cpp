#include "embedding/export/mesh_formats.hpp"

#include <array>

namespace tripus::embedding {

std::span<const CellFormat> mesh_formats() {
  static constexpr std::array<CellFormat, 8> formats{{
      {"obj", "Wavefront OBJ: a group for each cell", write_obj},
      {"ply", "binary PLY: colour, cell and tetrahedron of each point", write_ply},
      {"off", "Geomview's OFF", write_off},
      {"stl", "binary STL, in single precision", write_stl},
      {"glb", "glTF 2.0, binary: a mesh and a colour for each tetrahedron", write_glb},
      {"gltf", "the same as text", write_gltf},
      {"float.vtk", "as .vtk, but in single precision", write_float_vtk},
      {"vtk", "binary VTK legacy PolyData with cell data, for ParaView", write_vtk},
  }};
  return formats;
}

}  // namespace tripus::embedding
