#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "meshing/detail/bytes.hpp"
#include "meshing/detail/faces.hpp"
#include "meshing/detail/scanner.hpp"
#include "meshing/detail/text.hpp"

namespace tripus::meshing::detail {

/// Numbers of VTK's cell types.
inline constexpr std::uint64_t kVtkVertex = 1, kVtkLine = 3, kVtkStrip = 6, kVtkPolygon = 7;

/// Cells as VTK's files give them.
struct VtkCells {
  std::vector<std::uint64_t> corners;  ///< of all cells
  std::vector<std::uint64_t> start;    ///< [cells + 1] into corners, or nothing
  std::vector<std::uint32_t> lines;    ///< [cells], or nothing

  std::size_t count() const { return start.empty() ? 0 : start.size() - 1; }
};

/// Adds cells of the types [cells], or all of one type; `format` begins the messages.
/// Throws InvalidInput for cells that are no faces, tetrahedra, lines or points, with their name,
/// and for corners that are no points.
void add_vtk_cells(const VtkCells& cells, const std::vector<std::uint64_t>& types,
                   std::size_t points, std::string_view format, Cells& out);
void add_vtk_cells(const VtkCells& cells, std::uint64_t type, std::size_t points,
                   std::string_view format, Cells& out);

/// The arrays of a legacy VTK file: words, or big-endian binary blocks between the lines of text.
class VtkNumbers {
 public:
  VtkNumbers(Scanner text, bool is_binary) : text_(text), is_binary_(is_binary) {}

  Scanner& text() { return text_; }
  /// The next word, in lower case.
  std::string key() { return lowered(text_.word()); }

  std::vector<double> floats(std::uint64_t count, std::string_view type);
  std::vector<std::uint64_t> naturals(std::uint64_t count, std::string_view type);
  /// An array of any type, also of strings.
  void skip(std::uint64_t count, std::string_view type);
  /// The line of each number taken last; empty for binary files.
  const std::vector<std::uint32_t>& lines() const { return lines_; }

 private:
  struct Type;
  Type find_type(std::string_view name) const;
  bool is_wide(std::uint64_t count) const;
  void require_room(std::uint64_t count, std::size_t bytes) const;
  void skip_strings(std::uint64_t count);
  template <class Number>
  std::vector<Number> take(std::uint64_t count, Type type);

  Scanner text_;
  bool is_binary_;
  std::vector<std::uint32_t> lines_;
};

}  // namespace tripus::meshing::detail
