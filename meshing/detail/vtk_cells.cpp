#include "meshing/detail/vtk_cells.hpp"

#include <algorithm>
#include <array>

#include "base/error.hpp"

namespace tripus::meshing::detail {
namespace {

enum class Use { kLeaveOut, kFace, kPixel, kStrip, kTetrahedron };

struct Kind {
  std::uint64_t type;
  Use use;
  std::size_t corners;  ///< that count, the first of the cell; 0: all
  bool is_curved = false;
};

/// Of curved cells the corners come first.
constexpr std::array kKinds{
    Kind{0, Use::kLeaveOut, 0},
    Kind{1, Use::kLeaveOut, 0},
    Kind{2, Use::kLeaveOut, 0},
    Kind{3, Use::kLeaveOut, 0},
    Kind{4, Use::kLeaveOut, 0},
    Kind{5, Use::kFace, 3},
    Kind{6, Use::kStrip, 0},
    Kind{7, Use::kFace, 0},
    Kind{8, Use::kPixel, 4},
    Kind{9, Use::kFace, 4},
    Kind{10, Use::kTetrahedron, 4},
    Kind{21, Use::kLeaveOut, 0},
    Kind{22, Use::kFace, 3, true},
    Kind{23, Use::kFace, 4, true},
    Kind{24, Use::kTetrahedron, 4, true},
    Kind{28, Use::kFace, 4, true},
    Kind{34, Use::kFace, 3, true},
    Kind{35, Use::kLeaveOut, 0},
    Kind{68, Use::kLeaveOut, 0},
    Kind{69, Use::kFace, 3, true},
    Kind{70, Use::kFace, 4, true},
    Kind{71, Use::kTetrahedron, 4, true},
};

struct Refused {
  std::uint64_t type;
  std::string_view name;
};
constexpr std::array kRefused{Refused{11, "voxel"}, Refused{12, "hexahedron"}, Refused{13, "wedge"},
                              Refused{14, "pyramid"}, Refused{42, "polyhedron"}};

[[noreturn]] void fail(const VtkCells& cells, std::size_t i, std::string_view format,
                       const std::string& what) {
  std::string message(format);
  if (i < cells.lines.size()) message += ", line " + std::to_string(cells.lines[i]);
  throw InvalidInput(message + ": cell " + std::to_string(i) + what);
}

const Kind& kind_of(const VtkCells& cells, std::size_t i, std::uint64_t type,
                    std::string_view format) {
  const auto found =
      std::find_if(kKinds.begin(), kKinds.end(), [&](const Kind& k) { return k.type == type; });
  if (found != kKinds.end()) return *found;
  const auto refused = std::find_if(kRefused.begin(), kRefused.end(),
                                    [&](const Refused& r) { return r.type == type; });
  fail(cells, i, format,
       " is of VTK type " + std::to_string(type) +
           (refused == kRefused.end() ? std::string() : " (" + std::string(refused->name) + ")") +
           "; only triangles (5) and tetrahedra (10), strips, polygons and quadrilaterals are "
           "read: cut the cells into tetrahedra first");
}

void add_cell(const VtkCells& cells, std::size_t i, const Kind& kind, std::size_t points,
              std::string_view format, std::vector<std::uint32_t>& corners, Cells& out) {
  if (kind.use == Use::kLeaveOut) {
    if (kind.type != 0) out.add_left_out();
    return;
  }
  const std::size_t size = cells.start[i + 1] - cells.start[i];
  const std::size_t wanted = kind.corners == 0 ? size : kind.corners;
  if (size < wanted || (!kind.is_curved && size != wanted))
    fail(cells, i, format,
         " has " + std::to_string(size) + " corners; expected " + std::to_string(wanted));
  corners.clear();
  for (std::size_t k = 0; k < wanted; ++k) {
    const std::uint64_t corner = cells.corners[cells.start[i] + k];
    if (corner >= points)
      fail(cells, i, format,
           ": point " + std::to_string(corner) + " does not exist; the file has " +
               std::to_string(points) + " points, numbered from 0");
    corners.push_back(static_cast<std::uint32_t>(corner));
  }
  const std::uint32_t line = i < cells.lines.size() ? cells.lines[i] : 0;
  if (kind.is_curved) out.add_curved();
  if (kind.use == Use::kTetrahedron) {
    out.add_tetrahedron({corners[0], corners[1], corners[2], corners[3]}, line);
  } else if (kind.use == Use::kStrip) {
    out.add_strip(corners, line);
  } else {
    if (kind.use == Use::kPixel) std::swap(corners[2], corners[3]);
    out.add_face(corners, line);
  }
}

}  // namespace

void add_vtk_cells(const VtkCells& cells, const std::vector<std::uint64_t>& types,
                   std::size_t points, std::string_view format, Cells& out) {
  if (types.size() != cells.count())
    throw InvalidInput(std::string(format) + ": " + std::to_string(types.size()) +
                       " cell types for " + std::to_string(cells.count()) + " cells");
  std::vector<std::uint32_t> corners;
  for (std::size_t i = 0; i < types.size(); ++i)
    add_cell(cells, i, kind_of(cells, i, types[i], format), points, format, corners, out);
}

void add_vtk_cells(const VtkCells& cells, std::uint64_t type, std::size_t points,
                   std::string_view format, Cells& out) {
  std::vector<std::uint32_t> corners;
  for (std::size_t i = 0; i < cells.count(); ++i)
    add_cell(cells, i, kind_of(cells, i, type, format), points, format, corners, out);
}

}  // namespace tripus::meshing::detail
