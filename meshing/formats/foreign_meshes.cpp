#include <array>

#include "meshing/detail/scanner.hpp"
#include "meshing/detail/text.hpp"
#include "meshing/formats/formats.hpp"

namespace tripus::meshing {
namespace {

using namespace std::string_view_literals;

/// Which of the converters that people have reads the format.
enum class Converter { kAssimp, kMeshio, kOriginal };

struct Foreign {
  std::string_view name;
  bool (*matches)(std::string_view content);
  Converter converter;
};

template <const std::string_view& Mark>
bool begins(std::string_view content) {
  return content.starts_with(Mark);
}

std::string_view beginning(std::string_view content) { return content.substr(0, 4096); }

std::string_view trimmed_left(std::string_view content) {
  const std::size_t first = content.find_first_not_of(" \t\r\n");
  return first == std::string_view::npos ? std::string_view{} : content.substr(first);
}

/// An XML document whose root has the name.
template <const std::string_view& Root>
bool has_root(std::string_view content) {
  content = beginning(content);
  return trimmed_left(content).starts_with('<') && content.find(Root) != std::string_view::npos;
}

constexpr std::string_view kGlb = "glTF";
constexpr std::string_view kZip = "PK\x03\x04";
constexpr std::string_view kCollada = "<COLLADA";
constexpr std::string_view kX3d = "<X3D";
constexpr std::string_view kAmf = "<amf";
constexpr std::string_view kVrml = "#VRML";
constexpr std::string_view kDirectX = "xof ";
constexpr std::string_view kFbx = "Kaydara FBX Binary";
constexpr std::string_view kBlender = "BLENDER";
constexpr std::string_view kCtm = "OCTM";
constexpr std::string_view kStep = "ISO-10303-21";
constexpr std::string_view kHdf5 = "\x89HDF";
constexpr std::string_view kNetCdf = "CDF";
constexpr std::string_view kNetgen = "mesh3d";
constexpr std::string_view kNetgenSurface = "surfacemesh";
constexpr std::string_view kGmsh1 = "$NOD";

bool is_gltf(std::string_view content) {
  return trimmed_left(content).starts_with('{') &&
         content.find("\"asset\"") != std::string_view::npos &&
         content.find("\"accessors\"") != std::string_view::npos;
}

/// A chunk of the kind 4D4D that is the whole file.
bool is_3ds(std::string_view content) {
  if (content.size() < 6 || !content.starts_with("MM")) return false;
  std::size_t length = 0;
  for (std::size_t i = 6; i-- > 2;) length = 256 * length + static_cast<unsigned char>(content[i]);
  return length == content.size();
}

/// Pairs of lines, a number and a value: the first is a comment (999) or opens a section.
bool is_dxf(std::string_view content) {
  content = beginning(content);
  const std::string_view start = trimmed_left(content);
  return (start.starts_with("0\n") || start.starts_with("0\r") || start.starts_with("999")) &&
         content.find("SECTION") != std::string_view::npos;
}

/// The integers 1 and a version, in either order of bytes.
bool is_binary_medit(std::string_view content) {
  if (content.size() < 8) return false;
  const auto is = [&](std::string_view first, std::size_t version_at) {
    const char version = content[version_at];
    return content.substr(0, 4) == first && version >= 1 && version <= 4;
  };
  return is("\x01\0\0\0"sv, 4) || is("\0\0\0\x01"sv, 7);
}

/// A section with a comment, as (1 "...") or (0 "...").
bool is_ansys(std::string_view content) {
  content = trimmed_left(content);
  return content.starts_with("(1 \"") || content.starts_with("(0 \"");
}

bool is_abaqus(std::string_view content) {
  const std::string start = detail::lowered(trimmed_left(beginning(content)).substr(0, 8));
  return start.starts_with("*heading") || start.starts_with("*node");
}

/// The first word after comments.
template <const std::string_view& Word>
bool has_first_word(std::string_view content) {
  return detail::Scanner("", beginning(content), '#').word() == Word;
}

/// By the marks that the formats' definitions give. A new format is one line here.
constexpr std::array kForeign{
    Foreign{"a binary glTF file", begins<kGlb>, Converter::kAssimp},
    Foreign{"a glTF file", is_gltf, Converter::kAssimp},
    Foreign{"a zip archive, as 3MF files are", begins<kZip>, Converter::kOriginal},
    Foreign{"a COLLADA file", has_root<kCollada>, Converter::kAssimp},
    Foreign{"an X3D file", has_root<kX3d>, Converter::kAssimp},
    Foreign{"an AMF file", has_root<kAmf>, Converter::kAssimp},
    Foreign{"a VRML file", begins<kVrml>, Converter::kOriginal},
    Foreign{"a 3DS file", is_3ds, Converter::kAssimp},
    Foreign{"a DXF file", is_dxf, Converter::kAssimp},
    Foreign{"a DirectX file", begins<kDirectX>, Converter::kAssimp},
    Foreign{"an FBX file", begins<kFbx>, Converter::kAssimp},
    Foreign{"a Blender file", begins<kBlender>, Converter::kOriginal},
    Foreign{"an OpenCTM file", begins<kCtm>, Converter::kOriginal},
    Foreign{"a STEP file", begins<kStep>, Converter::kOriginal},
    Foreign{"a binary Medit mesh", is_binary_medit, Converter::kMeshio},
    Foreign{"an Abaqus mesh", is_abaqus, Converter::kMeshio},
    Foreign{"an ANSYS (Fluent) mesh", is_ansys, Converter::kMeshio},
    Foreign{"an HDF5 file, as MED, CGNS and XDMF meshes are", begins<kHdf5>, Converter::kMeshio},
    Foreign{"a NetCDF file, as Exodus meshes are", begins<kNetCdf>, Converter::kMeshio},
    Foreign{"a Netgen mesh", has_first_word<kNetgen>, Converter::kMeshio},
    Foreign{"a surface mesh of Netgen", has_first_word<kNetgenSurface>, Converter::kOriginal},
    Foreign{"a Gmsh mesh of the version 1", begins<kGmsh1>, Converter::kOriginal},
};

std::string_view way(Converter converter) {
  switch (converter) {
    case Converter::kAssimp:
      return ", or convert it (assimp export FILE surface.obj)";
    case Converter::kMeshio:
      return ", or convert it (meshio convert FILE mesh.vtk)";
    case Converter::kOriginal:
      break;
  }
  return "";
}

}  // namespace

std::optional<std::string> foreign_mesh(std::string_view content) {
  for (const Foreign& foreign : kForeign) {
    if (!foreign.matches(content)) continue;
    return "it is " + std::string(foreign.name) +
           ", which is not read: save it as OFF, OBJ, PLY, STL, VTK or Gmsh's .msh where it was "
           "made" +
           std::string(way(foreign.converter));
  }
  return std::nullopt;
}

}  // namespace tripus::meshing
