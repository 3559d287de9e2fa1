#include "meshing/formats/read_mesh.hpp"

#include <array>

#include "base/error.hpp"
#include "meshing/detail/scanner.hpp"
#include "meshing/formats/medit.hpp"
#include "meshing/formats/obj.hpp"
#include "meshing/formats/off.hpp"
#include "meshing/formats/ply.hpp"
#include "meshing/formats/stl.hpp"
#include "meshing/formats/tetgen_files.hpp"
#include "meshing/formats/vtk.hpp"

namespace tripus::meshing {
namespace {

using detail::Scanner;

struct Format {
  std::string_view name;
  bool (*matches)(std::string_view content);
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

/// "OFF" alone might be an isomorphism signature.
bool starts_off(std::string_view content) {
  Scanner in("", content.substr(0, 4096), '#');
  const std::string_view head = in.word();
  return head.size() <= 5 && head.ends_with("OFF") && !in.word().empty();
}

bool starts_ply(std::string_view content) { return first_word(content) == "ply"; }
bool starts_medit(std::string_view content) {
  return first_word(content) == "MeshVersionFormatted";
}
bool starts_vtk(std::string_view content) { return content.starts_with("# vtk DataFile"); }
bool starts_stl(std::string_view content) {
  return first_word(content) == "solid" || is_binary_stl(content);
}

/// The first line that says something is "v" with a number, or one of the keys that come before.
bool starts_obj(std::string_view content) {
  Scanner in("", content.substr(0, 1 << 16), '#');
  do {
    const std::string_view key = in.word_of_line();
    if (key.empty() || key == "o" || key == "g" || key == "s" || key == "mtllib" || key == "usemtl")
      continue;
    return (key == "v" || key == "vn" || key == "vt") && is_number(in.word_of_line());
  } while (in.next_line());
  return false;
}

/// The first that matches is taken. A new format is one file and one line here.
constexpr std::array kFormats{
    Format{"VTK legacy", starts_vtk, read_vtk},
    Format{"OFF", starts_off, [](std::string_view text) -> MeshFile { return read_off(text); }},
    Format{"PLY", starts_ply, [](std::string_view text) -> MeshFile { return read_ply(text); }},
    Format{"Medit mesh", starts_medit, read_medit},
    Format{"STL", starts_stl, [](std::string_view text) -> MeshFile { return read_stl(text); }},
    Format{"Wavefront OBJ", starts_obj,
           [](std::string_view text) -> MeshFile { return read_obj(text); }},
};

constexpr std::string_view kTetgen = "TetGen .node and .ele";

bool is_tetgen_name(std::string_view name) {
  return name.ends_with(".node") || name.ends_with(".ele");
}

const Format* find_format(std::string_view content) {
  for (const Format& format : kFormats)
    if (format.matches(content)) return &format;
  return nullptr;
}

std::string_view without_mark(std::string_view content) {
  content.remove_prefix(content.starts_with("\xef\xbb\xbf") ? 3 : 0);
  return content;
}

}  // namespace

std::optional<std::string_view> detect_mesh_format(std::string_view content,
                                                   std::string_view name) {
  content = without_mark(content);
  if (const Format* format = find_format(content)) return format->name;
  if (is_tetgen_name(name) && is_number(first_word(content))) return kTetgen;
  return std::nullopt;
}

MeshFile read_mesh(std::string_view content, std::string_view name, const ReadFile& read_file) {
  content = without_mark(content);
  if (const Format* format = find_format(content)) return format->read(content);
  if (!is_tetgen_name(name)) {
    std::string known(kTetgen);
    for (const Format& format : kFormats) known += ", " + std::string(format.name);
    throw InvalidInput("no mesh format is recognised; there are " + known);
  }
  const bool is_node = name.ends_with(".node");
  const std::string other =
      std::string(name.substr(0, name.rfind('.'))) + (is_node ? ".ele" : ".node");
  const std::string companion = read_file(other);
  return is_node ? read_tetgen(content, companion) : read_tetgen(companion, content);
}

}  // namespace tripus::meshing
