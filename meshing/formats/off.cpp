#include <algorithm>
#include <optional>

#include "meshing/detail/bytes.hpp"
#include "meshing/detail/faces.hpp"
#include "meshing/detail/scanner.hpp"
#include "meshing/detail/text.hpp"
#include "meshing/formats/formats.hpp"

// Geomview reads by tokens, others by lines, and writers follow either. Which it is shows only when
// all of the file fits: the layouts are tried one after the other, and the message is that of the
// one which the file looks like.

namespace tripus::meshing {
namespace {

using detail::Bytes;
using detail::Faces;
using detail::Scanner;

struct Header {
  bool texture = false, colour = false, normal = false, homogeneous = false, any_dimension = false;
  bool binary = false;
  std::size_t dimension = 3;

  /// Numbers of one point.
  std::size_t columns() const {
    return dimension + (homogeneous ? 1 : 0) + (normal ? dimension : 0) + (colour ? 4 : 0) +
           (texture ? 2 : 0);
  }
  bool has_more_than_places() const { return normal || colour || texture; }
};

void note_left_out(SurfaceFile& file, bool of_points, bool of_faces) {
  if (of_points) file.notes.push_back("normals, colours and textures of the points not read");
  if (of_faces) file.notes.push_back("colours of the faces not read");
}

/// The letters in front of OFF, in Geomview's order; nothing if it is no header.
std::optional<Header> parse_keyword(std::string_view prefix) {
  Header header;
  const auto take = [&](std::string_view letters) {
    const bool there = prefix.starts_with(letters);
    if (there) prefix.remove_prefix(letters.size());
    return there;
  };
  header.texture = take("ST");
  header.colour = take("C");
  header.normal = take("N");
  header.homogeneous = take("4");
  header.any_dimension = take("n");
  if (!header.texture) header.texture = take("ST");  // MeshLab writes NCSTOFF and the like
  if (!header.colour) header.colour = take("C");
  if (!header.texture) header.texture = take("ST");
  if (!prefix.empty()) return std::nullopt;
  return header;
}

/// The head of a text: the keyword is read, and what touched it is left in place.
struct Start {
  Header header;
  Scanner rest;
  std::string_view behind = {};  ///< behind the brace that closes it
};

bool is_count(std::string_view word) {
  return !word.empty() && word.find_first_not_of("0123456789") == std::string_view::npos;
}

std::optional<Start> find_start(std::string_view text) {
  Scanner in("OFF", text, '#');
  const bool in_braces = detail::skip_oogl_wrapping(in);
  const std::string_view head = in.word();
  const std::size_t end = head == "off" ? 0 : head.find("OFF");
  if (end == std::string_view::npos || end > 6) return std::nullopt;
  auto header = parse_keyword(head.substr(0, end));
  if (!header) return std::nullopt;
  const std::string_view glued = head.substr(end + 3);
  if (!glued.empty() && !is_count(glued)) return std::nullopt;
  in.put_back(glued.size());
  Scanner ahead = in;
  const std::string_view next = ahead.word();
  if (next == "BINARY") {
    header->binary = true;
    return Start{*header, ahead};
  }
  if (next.empty() || next.front() < '0' || next.front() > '9') return std::nullopt;
  if (!in_braces) return Start{*header, in};
  // The same once more, of the text that ends with the brace.
  const auto place = static_cast<std::size_t>(in.rest().data() - text.data());
  const std::size_t close = std::min(text.find('}', place), text.size());
  in = Scanner("OFF", text.substr(0, close), '#');
  detail::skip_oogl_wrapping(in);
  in.word();
  in.put_back(glued.size());
  return Start{*header, in, text.substr(close)};
}

/// The keyword may be left out where the file's name says what it is.
std::optional<Start> find_start_without_keyword(std::string_view text) {
  const Scanner in("OFF", text, '#');
  Scanner ahead = in;
  for (int k = 0; k < 2; ++k)
    if (!is_count(ahead.word())) return std::nullopt;
  return Start{{}, in};
}

Point as_point(const Header& header, const std::vector<double>& numbers) {
  Point point{numbers[0], numbers[1], numbers[2]};
  if (header.homogeneous)
    for (double& x : point) x /= numbers[3];
  return point;
}

void require_three_dimensions(const Header& header, const Scanner& in) {
  if (header.dimension != 3)
    in.fail("points of " + std::to_string(header.dimension) +
            " dimensions; only surfaces in three dimensions are read");
}

/// How the numbers are laid out.
struct Layout {
  bool has_edges = true;        ///< the third count is there
  bool points_by_line = false;  ///< one a line; what follows the coordinates there is skipped
  bool face_colours = false;    ///< up to the end of the line
  bool small_faces = false;     ///< of fewer than three corners, which hardly anybody writes
};

class TextReader {
 public:
  TextReader(const Header& header, Scanner in, Layout layout)
      : header_(header), layout_(layout), in_(in) {}

