#pragma once

#include <array>
#include <cstdint>

namespace tripus::embedding {

/// Red, green, blue, 0 to 255.
using Colour = std::array<std::uint8_t, 3>;

/// The colour of every copy of a tetrahedron: the first seven are those of the Okabe-Ito palette,
/// which is told apart without seeing hue; further ones go around the colour circle by the golden
/// angle.
Colour tetrahedron_colour(std::uint32_t tetrahedron);

}  // namespace tripus::embedding
