#include <algorithm>
#include <array>

#include "meshing/detail/faces.hpp"
#include "meshing/detail/scanner.hpp"
#include "meshing/detail/text.hpp"
#include "meshing/formats/formats.hpp"

namespace tripus::meshing {
namespace {

using detail::ObjLine;
using detail::Scanner;

/// Lines that say nothing about the surface, and may come first.
constexpr std::array<std::string_view, 26> kSkipped{
    "vt",        "vn",     "vp",    "o",     "g",    "s",     "mg",       "usemtl",   "mtllib",
    "usemap",    "maplib", "l",     "p",     "lod",  "bevel", "c_interp", "d_interp", "shadow_obj",
    "trace_obj", "ctech",  "stech", "illum", "call", "csh",   "bmat",     "step"};
/// Curves and curved surfaces.
constexpr std::array<std::string_view, 17> kCurved{
    "cstype", "deg", "curv", "curv2", "surf", "parm", "trim", "hole", "scrv",
    "sp",     "end", "con",  "bsp",   "bzp",  "cdc",  "cdp",  "res"};

template <class Words>
bool is_in(const Words& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// The point of a corner "7", "7/1", "7//3" or "-1/2/3", counted from 0. It may come later in the
/// file, so only its sign is checked here.
std::uint32_t read_corner(const Scanner& in, std::string_view word, std::size_t points_so_far) {
  std::string_view digits = word.substr(0, word.find('/'));
  const bool relative = digits.starts_with('-');
  if (relative) digits.remove_prefix(1);
  const std::uint32_t value = in.natural(digits, "the number of a point");
  if (value == 0) in.fail("point 0 does not exist; OBJ numbers points from 1");
  if (!relative) return value - 1;
  if (value > points_so_far)
    in.fail("point -" + std::to_string(value) + " does not exist; so far there are " +
            std::to_string(points_so_far) + " points");
  return static_cast<std::uint32_t>(points_so_far) - value;
}

class Reader {
 public:
  explicit Reader(std::string_view text) : in_("OBJ", text, '#') {}

  SurfaceFile read() {
    do {
      const std::string_view key = ObjLine(in_).word();
      if (key.empty()) continue;
      read_line(key);
    } while (in_.next_line());
    for (std::size_t f = 0; f < faces_.count(); ++f)
      for (const std::uint32_t corner : faces_.corners(f))
        if (corner >= file_.mesh.points.size())
          in_.fail_at(faces_.line(f), "point " + std::to_string(corner + std::uint64_t{1}) +
                                          " does not exist; the file has " +
                                          std::to_string(file_.mesh.points.size()) +
                                          " points, numbered from 1");
    faces_.finish(file_);
    if (colours_) file_.notes.push_back("colours or weights of the points not read");
    if (looks_) file_.notes.push_back("normals, textures and materials not read");
    if (lines_ > 0)
      file_.notes.push_back(detail::counted(lines_, "line or point", "lines and points") +
                            " left out");
    return std::move(file_);
  }

 private:
  void read_line(std::string_view key) {
    if (key == "v") {
      read_point();
    } else if (key == "f" || key == "fo") {
      read_face();
    } else if (is_in(kSkipped, key)) {
      if (key == "l" || key == "p") ++lines_;
      if (key == "vn" || key == "vt" || key == "usemtl") looks_ = true;
      ObjLine(in_).skip();
    } else {
      in_.fail(quoted(std::string(key.substr(0, 32))) + " is not supported" +
               (is_in(kCurved, key) ? " (a curved surface)" : "") +
               "; save the surface as plain triangles (v and f lines)");
    }
  }

  void read_point() {
    ObjLine line(in_);
    Point point;
    for (double& x : point) x = in_.number(line.word(), "a coordinate");
    file_.mesh.points.push_back(point);
    file_.lines.points.push_back(in_.line());
    if (line.word().empty()) return;
    colours_ = true;
    line.skip();
  }

  void read_face() {
    const std::uint32_t number = in_.line();
    ObjLine line(in_);
    corners_.clear();
    for (std::string_view word = line.word(); !word.empty(); word = line.word())
      corners_.push_back(read_corner(in_, word, file_.mesh.points.size()));
    faces_.add(corners_, number);
  }

  Scanner in_;
  SurfaceFile file_;
  detail::Faces faces_;
  std::vector<std::uint32_t> corners_;
  std::size_t lines_ = 0;
  bool colours_ = false, looks_ = false;
};

/// A corner begins with a digit or a sign.
bool is_number(std::string_view word) {
  return !word.empty() &&
         (std::string_view("+-.0123456789").find(word.front()) != std::string_view::npos);
}

}  // namespace

bool starts_obj(std::string_view content) {
  Scanner in("", content.substr(0, 1 << 16), '#');
  do {
    ObjLine line(in);
    const std::string_view key = line.word();
    if (key.empty()) continue;
    if (key == "v" || key == "vn" || key == "vt" || key == "f") return is_number(line.word());
    if (!is_in(kSkipped, key) && !is_in(kCurved, key)) return false;
    line.skip();
  } while (in.next_line());
  return false;
}

SurfaceFile read_obj(std::string_view text) { return Reader(text).read(); }

std::string write_obj(const SurfaceMesh& mesh) {
  std::string out = "# a surface, by Tripus\n";
  for (const Point& point : mesh.points) {
    out += "v ";
    detail::append_numbers(out, point);
  }
  for (const Triangle& t : mesh.triangles)
    out += "f " + std::to_string(t[0] + 1) + " " + std::to_string(t[1] + 1) + " " +
           std::to_string(t[2] + 1) + "\n";
  return out;
}

}  // namespace tripus::meshing

namespace tripus::meshing::registered_mesh_formats {
std::span<const MeshFormat> obj() {
  static constexpr MeshFormat kRows[] = {
      {"Wavefront OBJ", matches_content<starts_obj>, read_content<read_obj>, 8}};
  return kRows;
}

}  // namespace tripus::meshing::registered_mesh_formats
