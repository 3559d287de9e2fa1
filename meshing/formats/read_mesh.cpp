#include "meshing/formats/read_mesh.hpp"

#include <array>
#include <optional>

#include "base/error.hpp"
#include "base/system_error.hpp"
#include "meshing/detail/scanner.hpp"
#include "meshing/detail/text.hpp"
#include "meshing/formats/gmsh.hpp"
#include "meshing/formats/medit.hpp"
#include "meshing/formats/obj.hpp"
#include "meshing/formats/off.hpp"
#include "meshing/formats/ply.hpp"
#include "meshing/formats/stl.hpp"
#include "meshing/formats/tetgen_files.hpp"
#include "meshing/formats/vtk.hpp"
#include "meshing/formats/vtk_xml.hpp"

namespace tripus::meshing {
namespace {

using detail::Scanner;

struct Format {
  std::string_view name;
  bool (*matches)(std::string_view content, std::string_view name);
  MeshFile (*read)(std::string_view content);
};

std::string_view first_word(std::string_view content) {
  return Scanner("", content.substr(0, 4096), '#').word();
}

bool is_number(std::string_view word) {
  double value = 0;
  if (word.starts_with('+')) word.remove_prefix(1);
  return !word.empty() && std::from_chars(word.data(), word.data() + word.size(), value).ec !=
                              std::errc::invalid_argument;
}

bool starts_ply(std::string_view content) { return first_word(content) == "ply"; }
bool starts_medit(std::string_view content) {
  return first_word(content) == "MeshVersionFormatted";
}
bool starts_gmsh(std::string_view content) {
  const std::string_view word = first_word(content);
  return word == "$MeshFormat" ||
         (word == "$Comments" && content.find("$MeshFormat") != std::string_view::npos);
}

bool ends_with(std::string_view name, std::string_view ending) {
  return name.size() >= ending.size() &&
         detail::lowered(name.substr(name.size() - ending.size())) == ending;
}

template <SurfaceFile (*Read)(std::string_view)>
MeshFile surface(std::string_view text) {
  return Read(text);
}
template <bool (*Starts)(std::string_view)>
bool by_content(std::string_view content, std::string_view) {
  return Starts(content);
}

/// The first that matches is taken. A new format is one file and one line here.
constexpr std::array kFormats{
    Format{"VTK legacy", by_content<starts_vtk>, read_vtk},
    Format{"VTK XML", by_content<starts_vtk_xml>, read_vtk_xml},
    Format{"OFF",
           [](std::string_view content, std::string_view name) {
             return starts_off(content, ends_with(name, ".off"));
           },
           surface<read_off>},
    Format{"PLY", by_content<starts_ply>, surface<read_ply>},
    Format{"Medit mesh", by_content<starts_medit>, read_medit},
    Format{"Gmsh mesh", by_content<starts_gmsh>, read_gmsh},
    Format{"STL",
           [](std::string_view content, std::string_view name) {
             return starts_stl(content, ends_with(name, ".stl"));
           },
           surface<read_stl>},
    Format{"Wavefront OBJ", by_content<starts_obj>, surface<read_obj>},
};

constexpr std::string_view kTetgen = "TetGen .node and .ele";

bool is_tetgen_name(std::string_view name) {
  return ends_with(name, ".node") || ends_with(name, ".ele");
}

const Format* find_format(std::string_view content, std::string_view name) {
  for (const Format& format : kFormats)
    if (format.matches(content, name)) return &format;
  return nullptr;
}

/// Names for the other file of the pair: in the same case of the letters, .Node and .Ele, then in
/// any other.
std::array<std::string, 4> companions_of(std::string_view name) {
  const std::size_t first = name.rfind('.') + 1;
  const auto is_upper = [&](std::size_t i) { return name[i] >= 'A' && name[i] <= 'Z'; };
  const std::string_view low = ends_with(name, ".node") ? "ele" : "node";
  const std::string before(name.substr(0, first));
  std::string same(low), upper(low), capital(low);
  for (std::size_t i = 0; i < low.size(); ++i) {
    upper[i] = static_cast<char>(low[i] - 'a' + 'A');
    if (is_upper(std::min(first + i, name.size() - 1))) same[i] = upper[i];
  }
  capital[0] = upper[0];
  return {before + same, before + std::string(low), before + upper, before + capital};
}

/// The first of them that can be read. Throws as for the first name if there is none.
std::string read_companion(std::string_view name, const ReadFile& read_file) {
  std::optional<UnusableFile> problem;
  for (const std::string& companion : companions_of(name)) {
    try {
      return read_file(companion);
    } catch (const UnusableFile& error) {
      if (!problem) problem = error;
    }
  }
  throw *problem;
}

std::string_view without_mark(std::string_view content) {
  content.remove_prefix(content.starts_with("\xef\xbb\xbf") ? 3 : 0);
  return content;
}

}  // namespace

std::optional<std::string_view> detect_mesh_format(std::string_view content,
                                                   std::string_view name) {
  content = without_mark(content);
  if (const Format* format = find_format(content, name)) return format->name;
  if (is_tetgen_name(name) && is_number(first_word(content))) return kTetgen;
  return std::nullopt;
}

MeshFile read_mesh(std::string_view content, std::string_view name, const ReadFile& read_file) {
  content = without_mark(content);
  if (const Format* format = find_format(content, name)) return format->read(content);
  if (!is_tetgen_name(name))
    throw InvalidInput("no mesh format is recognised; there are " + mesh_format_names());
  const bool is_node = ends_with(name, ".node");
  const std::string companion = read_companion(name, read_file);
  return is_node ? read_tetgen(content, companion) : read_tetgen(companion, content);
}

std::string mesh_format_names() {
  std::string names;
  for (const Format& format : kFormats) names += std::string(format.name) + ", ";
  return names + std::string(kTetgen);
}

}  // namespace tripus::meshing
