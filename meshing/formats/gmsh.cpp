#include <algorithm>
#include <array>
#include <optional>
#include <unordered_map>
#include <utility>

#include "meshing/detail/bytes.hpp"
#include "meshing/detail/faces.hpp"
#include "meshing/detail/scanner.hpp"
#include "meshing/detail/text.hpp"
#include "meshing/formats/formats.hpp"
#include "meshing/validate_tetrahedra.hpp"

namespace tripus::meshing {
namespace {

using detail::Bytes;
using detail::Scanner;

struct Element {
  std::uint32_t type;
  std::size_t nodes;
  enum Use { kLeaveOut, kFace, kTetrahedron, kRefuse } use;
  std::size_t corners;
  std::string_view name = "";
};

/// Gmsh's types of elements; of the curved ones the corners come first.
constexpr std::array kElements{
    Element{1, 2, Element::kLeaveOut, 0},
    Element{2, 3, Element::kFace, 3},
    Element{3, 4, Element::kFace, 4},
    Element{4, 4, Element::kTetrahedron, 4},
    Element{5, 8, Element::kRefuse, 0, "hexahedron"},
    Element{6, 6, Element::kRefuse, 0, "prism"},
    Element{7, 5, Element::kRefuse, 0, "pyramid"},
    Element{8, 3, Element::kLeaveOut, 0},
    Element{9, 6, Element::kFace, 3},
    Element{10, 9, Element::kFace, 4},
    Element{11, 10, Element::kTetrahedron, 4},
    Element{12, 27, Element::kRefuse, 0, "hexahedron"},
    Element{13, 18, Element::kRefuse, 0, "prism"},
    Element{14, 14, Element::kRefuse, 0, "pyramid"},
    Element{15, 1, Element::kLeaveOut, 0},
    Element{16, 8, Element::kFace, 4},
    Element{17, 20, Element::kRefuse, 0, "hexahedron"},
    Element{18, 15, Element::kRefuse, 0, "prism"},
    Element{19, 13, Element::kRefuse, 0, "pyramid"},
    Element{20, 9, Element::kFace, 3},
    Element{21, 10, Element::kFace, 3},
    Element{23, 15, Element::kFace, 3},
    Element{25, 21, Element::kFace, 3},
    Element{26, 4, Element::kLeaveOut, 0},
    Element{27, 5, Element::kLeaveOut, 0},
    Element{28, 6, Element::kLeaveOut, 0},
    Element{29, 20, Element::kTetrahedron, 4},
    Element{30, 35, Element::kTetrahedron, 4},
    Element{31, 56, Element::kTetrahedron, 4},
    Element{36, 16, Element::kFace, 4},
    Element{37, 25, Element::kFace, 4},
};

/// Numbers between the lines of text: words, or bytes.
class Numbers {
 public:
  explicit Numbers(std::string_view text) : text_("Gmsh mesh", text, '\0') {}

  Scanner& text() { return text_; }
  bool is_binary() const { return is_binary_; }
  std::uint32_t line() const { return is_binary_ ? 0 : text_.line(); }
  void set_binary() {
    is_binary_ = true;
    begin_block();
    is_big_endian_ = read<std::int32_t>() != 1;
  }
  void set_wide(bool wide) { is_wide_ = wide; }
  /// After the name of a section, and after counts in text.
  void begin_block() {
    if (is_binary_) text_.next_line();
  }

  std::uint64_t integer() {
    if (!is_binary_) return text_.natural("a whole number");
    const auto value = read<std::int32_t>();
    if (value < 0) text_.fail(std::to_string(value) + " where a number of Gmsh was expected");
    return static_cast<std::uint64_t>(value);
  }
  /// Tags of entities may be negative; nobody needs them.
  void skip_integer() { tag(); }
  double tag() { return is_binary_ ? read<std::int32_t>() : text_.number("a tag"); }
  std::uint64_t size() {
    if (!is_binary_) return text_.natural("a whole number");
    return is_wide_ ? read<std::uint64_t>() : read<std::uint32_t>();
  }
  double real() { return is_binary_ ? read<double>() : text_.number("a coordinate"); }
  void require_room(std::uint64_t count, std::size_t bytes) const {
    if (count > text_.room(is_binary_ ? bytes : 2))
      text_.fail(std::to_string(count) +
                 " entries announced, more than the file is long enough for");
  }

 private:
  template <class Number>
  Number read() {
    Bytes bytes("Gmsh mesh", text_.rest(), is_big_endian_);
    if (text_.rest().size() < sizeof(Number)) text_.fail("the file ends within a section");
    const auto value = bytes.take<Number>("a number");
    text_.skip_bytes(sizeof(Number));
    return value;
  }

