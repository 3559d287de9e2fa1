#include "meshing/detail/vtk.hpp"

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

struct VtkNumbers::Type {
  std::string_view name;
  std::size_t bits;  ///< of one number; 0: 4 or 8 bytes, which programs do not agree on
  enum { kSigned, kUnsigned, kFloat } kind;
};

namespace {

/// What may follow an array: sections, and parts of them.
constexpr std::array<std::string_view, 22> kKeys{
    "points",     "cells",        "cell_types",          "polygons",     "vertices", "lines",
    "field",      "point_data",   "triangle_strips",     "cell_data",    "metadata", "offsets",
    "scalars",    "vectors",      "connectivity",        "normals",      "tensors",  "dataset",
    "global_ids", "pedigree_ids", "texture_coordinates", "color_scalars"};

constexpr bool is_count(std::string_view word) {
  return !word.empty() && word.size() < 12 &&
         word.find_first_not_of("0123456789") == std::string_view::npos;
}

/// Whether the text goes on with a section or the next array of a field, or ends.
bool is_section(std::string_view rest) {
  Scanner ahead("VTK", rest, '\0');
  const std::string_view word = ahead.word();
  if (word.empty()) return true;
  if (std::find(kKeys.begin(), kKeys.end(), lowered(word.substr(0, 32))) != kKeys.end())
    return true;
  // A name, components, tuples, and a type.
  return rest.front() == '\n' && is_count(ahead.word()) && is_count(ahead.word()) &&
         !ahead.word().empty();
}

}  // namespace

VtkNumbers::Type VtkNumbers::find_type(std::string_view name) const {
  static constexpr std::array kTypes{
      Type{"float", 32, Type::kFloat},
      Type{"double", 64, Type::kFloat},
      Type{"int", 32, Type::kSigned},
      Type{"unsigned_int", 32, Type::kUnsigned},
      Type{"bit", 1, Type::kUnsigned},
      Type{"char", 8, Type::kSigned},
      Type{"signed_char", 8, Type::kSigned},
      Type{"unsigned_char", 8, Type::kUnsigned},
      Type{"short", 16, Type::kSigned},
      Type{"unsigned_short", 16, Type::kUnsigned},
      Type{"long", 0, Type::kSigned},
      Type{"unsigned_long", 0, Type::kUnsigned},
      Type{"vtkidtype", 0, Type::kSigned},
      Type{"long_long", 64, Type::kSigned},
      Type{"unsigned_long_long", 64, Type::kUnsigned},
      Type{"vtktypeint8", 8, Type::kSigned},
      Type{"vtktypeuint8", 8, Type::kUnsigned},
      Type{"vtktypeint16", 16, Type::kSigned},
      Type{"vtktypeuint16", 16, Type::kUnsigned},
      Type{"vtktypeint32", 32, Type::kSigned},
      Type{"vtktypeuint32", 32, Type::kUnsigned},
      Type{"vtktypeint64", 64, Type::kSigned},
      Type{"vtktypeuint64", 64, Type::kUnsigned},
      Type{"vtktypefloat32", 32, Type::kFloat},
      Type{"vtktypefloat64", 64, Type::kFloat},
  };
  const std::string low = lowered(name.substr(0, 32));
  const auto found =
      std::find_if(kTypes.begin(), kTypes.end(), [&](const Type& t) { return t.name == low; });
  if (found != kTypes.end()) return *found;
  text_.fail("numbers of type " + quoted(std::string(name.substr(0, 32))) +
             "; expected a type of VTK, such as double or int");
}

void VtkNumbers::require_room(std::uint64_t count, std::size_t bytes) const {
  if (count > text_.room(bytes))
    text_.fail(std::to_string(count) + " numbers announced, more than the file is long enough for");
}

/// At the start of the block: whether its numbers take 8 bytes each and not 4.
bool VtkNumbers::is_wide(std::uint64_t count) const {
  const std::string_view rest = text_.rest();
  if (4 * count > rest.size()) return false;  // too long either way
  return !is_section(rest.substr(4 * count)) && 8 * count <= rest.size() &&
         is_section(rest.substr(8 * count));
}

