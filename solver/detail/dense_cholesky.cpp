#include "solver/detail/dense_cholesky.hpp"

#include <cmath>
#include <limits>

namespace tripus::solver::detail {

bool factor_cholesky(std::span<double> a, std::size_t n) {
  // Left-looking by columns: column j minus the earlier columns, each a contiguous update.
  for (std::size_t j = 0; j < n; ++j) {
    double* column = a.data() + j * n;
    const double diagonal = column[j];
    for (std::size_t k = 0; k < j; ++k) {
      const double* earlier = a.data() + k * n;
      const double factor = earlier[j];
      for (std::size_t i = j; i < n; ++i) column[i] -= factor * earlier[i];
    }
    const double pivot = column[j];
    if (!(pivot > kPivot * diagonal && pivot <= std::numeric_limits<double>::max())) return false;
    const double scale = 1 / std::sqrt(pivot);
    column[j] = scale;
    for (std::size_t i = j + 1; i < n; ++i) column[i] *= scale;
  }
  return true;
}

void solve_cholesky(std::span<const double> a, std::size_t n, std::span<double> b) {
  for (std::size_t j = 0; j < n; ++j) {
    const double* column = a.data() + j * n;
    const double value = b[j] *= column[j];
    for (std::size_t i = j + 1; i < n; ++i) b[i] -= value * column[i];
  }
  for (std::size_t j = n; j-- > 0;) {
    const double* column = a.data() + j * n;
    double value = b[j];
    for (std::size_t i = j + 1; i < n; ++i) value -= column[i] * b[i];
    b[j] = value * column[j];
  }
}

}  // namespace tripus::solver::detail
