#include "structure/proof/detail/positive_definite.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/SparseCholesky>

#include "structure/proof/detail/edge_sums.hpp"

namespace tripus::structure::detail {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Factor = Eigen::SimplicialLLT<Matrix, Eigen::Lower>;

/// Shares of the estimated least eigenvalue that are tried one after the other.
constexpr double kShares[] = {0.9, 0.5, 0.1, 0.01};
constexpr int kInverseSteps = 8;
constexpr double kUnit = 0x1p-53;

/// An upper bound of the spectral norm of a symmetric matrix with entries >= 0: its largest row
/// sum.
double norm_bound(const Matrix& lower) {
  std::vector<double> row(static_cast<std::size_t>(lower.rows()));
  for (int j = 0; j < lower.outerSize(); ++j)
    for (Matrix::InnerIterator it(lower, j); it; ++it) {
      double& here = row[static_cast<std::size_t>(it.row())];
      here = up(here + it.value());
      if (it.row() == j) continue;
      double& there = row[static_cast<std::size_t>(j)];
      there = up(there + it.value());
    }
  return row.empty() ? 0 : *std::ranges::max_element(row);
}

bool factorised(const Factor& factor) {
  if (factor.info() != Eigen::Success) return false;
  const Matrix& l = factor.matrixL().nestedExpression();
  // NaN passes Eigen's own test of the pivots.
  return std::all_of(l.valuePtr(), l.valuePtr() + l.nonZeros(),
                     [](double x) { return std::isfinite(x); });
}

/// The most entries that a row of the factor has.
long longest_row(const Factor& factor) {
  const Matrix& l = factor.matrixL().nestedExpression();
  std::vector<long> entries(static_cast<std::size_t>(l.rows()));
  for (int j = 0; j < l.outerSize(); ++j)
    for (Matrix::InnerIterator it(l, j); it; ++it) ++entries[static_cast<std::size_t>(it.row())];
  return *std::ranges::max_element(entries);
}

/// Roughly the least eigenvalue, from above.
double estimate(const Factor& factor) {
  Eigen::VectorXd v(factor.rows());
  for (Eigen::Index i = 0; i < v.size(); ++i) v[i] = 1 + 0.5 * std::sin(static_cast<double>(i));
  double inverse = 0;
  for (int k = 0; k < kInverseSteps; ++k) {
    v.normalize();
    v = factor.solve(v).eval();
    inverse = v.norm();
  }
  return inverse > 0 && std::isfinite(inverse) ? 1 / inverse : 0;
}

/// How far from the matrix the product of its computed factor with its transpose can be.
double backward_error(const Factor& factor, double trace) {
  const double k = static_cast<double>(longest_row(factor)) + 2;
  const double gamma = up(k * kUnit / (1 - k * kUnit));
  const double n = static_cast<double>(factor.rows());
  return up(up(gamma / (1 - gamma)) * up(trace)) + n * k * 0x1p-1000;
}

}  // namespace

double least_eigenvalue_bound(const EnclosedMatrix& matrix) {
  if (matrix.mid.rows() == 0) return 0;
  const double wide = norm_bound(matrix.radius);
  if (!std::isfinite(wide)) return 0;
  Factor factor;
  factor.analyzePattern(matrix.mid);
  factor.factorize(matrix.mid);
  if (!factorised(factor)) return 0;
  const double least = estimate(factor);
  for (const double share : kShares) {
    const double shift = share * least;
    if (!(shift > wide)) return 0;
    Matrix shifted = matrix.mid;
    double trace = 0;
    for (int i = 0; i < shifted.rows(); ++i) {
      double& entry = shifted.coeffRef(i, i);
      entry = std::nextafter(entry - shift, -std::numeric_limits<double>::infinity());
      trace = up(trace + std::fabs(entry));
    }
    factor.factorize(shifted);
    if (!factorised(factor)) continue;
    const double shown = shift - up(wide + backward_error(factor, trace));
    if (shown > 0) return shown * (1 - 0x1p-48);
  }
  return 0;
}

}  // namespace tripus::structure::detail
