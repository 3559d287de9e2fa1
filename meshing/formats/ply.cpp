#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "meshing/detail/bytes.hpp"
#include "meshing/detail/faces.hpp"
#include "meshing/detail/scanner.hpp"
#include "meshing/detail/text.hpp"
#include "meshing/formats/formats.hpp"

namespace tripus::meshing {
namespace {

using detail::Bytes;
using detail::Scanner;

enum class Type { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat, kDouble };

struct TypeName {
  std::string_view name;
  Type type;
};
constexpr std::array<TypeName, 16> kTypeNames{{{"char", Type::kInt8},
                                               {"int8", Type::kInt8},
                                               {"uchar", Type::kUint8},
                                               {"uint8", Type::kUint8},
                                               {"short", Type::kInt16},
                                               {"int16", Type::kInt16},
                                               {"ushort", Type::kUint16},
                                               {"uint16", Type::kUint16},
                                               {"int", Type::kInt32},
                                               {"int32", Type::kInt32},
                                               {"uint", Type::kUint32},
                                               {"uint32", Type::kUint32},
                                               {"float", Type::kFloat},
                                               {"float32", Type::kFloat},
                                               {"double", Type::kDouble},
                                               {"float64", Type::kDouble}}};

std::size_t bytes_of(Type type) {
  constexpr std::array<std::size_t, 8> kBytes{1, 1, 2, 2, 4, 4, 4, 8};
  return kBytes[static_cast<std::size_t>(type)];
}

struct Property {
  std::string_view name;
  Type type;
  std::optional<Type> count;  ///< of a list
};

struct Element {
  std::string_view name;
  std::uint32_t count = 0;
  std::vector<Property> properties;
};

enum class Coding { kText, kLittleEndian, kBigEndian };

struct Header {
  Coding coding = Coding::kText;
  std::vector<Element> elements;
};

/// More than any program writes; each costs memory and a step for every point.
constexpr std::size_t kMostProperties = 1000;

Type read_type(Scanner& in) {
  const std::string_view word = in.word_of_line();
  const auto found = std::find_if(kTypeNames.begin(), kTypeNames.end(),
                                  [&](const TypeName& each) { return each.name == word; });
  if (found == kTypeNames.end())
    in.fail(quoted(std::string(word.substr(0, 32))) + " is not a type of PLY");
  return found->type;
}

Coding read_coding(Scanner& in) {
  const std::string_view word = in.word_of_line();
  if (word == "ascii") return Coding::kText;
  if (word == "binary_little_endian") return Coding::kLittleEndian;
  if (word == "binary_big_endian") return Coding::kBigEndian;
  in.fail("format " + quoted(std::string(word.substr(0, 32))) +
          "; expected ascii, binary_little_endian or binary_big_endian");
}

void read_property(Scanner& in, Header& header) {
  if (header.elements.empty()) in.fail("a property before the first element");
  Element& element = header.elements.back();
  if (element.properties.size() == kMostProperties) in.fail("too many properties");
  Property property;
  Scanner ahead = in;
  if (ahead.word_of_line() == "list") {
    in = ahead;
    property.count = read_type(in);
  }
  property.type = read_type(in);
  property.name = in.word_of_line();
  element.properties.push_back(property);
}

/// Leaves `in` on the line of "end_header".
Header read_header(Scanner& in) {
  Header header;
  bool has_format = false;
  while (in.next_line()) {
    const std::string_view key = in.word_of_line();
    if (key == "end_header") {
      if (!has_format) in.fail("the header has no format");
      return header;
    }
    if (key == "format") {
      header.coding = read_coding(in);
      has_format = true;
    } else if (key == "element") {
      if (header.elements.size() == kMostProperties) in.fail("too many elements");
      Element element;
      element.name = in.word_of_line();
      element.count = in.natural(in.word_of_line(), "the number of elements");
      header.elements.push_back(element);
    } else if (key == "property") {
      read_property(in, header);
    } else if (!key.empty() && key != "comment" && key != "obj_info") {
      in.fail(quoted(std::string(key.substr(0, 32))) + " in the header");
    }
  }
  in.fail("the file ends before \"end_header\"");
}

/// Values one after the other, from text or bytes.
class Values {
 public:
  Values(Coding coding, Scanner text)
      : text_(text),
        bytes_("PLY", text.rest(), coding == Coding::kBigEndian),
        is_text_(coding == Coding::kText) {}

