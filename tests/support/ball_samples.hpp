#pragma once

#include <utility>
#include <vector>

/// Values of the functions of balls, made by two compilations of one source: as the library is
/// built, and with products and sums fused.
namespace tripus::testing {

/// Midpoint and radius of each function at the exact point (x, y).
struct BallSample {
  double x, y;
  double sinh[2], cosh[2], log[2], angle[2], quotient[2], root[2], clausen[2];
};
using BallSamples = std::vector<BallSample>;

BallSamples ball_samples(const std::vector<std::pair<double, double>>& points);
BallSamples fused_ball_samples(const std::vector<std::pair<double, double>>& points);

}  // namespace tripus::testing