template <class Number>
std::vector<Number> VtkNumbers::take(std::uint64_t count, Type type) {
  require_room(count,
               is_binary_ ? std::max<std::size_t>(type.bits == 0 ? 4 : type.bits / 8, 1) : 2);
  std::vector<Number> numbers;
  numbers.reserve(count);
  lines_.clear();
  if (!is_binary_) {
    for (std::uint64_t i = 0; i < count; ++i) {
      if constexpr (std::is_floating_point_v<Number>) {
        numbers.push_back(text_.number("a coordinate"));
      } else {
        numbers.push_back(text_.natural("an index"));
      }
      lines_.push_back(text_.line());
    }
    return numbers;
  }
  text_.next_line();
  if (type.bits == 0) type.bits = is_wide(count) ? 64 : 32;
  if (type.bits < 8) text_.fail("bits where other numbers were expected");
  Bytes bytes("VTK", text_.rest(), true);
  const auto append = [&](auto value) {
    if constexpr (!std::is_floating_point_v<Number>)
      if (value < 0) bytes.fail("a negative index");
    numbers.push_back(static_cast<Number>(value));
  };
  for (std::uint64_t i = 0; i < count; ++i) {
    if (type.kind == Type::kFloat) {
      type.bits == 32 ? append(bytes.take<float>("a number"))
                      : append(bytes.take<double>("a number"));
    } else if (type.bits == 64) {
      append(bytes.take<std::int64_t>("a number"));
    } else if (type.bits == 32) {
      type.kind == Type::kSigned ? append(bytes.take<std::int32_t>("a number"))
                                 : append(bytes.take<std::uint32_t>("a number"));
    } else if (type.bits == 16) {
      type.kind == Type::kSigned ? append(bytes.take<std::int16_t>("a number"))
                                 : append(bytes.take<std::uint16_t>("a number"));
    } else {
      type.kind == Type::kSigned ? append(bytes.take<std::int8_t>("a number"))
                                 : append(bytes.take<std::uint8_t>("a number"));
    }
  }
  text_.skip_bytes(count * (type.bits / 8));
  return numbers;
}

std::vector<double> VtkNumbers::floats(std::uint64_t count, std::string_view type) {
  return take<double>(count, find_type(type));
}

std::vector<std::uint64_t> VtkNumbers::naturals(std::uint64_t count, std::string_view type) {
  const Type found = find_type(type);
  if (found.kind == Type::kFloat)
    text_.fail("indices of type " + quoted(std::string(type.substr(0, 32))) +
               "; expected whole numbers");
  return take<std::uint64_t>(count, found);
}

void VtkNumbers::skip(std::uint64_t count, std::string_view type) {
  if (lowered(type.substr(0, 32)) == "string") return skip_strings(count);
  const Type found = find_type(type);
  if (!is_binary_) {
    require_room(count, 2);
    for (std::uint64_t i = 0; i < count; ++i)
      if (text_.word().empty()) text_.fail("the file ends in an array of field data");
    return;
  }
  text_.next_line();
  if (count == 0) return;
  std::uint64_t bytes = (count + 7) / 8;  // of bits
  if (found.bits != 1) {
    require_room(count, found.bits == 0 ? 4 : found.bits / 8);
    bytes = count * (found.bits == 0 ? (is_wide(count) ? 8 : 4) : found.bits / 8);
  }
  if (bytes > text_.rest().size()) text_.fail("the file ends in an array of field data");
  text_.skip_bytes(bytes);
}

/// In text one a line; in binary each after its length, of which the first two bits say how many
/// bytes it takes.
void VtkNumbers::skip_strings(std::uint64_t count) {
  require_room(count, 1);
  text_.next_line();
  for (std::uint64_t i = 0; i < count; ++i) {
    if (!is_binary_) {
      text_.next_line();
      continue;
    }
    Bytes bytes("VTK", text_.rest(), true);
    const unsigned first = static_cast<unsigned char>(Bytes(bytes).take<char>("a string"));
    std::uint64_t length = 0;
    std::size_t head = std::size_t{1} << (3 - (first >> 6));
    for (std::size_t k = 0; k < head; ++k)
      length = length << 8 | static_cast<unsigned char>(bytes.take<char>("the length of a string"));
    length &= ~(std::uint64_t{3} << (8 * head - 2));
    if (length > bytes.rest().size()) bytes.fail("the file ends in a string");
    text_.skip_bytes(head + length);
  }
}

}  // namespace tripus::meshing::detail
