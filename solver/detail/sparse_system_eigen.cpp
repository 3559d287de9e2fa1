#include <algorithm>
#include <limits>

#include <Eigen/SparseCholesky>

#include "solver/detail/direct_systems.hpp"

// SparseSystem where CHOLMOD is not there: Eigen's simplicial Cholesky, ordered by minimum degree.

namespace tripus::solver::detail {
namespace {

/// Estimated reciprocal condition below which the factor is taken for singular, as CHOLMOD
/// estimates it: by the entries of the diagonal.
constexpr double kSingularFactor = 1e-15;

using Matrix = Eigen::SparseMatrix<double>;
using Factor = Eigen::SimplicialLLT<Matrix>;

}  // namespace

struct SparseSystem::Factorisation {
  Matrix matrix;  // the lower triangle
  Factor factor;
  std::vector<double> values;
  Eigen::VectorXd right, found;
  bool out_of_memory = false;

  double* start_of_column(std::size_t j) {
    return matrix.valuePtr() + matrix.outerIndexPtr()[j];  // the diagonal is first
  }
};

SparseSystem::SparseSystem(const Problem& problem)
    : factorisation_(std::make_unique<Factorisation>()),
      pins_(problem.pins()),
      diagonal_(problem.dimension()) {
  const SparsityPattern& pattern = factorisable(problem);
  Factorisation& c = *factorisation_;
  const auto n = static_cast<Eigen::Index>(diagonal_.size());
  c.values.resize(pattern.row.size());
  c.right.resize(n);
  c.matrix.resize(n, n);
  c.matrix.resizeNonZeros(static_cast<Eigen::Index>(pattern.row.size()));
  std::transform(pattern.column_start.begin(), pattern.column_start.end(), c.matrix.outerIndexPtr(),
                 [](auto place) { return static_cast<int>(place); });
  std::transform(pattern.row.begin(), pattern.row.end(), c.matrix.innerIndexPtr(),
                 [](auto row) { return static_cast<int>(row); });
  std::fill_n(c.matrix.valuePtr(), pattern.row.size(), 0.0);
  try {
    c.factor.analyzePattern(c.matrix);
  } catch (const std::bad_alloc&) {
    c.out_of_memory = true;
  }
}

SparseSystem::~SparseSystem() = default;

bool SparseSystem::out_of_memory() const { return factorisation_->out_of_memory; }

std::span<const double> SparseSystem::load(const Evaluation& at) {
  Factorisation& c = *factorisation_;
  at.hessian_values(c.values);
  for (std::size_t j = 0; j < diagonal_.size(); ++j)
    diagonal_[j] = c.values[static_cast<std::size_t>(c.matrix.outerIndexPtr()[j])];
  return diagonal_;
}

bool SparseSystem::solve(const Evaluation&, std::span<const double> shift,
                         std::span<const double> g, double, std::span<double> d) {
  Factorisation& c = *factorisation_;
  if (c.out_of_memory) return false;
  std::copy(c.values.begin(), c.values.end(), c.matrix.valuePtr());
  for (std::size_t j = 0; j < d.size(); ++j) {
    *c.start_of_column(j) += shift[j];
    c.right[static_cast<Eigen::Index>(j)] = -g[j];
  }
  for (const std::uint32_t pin : pins_) *c.start_of_column(pin) += diagonal_[pin];
  try {
    c.factor.factorize(c.matrix);
  } catch (const std::bad_alloc&) {
    c.out_of_memory = true;
    return false;
  }
  if (c.factor.info() != Eigen::Success) return false;
  const auto diagonal = c.factor.matrixL().nestedExpression().diagonal();
  const double ratio = diagonal.minCoeff() / diagonal.maxCoeff();
  if (!(ratio * ratio > kSingularFactor)) return false;
  c.found = c.factor.solve(c.right);
  std::copy_n(c.found.data(), d.size(), d.begin());
  return true;
}

}  // namespace tripus::solver::detail
