#include <algorithm>

#include <cholmod.h>

#include "solver/detail/direct_systems.hpp"

// CHOLMOD, spoken to in its C interface. Errors come back in Common::status; printing is off.
// LL^T and not LDL^T, in the simplicial case too, so that a pivot that is not positive stops the
// factorisation and is seen in Factor::minor.

namespace tripus::solver::detail {
namespace {

/// Estimated reciprocal condition below which the factor is taken for singular.
constexpr double kSingular = 1e-15;

}  // namespace

struct SparseSystem::Factorisation {
  cholmod_common common{};
  cholmod_factor* factor = nullptr;
  cholmod_dense* solution = nullptr;
  cholmod_dense* work_y = nullptr;
  cholmod_dense* work_e = nullptr;
  cholmod_sparse matrix{};
  cholmod_dense right{};
  std::vector<int> column_start, row;
  std::vector<double> values, shifted, right_values;

  Factorisation() {
    cholmod_start(&common);
    common.print = 0;
    common.error_handler = nullptr;
    common.try_catch = 1;
    common.final_ll = 1;
    common.supernodal = CHOLMOD_AUTO;
  }
  Factorisation(const Factorisation&) = delete;
  Factorisation& operator=(const Factorisation&) = delete;
  ~Factorisation() {
    cholmod_free_factor(&factor, &common);
    for (cholmod_dense** dense : {&solution, &work_y, &work_e}) cholmod_free_dense(dense, &common);
    cholmod_finish(&common);
  }
};

SparseSystem::SparseSystem(const Problem& problem)
    : factorisation_(std::make_unique<Factorisation>()),
      pins_(problem.pins()),
      diagonal_(problem.dimension()) {
  const SparsityPattern& pattern = factorisable(problem);
  Factorisation& c = *factorisation_;
  const std::size_t n = diagonal_.size();
  c.column_start.assign(pattern.column_start.begin(), pattern.column_start.end());
  c.row.assign(pattern.row.begin(), pattern.row.end());
  c.values.resize(c.row.size());
  c.shifted.resize(c.row.size());
  c.right_values.resize(n);
  c.matrix.nrow = c.matrix.ncol = n;
  c.matrix.nzmax = c.row.size();
  c.matrix.p = c.column_start.data();
  c.matrix.i = c.row.data();
  c.matrix.x = c.shifted.data();
  c.matrix.stype = -1;
  c.matrix.itype = CHOLMOD_INT;
  c.matrix.xtype = CHOLMOD_REAL;
  c.matrix.dtype = CHOLMOD_DOUBLE;
  c.matrix.sorted = c.matrix.packed = 1;
  c.right.nrow = c.right.d = c.right.nzmax = n;
  c.right.ncol = 1;
  c.right.x = c.right_values.data();
  c.right.xtype = CHOLMOD_REAL;
  c.right.dtype = CHOLMOD_DOUBLE;
  c.factor = cholmod_analyze(&c.matrix, &c.common);
}

SparseSystem::~SparseSystem() = default;

bool SparseSystem::out_of_memory() const { return factorisation_->factor == nullptr; }

std::span<const double> SparseSystem::load(const Evaluation& at) {
  Factorisation& c = *factorisation_;
  at.hessian_values(c.values);
  for (std::size_t j = 0; j < diagonal_.size(); ++j) {
    diagonal_[j] = c.values[static_cast<std::size_t>(c.column_start[j])];
  }
  return diagonal_;
}

bool SparseSystem::solve(const Evaluation&, std::span<const double> shift,
                         std::span<const double> g, double, std::span<double> d) {
  Factorisation& c = *factorisation_;
  if (c.factor == nullptr) return false;
  std::copy(c.values.begin(), c.values.end(), c.shifted.begin());
  for (std::size_t j = 0; j < d.size(); ++j) {
    c.shifted[static_cast<std::size_t>(c.column_start[j])] += shift[j];
    c.right_values[j] = -g[j];
  }
  for (const std::uint32_t pin : pins_)
    c.shifted[static_cast<std::size_t>(c.column_start[pin])] += diagonal_[pin];
  cholmod_factorize(&c.matrix, c.factor, &c.common);
  if (c.common.status != CHOLMOD_OK || c.factor->minor < c.factor->n) {
    if (c.common.status < CHOLMOD_OK) cholmod_free_factor(&c.factor, &c.common);
    return false;
  }
  if (!(cholmod_rcond(c.factor, &c.common) > kSingular)) return false;
  if (!cholmod_solve2(CHOLMOD_A, c.factor, &c.right, nullptr, &c.solution, nullptr, &c.work_y,
                      &c.work_e, &c.common)) {
    return false;
  }
  const auto* x = static_cast<const double*>(c.solution->x);
  std::copy(x, x + d.size(), d.begin());
  return true;
}

}  // namespace tripus::solver::detail
