// The module meshing where it is left out: surfaces and meshes are known by their names and first
// words, and refused with what the program would do.
#include <array>
#include <cctype>

#include "base/error.hpp"
#include "meshing/formats/formats.hpp"
#include "meshing/formats/read_graph.hpp"
#include "meshing/formats/read_mesh.hpp"
#include "meshing/manifold.hpp"

namespace tripus::meshing {
namespace {

constexpr std::string_view kMeshes = "surface or mesh";

constexpr std::array<std::string_view, 14> kEndings = {".off",  ".obj", ".stl",  ".ply",   ".vtk",
                                                       ".vtu",  ".vtp", ".mesh", ".meshb", ".msh",
                                                       ".node", ".ele", ".poly", ".smesh"};

std::string lower(std::string_view text) {
  std::string found(text);
  for (char& c : found) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return found;
}

}  // namespace

std::optional<std::string_view> detect_mesh_format(std::string_view content,
                                                   std::string_view name) {
  const std::string ending = lower(name);
  for (const std::string_view each : kEndings)
    if (ending.ends_with(each)) return kMeshes;
  for (const std::string_view head : {"OFF", "ply\n", "ply\r", "solid ", "# vtk", "MeshVersion"})
    if (content.starts_with(head)) return kMeshes;
  return std::nullopt;
}

MeshFile read_mesh(std::string_view, std::string_view, const ReadFile&) {
  throw Unsupported(
      "it is a surface or a mesh, which needs the program: tripus mesh FILE -o small.json makes a "
      "triangulation of it, which can be given here");
}

std::string mesh_format_names() { return "surfaces and meshes (which need the program)"; }

MeshedManifold manifold_of(MeshFile, const ManifoldOptions&) {
  throw InternalError("no mesh was read");
}
bool MeshedManifold::has_only_spheres() const { return false; }
std::string ball_message(const MeshedManifold&) { return {}; }

std::optional<std::string> foreign_mesh(std::string_view) { return std::nullopt; }
bool is_drawn_graph(std::string_view) { return false; }

}  // namespace tripus::meshing
