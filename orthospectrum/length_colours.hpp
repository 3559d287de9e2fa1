#pragma once

#include <array>
#include <cstdint>

namespace tripus::orthospectrum {

/// Red, green, blue, sRGB.
using LengthColour = std::array<std::uint8_t, 3>;

/// From short to long: a scale whose lightness falls evenly, told apart without seeing hue. The
/// same in every picture of discs.
inline constexpr std::array<LengthColour, 6> kLengthColours{{{168, 28, 48},
                                                             {220, 74, 50},
                                                             {245, 132, 52},
                                                             {252, 201, 88},
                                                             {196, 222, 178},
                                                             {120, 178, 206}}};

/// The colour at a share of the scale, 0 the shortest and 1 the longest: straight between the
/// stops.
LengthColour length_colour(double share);

/// What the scale of a picture goes from and to.
struct LengthScale {
  double shortest = 0, longest = 1;

  double share_of(double length) const { return (length - shortest) / (longest - shortest); }
};

}  // namespace tripus::orthospectrum
