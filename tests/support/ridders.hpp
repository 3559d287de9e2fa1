#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <limits>

namespace tripus::testing {

struct Derivative {
  double value = 0;
  double error = std::numeric_limits<double>::infinity();  ///< estimate
};

/// Ridders' method: central differences at shrinking steps, extrapolated to step 0.
inline Derivative ridders(const std::function<double(double)>& f, double step) {
  constexpr int kLevels = 10;
  constexpr double kShrink = 1.6;
  std::array<std::array<double, kLevels>, kLevels> table{};
  Derivative best;
  for (int i = 0; i < kLevels; ++i, step /= kShrink) {
    table[0][std::size_t(i)] = (f(step) - f(-step)) / (2 * step);
    double factor = kShrink * kShrink;
    for (int j = 1; j <= i; ++j, factor *= kShrink * kShrink) {
      const auto row = std::size_t(j), column = std::size_t(i);
      table[row][column] =
          (table[row - 1][column] * factor - table[row - 1][column - 1]) / (factor - 1);
      const double error = std::max(std::fabs(table[row][column] - table[row - 1][column]),
                                    std::fabs(table[row][column] - table[row - 1][column - 1]));
      if (error < best.error) best = {table[row][column], error};
    }
  }
  return best;
}

}  // namespace tripus::testing
