#pragma once

#include <array>
#include <cstdint>

namespace tripus::embedding {

/// Red, green, blue, 0 to 255.
using Colour = std::array<std::uint8_t, 3>;

/// How many tetrahedra have colours of their own; then these come again.
inline constexpr std::uint32_t kColourCount = 48;

/// The colour of every copy of a tetrahedron, in files, pictures, windows and pages: the first seven
/// are those of the Okabe-Ito palette, which is told apart without seeing hue, then five between
/// them, then these twelve darker and darker. The first two are those of the tripus.
Colour tetrahedron_colour(std::uint32_t tetrahedron);

}  // namespace tripus::embedding
