#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "meshing/formats/read_mesh.hpp"

namespace tripus::meshing {

/// Gmsh's .msh of the versions 2 and 4.1, text or binary: a tetrahedral mesh if it has tetrahedra,
/// else a surface of triangles and quadrilaterals. Curved cells count by their corners; points and
/// lines, physical groups, entities and data are skipped; hexahedra, prisms and pyramids are
/// refused. Throws InvalidInput with the line or byte.
MeshFile read_gmsh(std::string_view text);

/// Version 2.2, text, which everything reads.
std::string write_gmsh(const TetrahedralMesh& mesh);

/// Medit's .mesh, as text: a tetrahedral mesh if it has tetrahedra, else a surface of triangles and
/// quadrilaterals. Other sections and all reference numbers are skipped; hexahedra and prisms are
/// refused. Throws InvalidInput with the line.
MeshFile read_medit(std::string_view text);

/// With the triangles of the boundary, which TetGen and others expect.
std::string write_medit(const TetrahedralMesh& mesh);

/// Wavefront OBJ: v and f lines, which "\\" continues; negative (relative) indices are understood.
/// Normals, colours, textures, groups, materials, lines, points and the commands of renderers are
/// skipped; curves and curved surfaces are refused.
/// Throws InvalidInput with the line or byte.
SurfaceFile read_obj(std::string_view text);

/// Whether the first line that says something is one of a face, a point or what may come before.
bool starts_obj(std::string_view content);

std::string write_obj(const SurfaceMesh& mesh);

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

/// PLY, text or binary of either byte order. Only x, y, z of "vertex", the index lists of "face"
/// and "tristrips" are used; other properties and elements are skipped. Throws InvalidInput with
/// the line or byte.
SurfaceFile read_ply(std::string_view text);

/// Binary, little-endian, with coordinates in double precision.
std::string write_ply(const SurfaceMesh& mesh);

/// STL, text (in any case of the letters, "end loop" as well as "endloop") or binary (with bytes
/// after the last triangle, or a count of 0 that the length of the file corrects). The format
/// repeats every corner; corners with equal coordinates become one point, in the order in which
/// they first appear. Normals and colours are skipped.
/// Throws InvalidInput with the line or byte.
SurfaceFile read_stl(std::string_view text);

/// A binary STL has no mark but its length: 80 bytes, a count, 50 bytes for each triangle. With
/// `by_name`, the name of the file says STL, and a length that does not fit is no objection.
bool starts_stl(std::string_view data, bool by_name);

std::string write_stl(const SurfaceMesh& mesh);

/// TetGen's pair of files: points (.node) and tetrahedra (.ele), numbered from 0 or 1 as the first
/// point is. Attributes and markers are skipped; of tetrahedra with ten points the four corners
/// count.
/// Throws InvalidInput with file and line.
TetrahedralFile read_tetgen(std::string_view node_text, std::string_view ele_text);

/// VTK's legacy format, text or binary, versions 1 to 5: UNSTRUCTURED_GRID (tetrahedra, or the
/// faces if there are none) and POLYDATA (polygons and strips), its sections in any order and case,
/// among them FIELD and METADATA. Points, lines and all data are skipped; other cells are refused.
/// Indices of the type vtkIdType, and long ones, take 4 bytes or 8, as the file shows.
/// Throws InvalidInput with the line or byte.
MeshFile read_vtk(std::string_view text);

/// Whether a text begins as the format demands, in any case of the letters.
bool starts_vtk(std::string_view content);

std::string write_vtk(const TetrahedralMesh& mesh);

/// VTK's XML files of an UnstructuredGrid (.vtu) or PolyData (.vtp): text, base64 or appended
/// arrays (raw or base64), of either byte order, compressed by zlib or not; of several pieces all.
/// What is read of the cells is what read_vtk reads. Throws InvalidInput with the array and what
/// was expected.
MeshFile read_vtk_xml(std::string_view text);

/// Whether the first element of a text is VTK's.
bool starts_vtk_xml(std::string_view content);

/// What a content is that holds a mesh in a format which is not read (glTF, 3MF, COLLADA, ...), and
/// how to bring it into one that is, in a sentence; nothing if it is none of those known by a mark.
std::optional<std::string> foreign_mesh(std::string_view content);

}  // namespace tripus::meshing