  SurfaceFile read() {
    SurfaceFile file;
    if (header_.any_dimension) header_.dimension = in_.natural("the dimension");
    require_three_dimensions(header_, in_);
    const std::uint32_t points = in_.count("the number of points", 6);
    const std::uint32_t faces = in_.count("the number of faces", 2);
    if (layout_.has_edges) in_.natural("the number of edges");
    file.mesh.points.reserve(points);
    for (std::uint32_t i = 0; i < points; ++i) read_point(file);
    Faces collected;
    for (std::uint32_t i = 0; i < faces; ++i) read_face(file, collected, i, faces);
    read_end(faces);
    collected.finish(file);
    note_left_out(file, extras_ > 0 || header_.has_more_than_places(), colours_ > 0);
    return file;
  }

 private:
  void read_point(SurfaceFile& file) {
    const std::size_t coordinates = header_.dimension + (header_.homogeneous ? 1 : 0);
    numbers_.clear();
    if (layout_.points_by_line && !in_.word_of_line().empty())
      in_.fail("point " + std::to_string(file.mesh.points.size()) + " does not begin a line");
    for (std::size_t k = 0; k < coordinates; ++k)
      numbers_.push_back(layout_.points_by_line && k > 0
                             ? in_.number(in_.word_of_line(), "a coordinate")
                             : in_.number("a coordinate"));
    file.mesh.points.push_back(as_point(header_, numbers_));
    file.lines.points.push_back(in_.line());
    if (layout_.points_by_line) {
      while (!in_.word_of_line().empty()) ++extras_;
    } else {
      for (std::size_t k = coordinates; k < header_.columns(); ++k) in_.number("a number");
    }
  }

  void read_face(const SurfaceFile& file, Faces& faces, std::uint32_t i, std::uint32_t count) {
    const std::string_view sides = in_.word();
    if (sides.empty())
      in_.fail("the file ends after " + std::to_string(i) + " of " + std::to_string(count) +
               " faces");
    const std::uint32_t n = in_.natural(sides, "the number of corners of a face");
    if (n > in_.room(2)) in_.fail("a face of " + std::to_string(n) + " corners");
    if (n < 3 && !layout_.small_faces)
      in_.fail("face " + std::to_string(i) + " of " + std::to_string(n) + " corners");
    const std::uint32_t line = in_.line();
    corners_.clear();
    for (std::uint32_t k = 0; k < n; ++k)
      corners_.push_back(in_.index(in_.word(), 0, file.mesh.points.size()));
    faces.add(corners_, line);
    if (!layout_.face_colours) return;
    while (!in_.word_of_line().empty()) ++colours_;
  }

  void read_end(std::uint32_t faces) {
    if (const std::string_view extra = in_.word(); !extra.empty())
      in_.fail(quoted(std::string(extra.substr(0, 64))) + " after the last of " +
               std::to_string(faces) + " faces; are the counts at the top right?");
  }

