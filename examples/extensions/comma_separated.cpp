// A format of one's own: a line "tetrahedron,face,neighbour,gluing" for each face, under a header
// of these words. This file is all that it takes: `tripus solve FILE` recognises it by its content.
#include <algorithm>
#include <optional>
#include <sstream>
#include <string>

#include "base/error.hpp"
#include "topology/formats/formats.hpp"

namespace tripus::topology::registered_formats {
namespace {

constexpr std::string_view kHeader = "tetrahedron,face,neighbour,gluing";
constexpr std::size_t kMost = 1000000;

bool has_header(std::string_view text) { return text.starts_with(kHeader); }

[[noreturn]] void refuse(std::size_t line, const std::string& what) {
  throw InvalidInput("line " + std::to_string(line) + ": " + what);
}

std::optional<Perm4> permutation(std::string_view word) {
  std::string sorted(word);
  std::ranges::sort(sorted);
  if (sorted != "0123") return std::nullopt;
  return Perm4::from_images(word[0] - '0', word[1] - '0', word[2] - '0', word[3] - '0');
}

NamedGluings read(std::string_view text) {
  std::istringstream lines{std::string(text)};
  std::string line;
  std::getline(lines, line);
  NamedGluings result;
  for (std::size_t number = 2; std::getline(lines, line); ++number) {
    std::size_t t = 0, neighbour = 0;
    int face = 0;
    char images[5] = "", comma[3] = "", more = 0;
    std::istringstream fields(line);
    fields >> t >> comma[0] >> face >> comma[1] >> neighbour >> comma[2];
    fields.get(images, sizeof images);
    if (!fields || fields >> more || std::string_view(comma, 3) != ",,,")
      refuse(number, "expected " + std::string(kHeader));
    if (t > kMost || neighbour > kMost) refuse(number, "too many tetrahedra");
    const auto gluing = permutation(images);
    if (face < 0 || face > 3 || !gluing) refuse(number, "a face is 0 to 3, a gluing like 1032");
    if (std::max(t, neighbour) >= result.gluings.tetrahedron_count())
      result.gluings.resize(std::max(t, neighbour) + 1);
    result.gluings.set_one_side(t, face, static_cast<TetrahedronIndex>(neighbour), *gluing);
  }
  require_consistent(result.gluings, OpenFaces::kAllowed);
  return result;
}

}  // namespace

std::span<const Format> comma_separated() {
  static constexpr Format kRows[] = {{"comma-separated gluing table", has_header, read_one<read>}};
  return kRows;
}

}  // namespace tripus::topology::registered_formats
