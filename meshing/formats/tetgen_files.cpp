#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <optional>

#include "base/system_error.hpp"
#include "meshing/detail/scanner.hpp"
#include "meshing/detail/text.hpp"
#include "meshing/formats/formats.hpp"

namespace tripus::meshing {
namespace {

using detail::Scanner;

/// The rest of the line: attributes, markers, further points.
void skip_line(Scanner& in) {
  while (!in.word_of_line().empty()) {
  }
}

/// The rest of a first line, numbers of attributes and markers: whether there are any.
bool has_attributes(Scanner& in) {
  bool any = false;
  for (auto word = in.word_of_line(); !word.empty(); word = in.word_of_line())
    any |= word.find_first_not_of('0') != std::string_view::npos;
  return any;
}

/// The number in front of entry i must be first + i.
void expect_number(Scanner& in, std::uint32_t i, std::uint32_t first, std::string_view what) {
  const std::uint32_t number = in.natural("the number of a " + std::string(what));
  if (number != first + i)
    in.fail(std::string(what) + " " + std::to_string(number) + " where " +
            std::to_string(first + i) + " was expected");
}

std::uint32_t read_points(std::string_view text, TetrahedralFile& file) {
  Scanner in("TetGen .node file", text, '#');
  const std::uint32_t count = in.count("the number of points", 8);
  if (in.natural("the dimension") != 3) in.fail("only meshes in three dimensions are read");
  if (has_attributes(in)) file.notes.push_back("attributes and markers of the points not read");
  file.mesh.points.reserve(count);
  std::uint32_t first = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    if (i == 0) {
      first = in.natural("the number of a point");
      if (first > 1)
        in.fail("the first point has the number " + std::to_string(first) + "; expected 0 or 1");
    } else {
      expect_number(in, i, first, "point");
    }
    file.mesh.points.push_back(in.point());
    file.lines.points.push_back(in.line());
    skip_line(in);
  }
  return first;
}

void read_tetrahedra(std::string_view text, std::uint32_t first, TetrahedralFile& file) {
  Scanner in("TetGen .ele file", text, '#');
  if (Scanner ahead = in; ahead.word().empty())
    in.fail("there is nothing in it; .node and .ele hold a solid in tetrahedra, not a surface");
  const std::uint32_t count = in.count("the number of tetrahedra", 10);
  const std::uint32_t corners = in.natural("the number of points of a tetrahedron");
  if (corners != 4 && corners != 10)
    in.fail("cells of " + std::to_string(corners) + " points; expected 4 (tetrahedra)");
  if (has_attributes(in)) file.notes.push_back("attributes of the tetrahedra not read");
  file.mesh.tetrahedra.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (i == 0) {
      if (in.natural("the number of a tetrahedron") > 1)
        in.fail("the first tetrahedron must have the number 0 or 1");
    } else {
      in.natural("the number of a tetrahedron");
    }
    Tetrahedron t;
    for (std::uint32_t& corner : t)
      corner = in.index(in.word_of_line(), first, file.mesh.points.size());
    file.mesh.tetrahedra.push_back(t);
    file.lines.cells.push_back(in.line());
    skip_line(in);
  }
}

}  // namespace

TetrahedralFile read_tetgen(std::string_view node_text, std::string_view ele_text) {
  TetrahedralFile file;
  const std::uint32_t first = read_points(node_text, file);
  read_tetrahedra(ele_text, first, file);
  return file;
}

}  // namespace tripus::meshing

namespace tripus::meshing::registered_mesh_formats {
namespace {

bool is_number(std::string_view word) {
  double value = 0;
  if (word.starts_with('+')) word.remove_prefix(1);
  return !word.empty() && std::from_chars(word.data(), word.data() + word.size(), value).ec !=
                              std::errc::invalid_argument;
}

bool matches(std::string_view content, std::string_view name) {
  return (detail::has_ending(name, ".node") || detail::has_ending(name, ".ele")) &&
         is_number(detail::first_word(content));
}

/// Names for the other file of the pair: in the same case of the letters, .Node and .Ele, then in
/// any other.
std::array<std::string, 4> companions_of(std::string_view name) {
  const std::size_t first = name.rfind('.') + 1;
  const auto is_upper = [&](std::size_t i) { return name[i] >= 'A' && name[i] <= 'Z'; };
  const std::string_view low = detail::has_ending(name, ".node") ? "ele" : "node";
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

MeshFile read(std::string_view content, std::string_view name, const ReadFile& read_file) {
  const std::string companion = read_companion(name, read_file);
  return detail::has_ending(name, ".node") ? read_tetgen(content, companion)
                                           : read_tetgen(companion, content);
}

}  // namespace

std::span<const MeshFormat> tetgen_files() {
  static constexpr MeshFormat kRows[] = {{"TetGen .node and .ele", matches, read, kAnyPlace + 1}};
  return kRows;
}

}  // namespace tripus::meshing::registered_mesh_formats
