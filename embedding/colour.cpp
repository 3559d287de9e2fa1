#include "embedding/colour.hpp"

#include <algorithm>
#include <cmath>

namespace tripus::embedding {
namespace {

constexpr std::array<Colour, 7> kPalette{{{230, 159, 0},
                                          {86, 180, 233},
                                          {0, 158, 115},
                                          {240, 228, 66},
                                          {0, 114, 178},
                                          {213, 94, 0},
                                          {204, 121, 167}}};

}  // namespace

Colour tetrahedron_colour(std::uint32_t tetrahedron) {
  if (tetrahedron < kPalette.size()) return kPalette[tetrahedron];
  constexpr double kGoldenTurn = 0.381966011250105;
  const double hue = std::fmod(tetrahedron * kGoldenTurn, 1.0);
  Colour colour{};
  for (std::size_t n = 0; n < 3; ++n) {
    // A wave of the hue for each of red, green and blue, a third of a turn apart.
    const double away = std::abs(std::remainder(hue - static_cast<double>(n) / 3, 1.0));
    const double share = std::clamp(2 - 6 * away, 0.0, 1.0);
    colour[n] = static_cast<std::uint8_t>(std::lround(70 + 160 * share));
  }
  return colour;
}

}  // namespace tripus::embedding
