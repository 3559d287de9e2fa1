#include "cli/view_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "base/error.hpp"
#include "cli/numbers.hpp"
#include "geometry/moebius.hpp"

namespace tripus::cli {
namespace {

/// Larger maps move everything to the boundary of the model, where doubles end.
constexpr double kLargestCoefficient = 1e4;

/// The numbers of a text like 1x2x3; nothing if it is no such text.
std::optional<std::vector<double>> numbers_in(std::string_view text, char separator,
                                              std::size_t count) {
  std::vector<double> numbers;
  while (true) {
    const std::size_t end = std::min(text.find(separator), text.size());
    const auto number = parse_number(text.substr(0, end));
    if (!number) return std::nullopt;
    numbers.push_back(*number);
    if (end == text.size()) break;
    text.remove_prefix(end + 1);
  }
  if (numbers.size() != count) return std::nullopt;
  return numbers;
}

}  // namespace

std::array<int, 2> parse_size(const std::string& text) {
  const auto sides = numbers_in(text, 'x', 2);
  const auto whole = [](double side) {
    return side >= 1 && side <= viewer::kLargestSide && side == std::floor(side);
  };
  if (!sides || !whole((*sides)[0]) || !whole((*sides)[1])) {
    throw InvalidInput(fmt::format("--size {}: write WIDTHxHEIGHT, in pixels from 1 to {}",
                                   tripus::quoted(text), viewer::kLargestSide));
  }
  return {static_cast<int>((*sides)[0]), static_cast<int>((*sides)[1])};
}

void parse_camera(const std::string& text, viewer::Camera& camera) {
  if (text.empty()) return;
  auto numbers = numbers_in(text, ',', 3);
  if (!numbers) numbers = numbers_in(text, ',', 6);
  if (!numbers) {
    throw InvalidInput(
        fmt::format("--camera {}: write AZIMUTH,ELEVATION,DISTANCE, in degrees and radii of the "
                    "scene, or these and ZOOM,X,Y, a magnification and a shift in halves of the "
                    "picture's height",
                    tripus::quoted(text)));
  }
  camera.azimuth = (*numbers)[0];
  camera.elevation = (*numbers)[1];
  camera.distance = (*numbers)[2];
  if (numbers->size() < 6) return;
  camera.zoom = (*numbers)[3];
  camera.shift = {(*numbers)[4], (*numbers)[5]};
}

viewer::InsideOptions parse_inside(const std::string& text, const viewer::InsideManifold& m) {
  using viewer::StandingPlace;
  viewer::InsideOptions inside;
  if (text.empty() || text == "centre" || text == "wall" || text == "edge") {
    inside.walker = standing_at(m, text == "wall"   ? StandingPlace::kWall
                                   : text == "edge" ? StandingPlace::kEdge
                                                    : StandingPlace::kCentre);
    return inside;
  }
  const auto numbers = numbers_in(text, ',', 17);
  const std::string what = "--inside " + tripus::quoted(text);
  if (!numbers) {
    throw InvalidInput(what +
                       ": write centre, wall or edge, or what the key L of the window copies: the "
                       "number of a tetrahedron and the 16 numbers of a frame in it");
  }
  const double t = (*numbers)[0];
  const auto count = static_cast<double>(m.tetrahedra.size());
  if (!(t >= 0 && t < count && t == std::floor(t)))
    throw InvalidInput(
        fmt::format("{}: tetrahedra go from 0 to {}", what, m.tetrahedra.size() - 1));
  inside.walker.tetrahedron = static_cast<std::uint32_t>(t);
  for (std::size_t k = 0; k < 16; ++k)
    inside.walker.frame(static_cast<int>(k / 4), static_cast<int>(k % 4)) = (*numbers)[k + 1];
  if (!stands_inside(m, inside.walker))
    throw InvalidInput(what + ": this is no place in front of the walls of that tetrahedron");
  return inside;
}

geometry::Matrix4 parse_moebius(const std::string& text) {
  if (text.empty()) return geometry::Matrix4::Identity();
  const auto n = numbers_in(text, ',', 8);
  const std::string what = "--moebius " + tripus::quoted(text);
  if (!n) {
    throw InvalidInput(what +
                       ": write the real and imaginary parts of a, b, c and d of the map "
                       "w -> (aw + b)/(cw + d), eight numbers with commas between them");
  }
  for (const double x : *n)
    if (!(std::abs(x) <= kLargestCoefficient))
      throw InvalidInput(fmt::format("{}: numbers go up to {:g}", what, kLargestCoefficient));
  geometry::MoebiusMap map{
      {(*n)[0], (*n)[1]}, {(*n)[2], (*n)[3]}, {(*n)[4], (*n)[5]}, {(*n)[6], (*n)[7]}};
  const double size = std::norm(map.a) + std::norm(map.b) + std::norm(map.c) + std::norm(map.d);
  if (!(std::abs(map.a * map.d - map.b * map.c) > 1e-9 * size))
    throw InvalidInput(what + ": ad - bc is 0, or too near to it, and this is no Moebius map");
  return geometry::to_matrix(geometry::normalised(map));
}

}  // namespace tripus::cli
