#pragma once

#include <iosfwd>
#include <span>
#include <string_view>

#include "embedding/tessellate.hpp"

/// Writers of tessellated cells. Each cell is a closed surface of its own; which cell, tetrahedron
/// and side a triangle belongs to, and the colour of its cell, are written as the format allows.
namespace tripus::embedding {

/// Writes all cells of a tessellation, or the first of them if a stop was requested, one at least,
/// and returns how many; a failed write leaves the stream's error state.
using WriteMesh = std::size_t (*)(std::ostream& out, const Tessellation& tessellation);

struct CellFormat {
  std::string_view extension;  ///< "obj"; the first in the table that a name ends with is meant
  std::string_view summary;    ///< one line for people
  WriteMesh write;
};

/// Every format. To add one: a file beside the others and a line in mesh_formats.cpp.
std::span<const CellFormat> mesh_formats();

/// More triangles than this are refused: several gigabytes.
inline constexpr std::size_t kMostTriangles = 100'000'000;

/// Wavefront OBJ: a group for each cell, "cell_C_tetrahedron_T".
std::size_t write_obj(std::ostream& out, const Tessellation& tessellation);

/// PLY, binary little-endian. Vertices: x y z (double), red, green, blue (uchar), cell, tetrahedron
/// (int). Faces: vertex_indices. Its header counts, so it is written to the end.
std::size_t write_ply(std::ostream& out, const Tessellation& tessellation);

/// OFF, without colours. It counts, so it is written to the end.
std::size_t write_off(std::ostream& out, const Tessellation& tessellation);

/// STL, binary; coordinates in single precision. It counts, so it is written to the end.
std::size_t write_stl(std::ostream& out, const Tessellation& tessellation);

/// glTF 2.0, as text with its numbers in base64, and as one binary file: a mesh for each
/// tetrahedron with all its cells, in its colour; coordinates in single precision. Held in memory,
/// and written to the end.
std::size_t write_gltf(std::ostream& out, const Tessellation& tessellation);
std::size_t write_glb(std::ostream& out, const Tessellation& tessellation);

/// VTK legacy PolyData, binary, with the cell data `cell`, `tetrahedron`, `depth`, `side` (int) and
/// `colour` (red, green, blue). It counts, so it is written to the end.
std::size_t write_vtk(std::ostream& out, const Tessellation& tessellation);
/// The same with coordinates in single precision.
std::size_t write_float_vtk(std::ostream& out, const Tessellation& tessellation);

}  // namespace tripus::embedding
