#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "meshing/detail/cells.hpp"

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

}  // namespace tripus::meshing::detail
