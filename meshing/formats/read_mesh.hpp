#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "meshing/surface_mesh.hpp"
#include "meshing/tetrahedral_mesh.hpp"

namespace tripus::meshing {

/// `notes`: what of the file was changed or not read, in words for people: "3 polygons cut into
/// triangles".
struct SurfaceFile {
  SurfaceMesh mesh;
  SourceLines lines;
  std::vector<std::string> notes = {};
};

struct TetrahedralFile {
  TetrahedralMesh mesh;
  SourceLines lines;
  std::vector<std::string> notes = {};
};

using MeshFile = std::variant<SurfaceFile, TetrahedralFile>;

/// The format of a mesh file, or nothing if it is none. Recognised by its content; the name decides
/// only for TetGen's pair of files (.node, .ele), which have no mark, and for binary STL whose
/// length does not fit.
std::optional<std::string_view> detect_mesh_format(std::string_view content, std::string_view name);

/// Reads another file by its name; for the other half of TetGen's pair.
using ReadFile = std::function<std::string(const std::string& name)>;

/// Reads a surface or a tetrahedral mesh in whatever format the content has. Indices of points are
/// checked, nothing else. Memory is bounded by a multiple of the size of the content, whatever
/// counts it claims.
/// Throws InvalidInput with line or byte, what was found there and what was expected.
MeshFile read_mesh(std::string_view content, std::string_view name, const ReadFile& read_file);

/// The names of the formats, for messages: "VTK legacy, OFF, ...".
std::string mesh_format_names();

}  // namespace tripus::meshing
