#pragma once

namespace tripus::viewer {

/// While things move, frames are drawn so coarsely that they take about so long, in milliseconds,
/// but not with fewer than this share of the pixels across. As in a page (web/main.js).
inline constexpr double kMovingFrame = 40, kCoarsest = 0.15;

/// How coarse the next frame should be, as a share of the pixels across in [kCoarsest, 1], when one
/// of `quality` took so many milliseconds: pixels cost time in proportion to their number.
double next_quality(double quality, double milliseconds);

}  // namespace tripus::viewer