  double take(Type type) {
    if (is_text_) return text_.number("a value");
    switch (type) {
      case Type::kInt8:
        return bytes_.take<std::int8_t>("a value");
      case Type::kUint8:
        return bytes_.take<std::uint8_t>("a value");
      case Type::kInt16:
        return bytes_.take<std::int16_t>("a value");
      case Type::kUint16:
        return bytes_.take<std::uint16_t>("a value");
      case Type::kInt32:
        return bytes_.take<std::int32_t>("a value");
      case Type::kUint32:
        return bytes_.take<std::uint32_t>("a value");
      case Type::kFloat:
        return static_cast<double>(bytes_.take<float>("a value"));
      case Type::kDouble:
        break;
    }
    return bytes_.take<double>("a value");
  }
  /// A whole number below `limit`.
  std::uint32_t take_natural(Type type, std::size_t limit, std::string_view what) {
    const double value = take(type);
    if (!(value >= 0 && value < static_cast<double>(limit)))
      fail(detail::number_text(value) + " where " + std::string(what) + " below " +
           std::to_string(limit) + " was expected");
    const auto whole = static_cast<std::uint32_t>(value);
    if (static_cast<double>(whole) != value)
      fail(detail::number_text(value) + " where a whole number was expected");
    return whole;
  }
  void require_room(const Element& element) const {
    std::size_t least = 0;
    for (const Property& property : element.properties)
      least += is_text_ ? 2 : bytes_of(property.count.value_or(property.type));
    const std::size_t room = is_text_ ? text_.rest().size() + 1 : bytes_.rest().size();
    if (least == 0 && element.count > 0)
      fail("element " + quoted(std::string(element.name.substr(0, 32))) + " has no properties");
    if (element.count > 0 && element.count > room / least)
      fail(std::to_string(element.count) + " announced as the number of " +
           quoted(std::string(element.name.substr(0, 32))) +
           ", more than the file is long enough for");
  }
  std::uint32_t line() const { return is_text_ ? text_.line() : 0; }
  [[noreturn]] void fail(const std::string& what) const {
    if (is_text_) text_.fail(what);
    bytes_.fail(what);
  }
  [[noreturn]] void fail_at(std::uint32_t line, const std::string& what) const {
    if (is_text_) text_.fail_at(line, what);
    throw InvalidInput("PLY: " + what);
  }

