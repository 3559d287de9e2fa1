#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <pugixml.hpp>

#include "base/base64.hpp"
#include "base/compression.hpp"
#include "meshing/detail/bytes.hpp"
#include "meshing/detail/scanner.hpp"
#include "meshing/detail/vtk.hpp"
#include "meshing/formats/formats.hpp"

namespace tripus::meshing {
namespace {

using detail::Bytes;
using detail::VtkCells;

constexpr std::string_view kName = "VTK XML";

[[noreturn]] void fail(const std::string& what) {
  throw InvalidInput(std::string(kName) + ": " + what);
}

std::string_view attribute(const pugi::xml_node& node, const char* name) {
  return node.attribute(name).value();
}

/// Most bytes that one block of an array may hold when it is unpacked.
constexpr std::uint64_t kLargestBlock = std::uint64_t{1} << 30;

/// The file but for the numbers: how arrays are stored.
struct Coding {
  bool is_big_endian = false, is_wide = false, is_compressed = false;
  bool is_appended_base64 = false;
  std::string_view appended;  ///< from the first array on
};

struct Type {
  std::string_view name;
  std::size_t bytes;
  enum { kSigned, kUnsigned, kFloat } kind;
};
constexpr std::array kTypes{
    Type{"Float32", 4, Type::kFloat}, Type{"Float64", 8, Type::kFloat},
    Type{"Int8", 1, Type::kSigned},   Type{"UInt8", 1, Type::kUnsigned},
    Type{"Int16", 2, Type::kSigned},  Type{"UInt16", 2, Type::kUnsigned},
    Type{"Int32", 4, Type::kSigned},  Type{"UInt32", 4, Type::kUnsigned},
    Type{"Int64", 8, Type::kSigned},  Type{"UInt64", 8, Type::kUnsigned},
};

double take(Bytes& in, const Type& type) {
  const std::string_view what = "a number";
  if (type.kind == Type::kFloat)
    return type.bytes == 4 ? static_cast<double>(in.take<float>(what)) : in.take<double>(what);
  const bool is_signed = type.kind == Type::kSigned;
  switch (type.bytes) {
    case 1:
      return is_signed ? in.take<std::int8_t>(what) : in.take<std::uint8_t>(what);
    case 2:
      return is_signed ? in.take<std::int16_t>(what) : in.take<std::uint16_t>(what);
    case 4:
      return is_signed ? in.take<std::int32_t>(what) : in.take<std::uint32_t>(what);
    default:
      return is_signed ? static_cast<double>(in.take<std::int64_t>(what))
                       : static_cast<double>(in.take<std::uint64_t>(what));
  }
}

/// The bytes of an array, of which `stored` is the beginning and perhaps more.
std::string unpacked(std::string_view stored, const Coding& coding) {
  Bytes in(kName, stored, coding.is_big_endian);
  const auto natural = [&] {
    return coding.is_wide ? in.take<std::uint64_t>("the size of an array")
                          : std::uint64_t{in.take<std::uint32_t>("the size of an array")};
  };
  if (!coding.is_compressed) {
    const std::uint64_t size = natural();
    in.require_room(size, 1, "bytes of an array");
    return std::string(in.rest().substr(0, size));
  }
  const std::uint64_t blocks = natural(), size = natural();
  natural();  // of the last block, if that is smaller
  in.require_room(blocks, coding.is_wide ? 8 : 4, "blocks of an array");
  if (size > kLargestBlock) fail("a block of " + std::to_string(size) + " bytes");
  std::vector<std::uint64_t> sizes(blocks);
  for (std::uint64_t& each : sizes) each = natural();
  std::string out;
  for (const std::uint64_t each : sizes) {
    in.require_room(each, 1, "bytes of a block");
    out += inflate_block(in.rest().substr(0, each), size);
    in.skip(each);
  }
  return out;
}

/// The numbers of a DataArray, in double precision, which holds all indices that fit into memory.
std::vector<double> numbers_of(const pugi::xml_node& array, const Coding& coding) {
  const std::string_view format = attribute(array, "format");
  const std::string_view name = attribute(array, "type");
  const auto type = std::find_if(kTypes.begin(), kTypes.end(),
                                 [&](const Type& each) { return each.name == name; });
  if (type == kTypes.end()) fail("an array of type " + quoted(std::string(name.substr(0, 32))));
  std::vector<double> numbers;
  if (format == "ascii" || format.empty()) {  // as VTK takes it
    detail::Scanner in(kName, array.child_value(), '\0');
    for (auto word = in.word(); !word.empty(); word = in.word())
      numbers.push_back(in.number(word, "a number of an array"));
    return numbers;
  }
  std::string bytes;
  if (format == "binary") {
    bytes = unpacked(decode_base64(array.child_value()), coding);
  } else if (format == "appended") {
    const auto offset = array.attribute("offset").as_ullong();
    if (offset >= coding.appended.size()) fail("an array beyond the end of the appended data");
    const std::string_view stored = coding.appended.substr(offset);
    bytes = coding.is_appended_base64 ? unpacked(decode_base64(stored), coding)
                                      : unpacked(stored, coding);
  } else {
    fail("an array in the form " + quoted(std::string(format.substr(0, 32))) +
         "; expected ascii, binary or appended");
  }
  Bytes in(kName, bytes, coding.is_big_endian);
  numbers.reserve(bytes.size() / type->bytes);
  while (in.rest().size() >= type->bytes) numbers.push_back(take(in, *type));
  return numbers;
}

/// The array of that name in an element; nothing if there is none or it has no numbers.
std::vector<double> named_numbers(const pugi::xml_node& element, std::string_view name,
                                  const Coding& coding) {
  for (const pugi::xml_node& array : element.children("DataArray"))
    if (attribute(array, "Name") == name) return numbers_of(array, coding);
  return {};
}

std::vector<std::uint64_t> naturals(const std::vector<double>& numbers, std::string_view what) {
  std::vector<std::uint64_t> result;
  result.reserve(numbers.size());
  for (const double x : numbers) {
    if (!(x >= 0 && x < UINT32_MAX) || x != std::floor(x))
      fail(std::to_string(x) + " among the " + std::string(what));
    result.push_back(static_cast<std::uint64_t>(x));
  }
  return result;
}

/// `first` is the number of points of the pieces before.
VtkCells read_cells(const pugi::xml_node& element, std::size_t first, const Coding& coding) {
  VtkCells cells;
  cells.corners = naturals(named_numbers(element, "connectivity", coding), "indices of points");
  for (std::uint64_t& corner : cells.corners) corner += first;
  cells.start = naturals(named_numbers(element, "offsets", coding), "offsets");
  cells.start.insert(cells.start.begin(), 0);  // the file has the ends of the cells
  for (std::size_t i = 0; i < cells.start.size(); ++i)
    if (cells.start[i] > cells.corners.size() || (i > 0 && cells.start[i] < cells.start[i - 1]))
      fail("offset " + std::to_string(cells.start[i]) + " of cell " + std::to_string(i) + " of " +
           std::to_string(cells.corners.size()) + " indices");
  return cells;
}

void read_piece(const pugi::xml_node& piece, const Coding& coding, std::vector<Point>& points,
                detail::Cells& cells) {
  const std::size_t first = points.size();
  const auto array = piece.child("Points").child("DataArray");
  const std::vector<double> numbers = array ? numbers_of(array, coding) : std::vector<double>();
  if (numbers.size() % 3 != 0) fail(std::to_string(numbers.size()) + " coordinates");
  for (std::size_t i = 0; i < numbers.size(); i += 3)
    points.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
  if (const auto grid = piece.child("Cells")) {
    const auto types = naturals(named_numbers(grid, "types", coding), "types of cells");
    detail::add_vtk_cells(read_cells(grid, first, coding), types, points.size(), kName, cells);
  }
  struct Part {
    const char* name;
    std::uint64_t type;
  };
  for (const Part part : {Part{"Verts", detail::kVtkVertex}, Part{"Lines", detail::kVtkLine},
                          Part{"Strips", detail::kVtkStrip}, Part{"Polys", detail::kVtkPolygon}})
    if (const auto element = piece.child(part.name))
      detail::add_vtk_cells(read_cells(element, first, coding), part.type, points.size(), kName,
                            cells);
}

/// The text without appended data, which need not be XML, and these.
struct Parts {
  std::string head;
  std::string_view appended;
};

Parts parts_of(std::string_view text) {
  const std::size_t begin = text.find("<AppendedData");
  if (begin == std::string_view::npos) return {std::string(text), {}};
  const std::size_t end = text.find('>', begin), mark = text.find('_', end);
  if (mark == std::string_view::npos) fail("the appended data have no beginning (\"_\")");
  return {std::string(text.substr(0, end + 1)) + "</AppendedData></VTKFile>",
          text.substr(mark + 1)};
}

Coding coding_of(const pugi::xml_node& file, std::string_view appended) {
  Coding coding;
  coding.is_big_endian = attribute(file, "byte_order") == "BigEndian";
  coding.is_wide = attribute(file, "header_type") == "UInt64";
  const std::string_view compressor = attribute(file, "compressor");
  coding.is_compressed = !compressor.empty();
  if (coding.is_compressed && compressor != "vtkZLibDataCompressor")
    fail("arrays compressed by " + quoted(std::string(compressor.substr(0, 40))) +
         "; save it compressed by zlib, or not at all");
  coding.appended = appended;
  coding.is_appended_base64 = attribute(file.child("AppendedData"), "encoding") == "base64";
  return coding;
}

}  // namespace

bool starts_vtk_xml(std::string_view content) {
  const std::string_view begin = content.substr(0, 4096);
  const std::size_t place = begin.find("<VTKFile");
  return begin.substr(0, begin.find_first_not_of(" \t\r\n") + 1).ends_with('<') &&
         place != std::string_view::npos;
}

MeshFile read_vtk_xml(std::string_view text) {
  const Parts parts = parts_of(text);
  pugi::xml_document document;
  const auto parsed = document.load_buffer(parts.head.data(), parts.head.size());
  if (!parsed)
    fail("the XML is broken at byte " + std::to_string(parsed.offset) + " (" +
         parsed.description() + ")");
  const pugi::xml_node file = document.child("VTKFile");
  const std::string type(attribute(file, "type"));
  if (type != "UnstructuredGrid" && type != "PolyData")
    fail(
        "a data set of kind " + quoted(type.substr(0, 40)) +
        "; expected UnstructuredGrid or PolyData: extract its surface, or merge its blocks, first");
  const Coding coding = coding_of(file, parts.appended);
  std::vector<Point> points;
  detail::Cells cells;
  bool has_data = false;
  const pugi::xml_node set = file.child(type.c_str());
  for (const pugi::xml_node& piece : set.children("Piece")) {
    read_piece(piece, coding, points, cells);
    has_data |= piece.child("PointData").first_child() || piece.child("CellData").first_child();
  }
  std::vector<std::string> notes;
  if (has_data) notes.push_back("data of the points and the cells not read");
  if (set.child("FieldData").first_child()) notes.push_back("data of the whole not read");
  return cells.finish(std::move(points), {}, std::move(notes), kName, 0);
}

}  // namespace tripus::meshing

namespace tripus::meshing::registered_mesh_formats {
std::span<const MeshFormat> vtk_xml() {
  static constexpr MeshFormat kRows[] = {
      {"VTK XML", matches_content<starts_vtk_xml>, read_content<read_vtk_xml>, 2}};
  return kRows;
}

}  // namespace tripus::meshing::registered_mesh_formats
