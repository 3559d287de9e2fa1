#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <unordered_map>

#include "meshing/detail/bytes.hpp"
#include "meshing/detail/faces.hpp"
#include "meshing/detail/point_hash.hpp"
#include "meshing/detail/polygon.hpp"
#include "meshing/detail/scanner.hpp"
#include "meshing/detail/text.hpp"
#include "meshing/formats/formats.hpp"

namespace tripus::meshing {
namespace {

using detail::Bytes;
using detail::Scanner;

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
  std::unordered_map<Point, std::uint32_t, detail::PointHash> numbers_;
};

std::string low(std::string_view word) { return detail::lowered(word.substr(0, 32)); }

/// The next word must be this; of "endloop" the two halves may stand apart.
void expect(Scanner& in, std::string_view wanted) {
  const std::string_view word = in.word();
  const std::string found = low(word);
  if (found == wanted) return;
  if (found == "end" && wanted.starts_with("end") && low(in.word()) == wanted.substr(3)) return;
  in.fail((word.empty() ? "the file ends" : quoted(std::string(word.substr(0, 32)))) + " where " +
          quoted(std::string(wanted)) + " was expected");
}

void read_facet(Scanner& in, Welder& welder, SurfaceFile& file) {
  const std::uint32_t line = in.line();
  // Nobody needs the normal, some leave it out, and programs write nan for that of a thin triangle.
  std::string word = low(in.word());
  if (word == "normal") {
    int numbers = 0;
    for (word = low(in.word()); numbers < 3 && word != "outer"; ++numbers) word = low(in.word());
    if (numbers < 3) in.fail("a normal needs three numbers");
  }
  if (word != "outer") in.fail(quoted(word) + " where \"outer loop\" was expected");
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
    std::string key = low(word);
    if (key == "end" && within) key += low(in.word());
    if (key == "facet" && within) {
      read_facet(in, welder, file);
    } else if ((key == "solid" && !within) || (key == "endsolid" && within)) {
      within = key == "solid";
      in.skip_line();  // the name
    } else if (key.find_first_not_of(std::string_view("\0\x1a", 2)) == std::string::npos) {
      break;  // zeros and the end mark of old systems, where the text has ended
    } else {
      in.fail(quoted(std::string(word.substr(0, 32))) + " where " +
              (within ? "\"facet\" or \"endsolid\"" : "\"solid\"") + " was expected");
    }
  }
  if (within && file.mesh.triangles.empty()) in.fail("the file ends before \"endsolid\"");
  if (within) file.notes.push_back("the file ends without \"endsolid\": is all of it there?");
  return file;
}

constexpr std::size_t kHeader = 80;
constexpr std::size_t kBegin = kHeader + sizeof(std::uint32_t);
constexpr std::size_t kFacet = 50;

std::uint64_t announced(std::string_view data) {
  return Bytes("STL", data.substr(kHeader), false).take<std::uint32_t>("the number of triangles");
}

/// Some programs write 0 and never come back to it.
std::uint64_t facet_count(std::string_view data) {
  const std::uint64_t count = announced(data);
  return count > 0 ? count : (data.size() - kBegin) / kFacet;
}

SurfaceFile read_binary(std::string_view data) {
  if (data.size() < kBegin)
    throw InvalidInput("STL, byte " + std::to_string(data.size()) +
                       ": the file ends before the number of triangles");
  const std::uint64_t count = facet_count(data);
  Bytes in("STL", data, false);
  in.skip(kBegin);
  in.require_room(count, kFacet, "triangles");
  SurfaceFile file;
  file.mesh.triangles.reserve(count);
  Welder welder(file);
  bool has_colours = false;
  for (std::uint64_t t = 0; t < count; ++t) {
    in.skip(3 * sizeof(float));  // the normal
    Triangle triangle;
    for (std::uint32_t& corner : triangle) {
      Point point;
      for (double& x : point) x = static_cast<double>(in.take<float>("a coordinate"));
      corner = welder.number_of(point, 0);
    }
    has_colours |= in.take<std::uint16_t>("the attribute of a triangle") != 0;
    file.mesh.triangles.push_back(triangle);
  }
  if (announced(data) == 0 && count > 0)
    file.notes.push_back("the count of triangles is 0: " + std::to_string(count) +
                         " taken, by the length of the file");
  if (!in.rest().empty())
    file.notes.push_back(detail::counted(in.rest().size(), "byte", "bytes") +
                         " after the last triangle left out");
  if (has_colours) file.notes.push_back("attributes of the triangles not read");
  return file;
}

/// "solid", and no byte that text does not have before the first vertex: binary files may begin so
/// as well.
bool is_text(std::string_view data) {
  if (low(Scanner("", data, '\0').word()) != "solid") return false;
  const std::string_view begin = data.substr(0, 1024);
  const std::size_t zero = begin.find('\0');
  return zero == std::string_view::npos || data.size() < kBegin ||
         detail::lowered(begin.substr(0, zero)).find("vertex") != std::string::npos;
}

/// The first triangle has numbers of a size that happens, and is no point.
bool has_likely_triangle(std::string_view data) {
  if (data.size() < kBegin + kFacet) return false;
  Bytes in("STL", data.substr(kBegin), false);
  std::array<float, 12> numbers;
  for (float& x : numbers) x = in.take<float>("a coordinate");
  for (std::size_t k = 3; k < 12; ++k)
    if (const float size = std::fabs(numbers[k]); !(size < 1e12f && (size == 0 || size > 1e-30f)))
      return false;
  return !std::equal(&numbers[3], &numbers[6], &numbers[6]);
}

}  // namespace

bool starts_stl(std::string_view data, bool by_name) {
  if (is_text(data)) return true;
  if (data.size() < kBegin) return false;
  const std::uint64_t size = kBegin + kFacet * facet_count(data);
  if (data.size() == size && announced(data) > 0) return true;
  const bool is_binary = data.substr(0, 4096).find('\0') != std::string_view::npos;
  return is_binary && (by_name || (data.size() >= size && has_likely_triangle(data)));
}

SurfaceFile read_stl(std::string_view text) {
  const bool fits = text.size() >= kBegin && text.size() == kBegin + kFacet * announced(text) &&
                    announced(text) > 0;
  return !fits && is_text(text) ? read_text(text) : read_binary(text);
}

std::string write_stl(const SurfaceMesh& mesh) {
  std::string out = "binary STL, by Tripus";
  out.resize(kHeader, ' ');
  detail::append_little_endian(out, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const Triangle& t : mesh.triangles) {
    const auto& p = mesh.points;
    for (const double x : detail::unit_normal(p[t[0]], p[t[1]], p[t[2]]))
      detail::append_little_endian(out, static_cast<float>(x));
    for (const std::uint32_t corner : t)
      for (const double x : p[corner]) detail::append_little_endian(out, static_cast<float>(x));
    detail::append_little_endian(out, std::uint16_t{0});
  }
  return out;
}

}  // namespace tripus::meshing

namespace tripus::meshing::registered_mesh_formats {
namespace {

bool matches(std::string_view content, std::string_view name) {
  return starts_stl(content, detail::has_ending(name, ".stl"));
}

}  // namespace

std::span<const MeshFormat> stl() {
  static constexpr MeshFormat kRows[] = {{"STL", matches, read_content<read_stl>, 7}};
  return kRows;
}

}  // namespace tripus::meshing::registered_mesh_formats
