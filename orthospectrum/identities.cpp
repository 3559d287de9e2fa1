#include "orthospectrum/identities.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace tripus::orthospectrum {
namespace {

/// A straight line y = at_end + slope (x - end).
struct Line {
  double slope = 0, at_end = 0;
};

Line fitted_line(const std::vector<double>& x, const std::vector<double>& y, double end) {
  double mean_x = 0, mean_y = 0, square = 0, mixed = 0;
  const auto count = static_cast<double>(x.size());
  for (std::size_t n = 0; n < x.size(); ++n) {
    mean_x += x[n] / count;
    mean_y += y[n] / count;
  }
  for (std::size_t n = 0; n < x.size(); ++n) {
    square += (x[n] - mean_x) * (x[n] - mean_x);
    mixed += (x[n] - mean_x) * (y[n] - mean_y);
  }
  const double slope = mixed / square;
  return {slope, mean_y + slope * (end - mean_x)};
}

/// The logarithms of the number of arcs up to the ends of the histogram's bins, and of the area
/// that their discs leave, where there are enough arcs for them to mean something.
struct Curves {
  std::vector<double> length, count, missing;
};

Curves curves_of(const Sums& sums, double length, double area) {
  constexpr double kEnough = 20;
  Curves curves;
  double count = 0, covered = 0;
  for (std::size_t n = 0; n < sums.histogram().size(); ++n) {
    count += static_cast<double>(sums.histogram()[n]) / 2;
    covered += sums.area_histogram()[n];
    const double end = static_cast<double>(n + 1) * Sums::kBin;
    if (end > length || count < kEnough || covered >= area) continue;
    curves.length.push_back(end);
    curves.count.push_back(std::log(count));
    curves.missing.push_back(std::log(area - covered));
  }
  return curves;
}

/// Straight lines through the last `width` of a curve, for several widths.
std::vector<Line> lines_through(const std::vector<double>& x, const std::vector<double>& y,
                                double end) {
  constexpr double kNarrowest = 1.5, kWidest = 4, kStep = 0.25;
  std::vector<Line> lines;
  for (double width = kNarrowest; width <= kWidest; width += kStep) {
    const auto first = std::ranges::lower_bound(x, end - width) - x.begin();
    if (end - width < x.front() - Sums::kBin && !lines.empty()) break;
    lines.push_back(fitted_line({x.begin() + first, x.end()}, {y.begin() + first, y.end()}, end));
  }
  return lines;
}

/// The middle of several estimates. They share most of their data, so what they are off is more
/// than half their range: so many times as much, and `least` besides.
Estimate middle_of(const std::vector<double>& values, double factor, double least) {
  const auto [low, high] = std::ranges::minmax(values);
  return {(low + high) / 2, factor * (high - low) / 2 + least};
}

/// What of the weight e^{-2 l} the arcs beyond L carry, if N(l) = N e^{delta (l - L)}.
double area_beyond(double length, double count, double delta) {
  return 8 * std::numbers::pi * count * std::exp(-2 * length) * delta / (2 - delta);
}

}  // namespace

Identities identities_of(const Sums& sums, double length, double area, double volume) {
  // Chosen by trial on the manifolds with two and three tetrahedra so that all of them keep their
  // bounds from kArcsForEstimates on (docs/orthospectrum.md section 4); with fewer arcs some did
  // not. Arcs come in clumps, so their noise is some multiple of that of independent ones.
  constexpr double kRangeFactor = 2.5, kTailNoise = 6, kDimensionNoise = 1.5;
  const double noise = 1 / std::sqrt(static_cast<double>(sums.oriented_count()) / 2);
  Identities result;
  result.area = {sums.area(), area, {}};
  result.volume = {sums.volume(), volume, {}};
  if (sums.oriented_count() < 2 * kArcsForEstimates) return result;
  const Curves curves = curves_of(sums, length, area);
  if (curves.length.size() < 32) return result;

  std::vector<double> area_tails, volume_tails;
  for (const Line& line : lines_through(curves.length, curves.count, length)) {
    const double delta = line.slope;
    if (!(delta > 0 && delta < 2)) continue;
    // The mean length of the arcs beyond, by their area, is L + 1 / (2 - delta).
    const double tail = area_beyond(length, std::exp(line.at_end), delta);
    area_tails.push_back(tail);
    volume_tails.push_back(tail * (length + 1 + 1 / (2 - delta)) / 4);
  }
  if (!area_tails.empty()) {
    result.area.tail =
        middle_of(area_tails, kRangeFactor, kTailNoise * noise * std::ranges::max(area_tails));
    result.volume.tail =
        middle_of(volume_tails, kRangeFactor, kTailNoise * noise * std::ranges::max(volume_tails));
  }

  std::vector<double> dimensions;
  for (const Line& line : lines_through(curves.length, curves.missing, length))
    dimensions.push_back(2 + line.slope);
  const Estimate dimension = middle_of(dimensions, kRangeFactor, kDimensionNoise * noise);
  if (!(dimension.value > 0 && dimension.value < 2)) return result;
  result.dimension = dimension;
  const double missing = area - sums.area();
  const double beyond = 1 / (2 - dimension.value);
  const double beyond_error = dimension.uncertainty * beyond * beyond;
  result.volume_from_area =
      Estimate{sums.volume() + missing * (length + 1 + beyond) / 4, missing * beyond_error / 4};
  result.return_time[0] = Estimate{(sums.return_time(1) + missing * (length + 0.5 + beyond)) / area,
                                   missing * beyond_error / area};
  const double square = length * length + 2 * length * beyond + 2 * beyond * beyond;
  result.return_time[1] =
      Estimate{(sums.return_time(2) + missing * (square + length + beyond + 0.5)) / area,
               missing * (2 * length + 4 * beyond + 1) * beyond_error / area};
  return result;
}

}  // namespace tripus::orthospectrum