 private:
  Scanner text_;
  Bytes bytes_;
  bool is_text_;
};

void skip_property(Values& in, const Property& property) {
  std::uint32_t count = 1;
  if (property.count) count = in.take_natural(*property.count, UINT32_MAX, "a length of a list");
  for (std::uint32_t i = 0; i < count; ++i) in.take(property.type);
}

void read_points(Values& in, const Element& element, SurfaceFile& file) {
  constexpr std::array<std::string_view, 3> kNames{"x", "y", "z"};
  for (const std::string_view name : kNames)
    if (std::none_of(element.properties.begin(), element.properties.end(),
                     [&](const Property& p) { return p.name == name && !p.count; }))
      in.fail("the element \"vertex\" has no property " + quoted(std::string(name)));
  file.mesh.points.reserve(element.count);
  for (std::uint32_t i = 0; i < element.count; ++i) {
    Point point{};
    for (const Property& property : element.properties) {
      const auto axis = std::find(kNames.begin(), kNames.end(), property.name) - kNames.begin();
      if (axis < 3 && !property.count) {
        point[static_cast<std::size_t>(axis)] = in.take(property.type);
      } else {
        skip_property(in, property);
      }
    }
    file.mesh.points.push_back(point);
    if (in.line() > 0) file.lines.points.push_back(in.line());
  }
}

/// The corners of a list, of which -1 may end a strip.
constexpr std::uint32_t kStripEnd = UINT32_MAX;

void read_list(Values& in, const Property& property, bool is_strip,
               std::vector<std::uint32_t>& corners) {
  const std::uint32_t sides = in.take_natural(*property.count, UINT32_MAX, "a number of corners");
  corners.clear();
  for (std::uint32_t k = 0; k < sides; ++k) {
    const double value = in.take(property.type);
    if (is_strip && value == -1) {
      corners.push_back(kStripEnd);
      continue;
    }
    if (!(value >= 0 && value < UINT32_MAX - 1) || value != std::floor(value))
      in.fail(detail::number_text(value) + " where the number of a point was expected");
    corners.push_back(static_cast<std::uint32_t>(value));
  }
}

void add_strips(std::span<const std::uint32_t> corners, std::uint32_t line, detail::Faces& faces) {
  while (!corners.empty()) {
    const auto end = std::find(corners.begin(), corners.end(), kStripEnd) - corners.begin();
    const auto length = static_cast<std::size_t>(end);
    faces.add_strip(corners.first(length), line);
    corners = corners.subspan(std::min(length + 1, corners.size()));
  }
}

void read_faces(Values& in, const Element& element, bool is_strip, detail::Faces& faces) {
  const auto is_list = [](const Property& p) {
    return p.count && (p.name == "vertex_indices" || p.name == "vertex_index");
  };
  if (std::count_if(element.properties.begin(), element.properties.end(), is_list) != 1)
    in.fail("the element " + quoted(std::string(element.name)) +
            " needs one list property \"vertex_indices\"");
  std::vector<std::uint32_t> corners;
  for (std::uint32_t i = 0; i < element.count; ++i) {
    for (const Property& property : element.properties) {
      if (!is_list(property)) {
        skip_property(in, property);
        continue;
      }
      read_list(in, property, is_strip, corners);
      if (is_strip) {
        add_strips(corners, in.line(), faces);
      } else {
        faces.add(corners, in.line());
      }
    }
  }
}

void require_corners_exist(const Values& in, const detail::Faces& faces, std::size_t points) {
  for (std::size_t f = 0; f < faces.count(); ++f)
    for (const std::uint32_t corner : faces.corners(f))
      if (corner >= points)
        in.fail_at(faces.line(f), "face " + std::to_string(f) + ": point " +
                                      std::to_string(corner) + " does not exist; the file has " +
                                      std::to_string(points) + " points, numbered from 0");
}

/// "normals", say: what of the points and faces nobody reads.
std::vector<std::string> notes_of(const Header& header) {
  std::vector<std::string> notes;
  for (const Element& element : header.elements) {
    std::string names;
    const bool is_known =
        element.name == "vertex" || element.name == "face" || element.name == "tristrips";
    for (const Property& p : element.properties) {
      const bool is_read = p.name == "x" || p.name == "y" || p.name == "z" ||
                           p.name == "vertex_indices" || p.name == "vertex_index";
      if (is_known && !is_read && names.size() < 60)
        names += (names.empty() ? "" : ", ") + std::string(p.name.substr(0, 32));
    }
    if (!is_known && element.count > 0) {
      notes.push_back("element " + quoted(std::string(element.name.substr(0, 32))) + " not read");
    } else if (!names.empty()) {
      notes.push_back("properties of " + quoted(std::string(element.name)) + " not read: " + names);
    }
  }
  return notes;
}

}  // namespace

SurfaceFile read_ply(std::string_view text) {
  Scanner in("PLY", text, '\0');
  if (in.word_of_line() != "ply") in.fail("the file does not begin with \"ply\"");
  const Header header = read_header(in);
  in.next_line();
  Values values(header.coding, in);
  SurfaceFile file;
  detail::Faces faces;
  bool has_points = false, has_faces = false;
  for (const Element& element : header.elements) {
    values.require_room(element);
    if (element.name == "vertex" && !has_points) {
      read_points(values, element, file);
      has_points = true;
    } else if (element.name == "face" || element.name == "tristrips") {
      read_faces(values, element, element.name == "tristrips", faces);
      has_faces = true;
    } else {
      for (std::uint32_t i = 0; i < element.count; ++i)
        for (const Property& property : element.properties) skip_property(values, property);
    }
  }
  if (!has_points || !has_faces)
    values.fail("the file has no element " + std::string(has_points ? "\"face\"" : "\"vertex\""));
  require_corners_exist(values, faces, file.mesh.points.size());
  file.notes = notes_of(header);
  faces.finish(file);
  return file;
}

std::string write_ply(const SurfaceMesh& mesh) {
  std::string out = "ply\nformat binary_little_endian 1.0\ncomment a surface, by Tripus\n";
  out += "element vertex " + std::to_string(mesh.points.size()) +
         "\nproperty double x\nproperty double y\nproperty double z\n";
  out += "element face " + std::to_string(mesh.triangles.size()) +
         "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Point& point : mesh.points)
    for (const double x : point) detail::append_little_endian(out, x);
  for (const Triangle& t : mesh.triangles) {
    out.push_back(3);
    for (const std::uint32_t corner : t) detail::append_little_endian(out, corner);
  }
  return out;
}

}  // namespace tripus::meshing

namespace tripus::meshing::registered_mesh_formats {
namespace {

bool matches(std::string_view content, std::string_view) {
  return detail::first_word(content) == "ply";
}

}  // namespace

std::span<const MeshFormat> ply() {
  static constexpr MeshFormat kRows[] = {{"PLY", matches, read_content<read_ply>, 4}};
  return kRows;
}

}  // namespace tripus::meshing::registered_mesh_formats
