#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace tripus::studies::detail {

/// The finite ones among the values, ascending.
inline std::vector<double> finite_sorted(std::vector<double> values) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  std::sort(values.begin(), values.end());
  return values;
}

/// NaN if there are none.
inline double quantile(std::vector<double> values, double part) {
  values = finite_sorted(std::move(values));
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  return values[std::size_t(part * double(values.size() - 1) + 0.5)];
}
inline double median(std::vector<double> values) { return quantile(std::move(values), 0.5); }
inline double least(std::vector<double> values) { return quantile(std::move(values), 0); }
inline double greatest(std::vector<double> values) { return quantile(std::move(values), 1); }

/// Slope of the least-squares line of y on x; NaN with fewer than two points.
inline double slope(const std::vector<double>& x, const std::vector<double>& y) {
  const std::size_t n = x.size();
  double mx = 0, my = 0, xx = 0, xy = 0;
  for (std::size_t i = 0; i < n; ++i) mx += x[i] / double(n), my += y[i] / double(n);
  for (std::size_t i = 0; i < n; ++i) {
    xx += (x[i] - mx) * (x[i] - mx);
    xy += (x[i] - mx) * (y[i] - my);
  }
  return n < 2 ? std::numeric_limits<double>::quiet_NaN() : xy / xx;
}

}  // namespace tripus::studies::detail