  Header header_;
  Layout layout_;
  Scanner in_;
  std::vector<double> numbers_;
  std::vector<std::uint32_t> corners_;
  std::size_t extras_ = 0, colours_ = 0;
};

/// Whether the lines look as if each had one point and something after it.
bool has_more_columns(const Header& header, Scanner in) {
  if (header.any_dimension) in.word();
  in.word();
  in.word();
  in.next_line();
  while (in.rest_of_line().find_first_not_of(" \t\r\f\v") == std::string_view::npos)
    if (!in.next_line()) return false;
  std::size_t columns = 0;
  while (!in.word_of_line().empty()) ++columns;
  return columns > header.columns();
}

SurfaceFile read_text(const Header& header, const Scanner& in) {
  const bool more = has_more_columns(header, in);
  std::optional<InvalidInput> problem;
  for (const bool small : {false, true})
    for (const bool has_edges : {true, false})
      for (Layout layout :
           {Layout{has_edges, false, false, small}, Layout{has_edges, false, true, small},
            Layout{has_edges, true, true, small}}) {
        try {
          return TextReader(header, in, layout).read();
        } catch (const InvalidInput& error) {
          // Of the file as most write it: with edges, colours behind the faces.
          if (!problem ||
              (small && has_edges && layout.face_colours && layout.points_by_line == more))
            problem = error;
        }
      }
  throw *problem;
}

/// Geomview's own form has the most significant byte first and a count of colours behind each face;
/// OpenMesh writes neither.
struct BinaryLayout {
  bool is_big_endian = true, has_colour_counts = true;
};

SurfaceFile read_binary(Header header, const Scanner& in, BinaryLayout layout) {
  Scanner text = in;
  text.next_line();
  Bytes bytes("OFF", text.rest(), layout.is_big_endian);
  const auto natural = [&](std::string_view what) {
    const auto value = bytes.take<std::int32_t>(what);
    if (value < 0) bytes.fail(std::to_string(value) + " as " + std::string(what));
    return static_cast<std::uint32_t>(value);
  };
  if (header.any_dimension) header.dimension = natural("the dimension");
  require_three_dimensions(header, in);
  SurfaceFile file;
  const std::uint32_t points = natural("the number of points");
  const std::uint32_t faces = natural("the number of faces");
  natural("the number of edges");
  bytes.require_room(points, 4 * header.columns(), "points");
  std::vector<double> numbers(header.columns());
  for (std::uint32_t i = 0; i < points; ++i) {
    for (double& x : numbers) x = static_cast<double>(bytes.take<float>("a coordinate"));
    file.mesh.points.push_back(as_point(header, numbers));
  }
  bytes.require_room(faces, 8, "faces");
  Faces collected;
  std::vector<std::uint32_t> corners;
  bool has_face_colours = false;
  for (std::uint32_t i = 0; i < faces; ++i) {
    const std::uint32_t sides = natural("the number of corners of a face");
    bytes.require_room(sides, 4, "corners");
    corners.clear();
    for (std::uint32_t k = 0; k < sides; ++k)
      corners.push_back(bytes.index(bytes.take<std::int32_t>("an index"), points));
    collected.add(corners, 0);
    if (!layout.has_colour_counts) continue;
    const std::uint32_t colours = natural("the number of components of a colour");
    bytes.require_room(colours, 4, "components of a colour");
    bytes.skip(4 * std::size_t{colours});
    has_face_colours |= colours > 0;
  }
  collected.finish(file);
  note_left_out(file, header.has_more_than_places(), has_face_colours);
  return file;
}

SurfaceFile read_binary(const Header& header, const Scanner& in) {
  std::optional<InvalidInput> problem;
  for (const BinaryLayout layout : {BinaryLayout{true, true}, BinaryLayout{false, false},
                                    BinaryLayout{false, true}, BinaryLayout{true, false}}) {
    try {
      return read_binary(header, in, layout);
    } catch (const InvalidInput& error) {
      if (!problem) problem = error;
    }
  }
  throw *problem;
}

}  // namespace

bool starts_off(std::string_view content, bool by_name) {
  content = content.substr(0, 1 << 16);
  return find_start(content) || (by_name && find_start_without_keyword(content));
}

SurfaceFile read_off(std::string_view text) {
  auto start = find_start(text);
  if (!start) start = find_start_without_keyword(text);
  if (!start) Scanner("OFF", text, '#').fail("the file does not begin with OFF and its counts");
  if (start->behind.find("OFF") != std::string_view::npos)
    start->rest.fail("there are several surfaces in it; write them as one, or each to a file");
  return start->header.binary ? read_binary(start->header, start->rest)
                              : read_text(start->header, start->rest);
}

std::string write_off(const SurfaceMesh& mesh) {
  std::string out = "OFF\n" + std::to_string(mesh.points.size()) + " " +
                    std::to_string(mesh.triangles.size()) + " 0\n";
  for (const Point& point : mesh.points) detail::append_numbers(out, point);
  for (const Triangle& t : mesh.triangles)
    out += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) +
           "\n";
  return out;
}

}  // namespace tripus::meshing

namespace tripus::meshing::registered_mesh_formats {
namespace {

bool matches(std::string_view content, std::string_view name) {
  return starts_off(content, detail::has_ending(name, ".off"));
}

}  // namespace

std::span<const MeshFormat> off() {
  static constexpr MeshFormat kRows[] = {{"OFF", matches, read_content<read_off>, 3}};
  return kRows;
}

}  // namespace tripus::meshing::registered_mesh_formats
