#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/registry.hpp"
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

/// Reads another file by its name; for the other half of TetGen's pair.
using ReadFile = std::function<std::string(const std::string& name)>;

/// One line of the table of formats.
struct MeshFormat {
  std::string_view name;  ///< by which messages and documentation call it
  /// Recognises it by the content, where that has no mark by the name of the file.
  bool (*matches)(std::string_view content, std::string_view name);
  /// As read_mesh.
  MeshFile (*read)(std::string_view content, std::string_view name, const ReadFile& read_file);
  int place = kAnyPlace;  ///< of two that match the lower is meant
};

/// Every format, one file in meshing/formats each, in the order in which they are tried.
std::span<const MeshFormat> mesh_formats();

/// What a MeshFormat has, of a format that is known by its content, and of one whose reader wants
/// nothing else.
template <bool (*Starts)(std::string_view)>
bool matches_content(std::string_view content, std::string_view) {
  return Starts(content);
}
template <auto Read>
MeshFile read_content(std::string_view content, std::string_view, const ReadFile&) {
  return Read(content);
}

/// The format of a mesh file, or nothing if it is none. Recognised by its content; the name decides
/// only for TetGen's pair of files (.node, .ele), which have no mark, for OFF without its header
/// and for binary STL whose length does not fit.
std::optional<std::string_view> detect_mesh_format(std::string_view content, std::string_view name);

/// Reads a surface or a tetrahedral mesh in whatever format the content has. Indices of points are
/// checked, nothing else. Memory is bounded by a multiple of the size of the content, whatever
/// counts it claims.
/// Throws InvalidInput with line or byte, what was found there and what was expected.
MeshFile read_mesh(std::string_view content, std::string_view name, const ReadFile& read_file);

/// The names of the formats, for messages: "VTK legacy, OFF, ...".
std::string mesh_format_names();

}  // namespace tripus::meshing
