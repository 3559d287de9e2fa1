#include "meshing/formats/read_mesh.hpp"

#include "base/error.hpp"

namespace tripus::meshing {
namespace {

std::string_view without_mark(std::string_view content) {
  content.remove_prefix(content.starts_with("\xef\xbb\xbf") ? 3 : 0);
  return content;
}

const MeshFormat* find_format(std::string_view content, std::string_view name) {
  for (const MeshFormat& format : mesh_formats())
    if (format.matches(content, name)) return &format;
  return nullptr;
}

}  // namespace

std::optional<std::string_view> detect_mesh_format(std::string_view content,
                                                   std::string_view name) {
  const MeshFormat* format = find_format(without_mark(content), name);
  if (format == nullptr) return std::nullopt;
  return format->name;
}

MeshFile read_mesh(std::string_view content, std::string_view name, const ReadFile& read_file) {
  content = without_mark(content);
  if (const MeshFormat* format = find_format(content, name))
    return format->read(content, name, read_file);
  throw InvalidInput("no mesh format is recognised; there are " + mesh_format_names());
}

std::string mesh_format_names() {
  std::string names;
  for (const MeshFormat& format : mesh_formats())
    names += (names.empty() ? "" : ", ") + std::string(format.name);
  return names;
}

}  // namespace tripus::meshing