  Scanner text_;
  bool is_binary_ = false, is_big_endian_ = false, is_wide_ = true;
};

class Reader {
 public:
  explicit Reader(std::string_view text) : in_(text) {}

  MeshFile read() {
    std::string_view head = in_.text().word();
    for (; head == "$Comments"; head = in_.text().word()) skip_section("Comments");
    if (head != "$MeshFormat") in_.text().fail("the file does not begin with \"$MeshFormat\"");
    read_format();
    for (std::string_view name = in_.text().word(); !name.empty(); name = in_.text().word()) {
      if (name == "$Nodes") {
        is_new_ ? read_nodes() : read_nodes_2();
      } else if (name == "$Elements") {
        is_new_ ? read_elements() : read_elements_2();
      } else if (name.starts_with("$End")) {
        continue;
      } else if (name.starts_with('$')) {
        skip_section(name.substr(1));
      } else {
        in_.text().fail(quoted(std::string(name.substr(0, 32))) +
                        " where a section ($Nodes, $Elements, ...) was expected");
      }
    }
    std::vector<std::string> notes;
    if (has_data_) notes.push_back("physical groups and data not read");
    return cells_.finish(std::move(points_), std::move(lines_), std::move(notes), "Gmsh mesh", 1);
  }

 private:
  void read_format() {
    const std::string version(in_.text().word());
    if (version != "4.1" && !version.starts_with('2'))
      in_.text().fail("version " + quoted(version.substr(0, 16)) +
                      "; 2.2 and 4.1 are read: save it as such (gmsh FILE -save -format msh41)");
    is_new_ = version == "4.1";
    const std::string_view coding = in_.text().word();
    in_.set_wide(in_.text().natural("the size of numbers") == 8);
    if (coding == "1") in_.set_binary();
  }

  void skip_section(std::string_view name) {
    has_data_ |= name != "Entities" && name != "Periodic" && name != "PartitionedEntities" &&
                 name != "Comments";
    const std::string end = "$End" + std::string(name.substr(0, 64));
    const std::size_t place = in_.text().rest().find(end);
    if (place == std::string_view::npos) in_.text().fail("the file ends before " + quoted(end));
    in_.text().skip_counted(place);
    in_.text().word();
  }

  void add_node(std::uint64_t tag, const Point& point, std::uint32_t line) {
    const auto number = static_cast<std::uint32_t>(points_.size());
    if (!number_.try_emplace(tag, number).second)
      in_.text().fail("a second point with the number " + std::to_string(tag));
    points_.push_back(point);
    if (line > 0) lines_.points.push_back(line);
  }
  Point point() {
    Point p;
    for (double& x : p) x = in_.real();
    return p;
  }

  void read_nodes_2() {
    const std::uint32_t count = in_.text().natural("the number of points");
    in_.require_room(count, 28);
    in_.begin_block();
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint64_t tag = in_.integer();
      add_node(tag, point(), in_.line());
    }
  }

  void read_nodes() {
    in_.begin_block();
    const std::uint64_t blocks = in_.size();
    for (int k = 0; k < 3; ++k) in_.size();
    std::vector<std::uint64_t> tags;
    for (std::uint64_t b = 0; b < blocks; ++b) {
      const std::uint64_t dimension = in_.integer();
      in_.skip_integer();
      const bool parametric = in_.integer() != 0;
      const std::uint64_t count = in_.size();
      in_.require_room(count, 28);
      tags.clear();
      for (std::uint64_t i = 0; i < count; ++i) tags.push_back(in_.size());
      for (const std::uint64_t tag : tags) {
        add_node(tag, point(), in_.line());
        if (parametric)
          for (std::uint64_t k = 0; k < std::min<std::uint64_t>(dimension, 3); ++k) in_.real();
      }
    }
  }

  const Element& element_of(std::uint64_t type) {
    const auto found = std::find_if(kElements.begin(), kElements.end(),
                                    [&](const Element& e) { return e.type == type; });
    if (found == kElements.end() || found->use == Element::kRefuse)
      in_.text().fail(
          "an element of Gmsh's type " + std::to_string(type) +
          (found == kElements.end() ? std::string() : " (" + std::string(found->name) + ")") +
          "; only triangles, quadrilaterals and tetrahedra are read: cut the cells into "
          "tetrahedra first");
    return *found;
  }

