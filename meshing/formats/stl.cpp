#include "meshing/formats/stl.hpp"

#include <bit>
#include <unordered_map>

#include "meshing/detail/bytes.hpp"
#include "meshing/detail/scanner.hpp"

namespace tripus::meshing {
namespace {

using detail::Bytes;
using detail::Scanner;

struct PointHash {
  std::size_t operator()(const Point& p) const {
    std::uint64_t hash = 0x9e3779b97f4a7c15u;
    for (const double x : p) {
      hash ^= std::bit_cast<std::uint64_t>(x);
      hash *= 0xff51afd7ed558ccdu;
      hash ^= hash >> 32;
    }
    return static_cast<std::size_t>(hash);
  }
};

/// Gives equal corners one number.
class Welder {
 public:
  explicit Welder(SurfaceFile& file) : file_(file) {}

  std::uint32_t number_of(Point point, std::uint32_t line) {
    for (double& x : point)
      if (x == 0) x = 0;  // -0 and 0 are equal, and hash alike
    const auto next = static_cast<std::uint32_t>(file_.mesh.points.size());
    const auto [place, is_new] = numbers_.try_emplace(point, next);
    if (is_new) {
      file_.mesh.points.push_back(point);
      if (line > 0) file_.lines.points.push_back(line);
    }
    return place->second;
  }

 private:
  SurfaceFile& file_;
  std::unordered_map<Point, std::uint32_t, PointHash> numbers_;
};

void expect(Scanner& in, std::string_view wanted) {
  const std::string_view word = in.word();
  if (word != wanted)
    in.fail((word.empty() ? "the file ends" : quoted(std::string(word.substr(0, 32)))) + " where " +
            quoted(std::string(wanted)) + " was expected");
}

void read_facet(Scanner& in, Welder& welder, SurfaceFile& file) {
  const std::uint32_t line = in.line();
  expect(in, "normal");
  for (int k = 0; k < 3; ++k) {
    // Nobody needs the normal, and programs write nan for that of a thin triangle.
    if (in.word_of_line().empty()) in.fail("a normal needs three numbers");
  }
  expect(in, "outer");
  expect(in, "loop");
  Triangle triangle;
  for (std::uint32_t& corner : triangle) {
    expect(in, "vertex");
    const Point point = in.point();
    corner = welder.number_of(point, in.line());
  }
  expect(in, "endloop");
  expect(in, "endfacet");
  file.mesh.triangles.push_back(triangle);
  file.lines.cells.push_back(line);
}

SurfaceFile read_text(std::string_view text) {
  Scanner in("STL", text, '\0');
  SurfaceFile file;
  Welder welder(file);
  bool within = false;
  for (std::string_view word = in.word(); !word.empty(); word = in.word()) {
    if (word == "facet" && within) {
      read_facet(in, welder, file);
    } else if ((word == "solid" && !within) || (word == "endsolid" && within)) {
      within = word == "solid";
      while (!in.word_of_line().empty()) {
      }  // the name
    } else {
      in.fail(quoted(std::string(word.substr(0, 32))) + " where " +
              (within ? "\"facet\" or \"endsolid\"" : "\"solid\"") + " was expected");
    }
  }
  if (within) in.fail("the file ends before \"endsolid\"");
  return file;
}

constexpr std::size_t kHeader = 80;
constexpr std::size_t kFacet = 50;

SurfaceFile read_binary(std::string_view data) {
  Bytes in("STL", data, false);
  in.skip(kHeader);
  const auto count = in.take<std::uint32_t>("the number of triangles");
  in.require_room(count, kFacet, "triangles");
  SurfaceFile file;
  file.mesh.triangles.reserve(count);
  Welder welder(file);
  for (std::uint32_t t = 0; t < count; ++t) {
    in.skip(3 * sizeof(float));  // the normal
    Triangle triangle;
    for (std::uint32_t& corner : triangle) {
      Point point;
      for (double& x : point) x = static_cast<double>(in.take<float>("a coordinate"));
      corner = welder.number_of(point, 0);
    }
    in.skip(sizeof(std::uint16_t));
    file.mesh.triangles.push_back(triangle);
  }
  return file;
}

}  // namespace

bool is_binary_stl(std::string_view data) {
  if (data.size() < kHeader + sizeof(std::uint32_t)) return false;
  Bytes in("STL", data.substr(kHeader), false);
  const auto count = in.take<std::uint32_t>("");
  return data.size() == kHeader + sizeof(std::uint32_t) + kFacet * std::uint64_t{count};
}

SurfaceFile read_stl(std::string_view text) {
  return is_binary_stl(text) ? read_binary(text) : read_text(text);
}

}  // namespace tripus::meshing
