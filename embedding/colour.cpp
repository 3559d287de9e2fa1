#include "embedding/colour.hpp"

#include <cmath>

namespace tripus::embedding {
namespace {

constexpr std::array<Colour, 12> kPalette{{{86, 180, 233},
                                           {230, 159, 0},
                                           {0, 158, 115},
                                           {204, 121, 167},
                                           {240, 228, 66},
                                           {0, 114, 178},
                                           {213, 94, 0},
                                           {143, 208, 192},
                                           {185, 163, 227},
                                           {201, 180, 88},
                                           {127, 159, 181},
                                           {230, 161, 138}}};
constexpr double kDarker = 0.8485;  // the root of 0.72, which the pages use in linear light

}  // namespace

Colour tetrahedron_colour(std::uint32_t tetrahedron) {
  const std::uint32_t number = tetrahedron % kColourCount;
  Colour colour = kPalette[number % kPalette.size()];
  const double share = std::pow(kDarker, static_cast<double>(number / kPalette.size()));
  for (std::uint8_t& c : colour) c = static_cast<std::uint8_t>(std::lround(share * c));
  return colour;
}

}  // namespace tripus::embedding