  /// The nodes of one element, of which the corners count.
  template <class Next>
  void read_element(const Element& element, Next next) {
    corners_.clear();
    for (std::size_t k = 0; k < element.nodes; ++k) {
      const std::uint64_t tag = next();
      if (k >= element.corners) continue;
      const auto found = number_.find(tag);
      if (found == number_.end())
        in_.text().fail("point " + std::to_string(tag) + " does not exist among the " +
                        std::to_string(points_.size()) + " points of the file");
      corners_.push_back(found->second);
    }
    if (element.use == Element::kLeaveOut) return cells_.add_left_out();
    if (element.nodes > element.corners) cells_.add_curved();
    if (element.use == Element::kTetrahedron) {
      cells_.add_tetrahedron({corners_[0], corners_[1], corners_[2], corners_[3]}, in_.line());
    } else {
      cells_.add_face(corners_, in_.line());
    }
  }

  /// The first tag of an element is its physical group.
  void note_group(const Element& element, double group) {
    if (element.use == Element::kLeaveOut) return;
    auto& first = element.use == Element::kFace ? group_of_faces_ : group_of_tetrahedra_;
    if (!first) first = group;
    has_data_ |= group != *first;
  }

  void read_elements_2() {
    const std::uint32_t count = in_.text().natural("the number of elements");
    in_.require_room(count, 8);
    in_.begin_block();
    for (std::uint32_t i = 0; i < count;) {
      if (!in_.is_binary()) in_.integer();  // its number
      const Element& element = element_of(in_.integer());
      const std::uint64_t follow = in_.is_binary() ? in_.integer() : 1;
      const std::uint64_t tags = in_.integer();
      if (follow == 0 || follow > count - i)
        in_.text().fail("a block of " + std::to_string(follow) + " elements of " +
                        std::to_string(count));
      for (std::uint64_t k = 0; k < follow; ++k, ++i) {
        if (in_.is_binary()) in_.integer();
        for (std::uint64_t tag = 0; tag < tags; ++tag)
          tag == 0 ? note_group(element, in_.tag()) : in_.skip_integer();
        read_element(element, [&] { return in_.integer(); });
      }
    }
  }

  void read_elements() {
    in_.begin_block();
    const std::uint64_t blocks = in_.size();
    for (int k = 0; k < 3; ++k) in_.size();
    for (std::uint64_t b = 0; b < blocks; ++b) {
      in_.integer();
      in_.skip_integer();
      const Element& element = element_of(in_.integer());
      const std::uint64_t count = in_.size();
      in_.require_room(count, 8);
      for (std::uint64_t i = 0; i < count; ++i) {
        in_.size();  // its number
        read_element(element, [&] { return in_.size(); });
      }
    }
  }

  Numbers in_;
  bool is_new_ = false, has_data_ = false;
  std::optional<double> group_of_faces_, group_of_tetrahedra_;
  std::vector<Point> points_;
  SourceLines lines_;
  std::unordered_map<std::uint64_t, std::uint32_t> number_;
  detail::Cells cells_;
  std::vector<std::uint32_t> corners_;
};

}  // namespace

MeshFile read_gmsh(std::string_view text) { return Reader(text).read(); }

std::string write_gmsh(const TetrahedralMesh& mesh) {
  const std::vector<Triangle> boundary = boundary_triangles(mesh);
  std::string out =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" + std::to_string(mesh.points.size()) + "\n";
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    out += std::to_string(i + 1) + " ";
    detail::append_numbers(out, mesh.points[i]);
  }
  out += "$EndNodes\n$Elements\n" + std::to_string(boundary.size() + mesh.tetrahedra.size()) + "\n";
  std::size_t number = 0;
  const auto append = [&](const char* type_and_tags, const auto& cell) {
    out += std::to_string(++number) + type_and_tags;
    for (const std::uint32_t corner : cell) out += " " + std::to_string(corner + 1);
    out += "\n";
  };
  for (const Triangle& t : boundary) append(" 2 2 1 1", t);
  for (const Tetrahedron& t : mesh.tetrahedra) append(" 4 2 1 1", t);
  return out + "$EndElements\n";
}

}  // namespace tripus::meshing

namespace tripus::meshing::registered_mesh_formats {
namespace {

bool matches(std::string_view content, std::string_view) {
  const std::string_view word = detail::first_word(content);
  return word == "$MeshFormat" ||
         (word == "$Comments" && content.find("$MeshFormat") != std::string_view::npos);
}

}  // namespace

std::span<const MeshFormat> gmsh() {
  static constexpr MeshFormat kRows[] = {{"Gmsh mesh", matches, read_content<read_gmsh>, 6}};
  return kRows;
}

}  // namespace tripus::meshing::registered_mesh_formats
