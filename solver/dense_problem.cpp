#include "solver/dense_problem.hpp"

#include <algorithm>
#include <numeric>

namespace tripus::solver {

DenseProblem::DenseProblem(std::size_t dimension) : n_(dimension), H_(dimension * dimension) {
  for (std::size_t j = 0; j < n_; ++j) {
    pattern_.column_start.push_back(static_cast<std::int64_t>(pattern_.row.size()));
    for (std::size_t i = j; i < n_; ++i) pattern_.row.push_back(static_cast<std::int32_t>(i));
  }
  pattern_.column_start.push_back(static_cast<std::int64_t>(pattern_.row.size()));
}

bool DenseProblem::evaluate(std::span<const double> x, std::span<double> gradient,
                            const Request& request) {
  const auto f = value(x, gradient);
  if (!f) return false;
  if (request.value != nullptr) *request.value = *f;
  if (request.second_derivatives) hessian(x, H_);
  return true;
}

void DenseProblem::hessian_values(std::span<double> values) const {
  auto to = values.begin();
  for (std::size_t j = 0; j < n_; ++j)
    for (std::size_t i = j; i < n_; ++i) *to++ = H_[n_ * i + j];
}

void DenseProblem::hessian_times(std::span<const double> v, std::span<double> Hv) const {
  for (std::size_t i = 0; i < n_; ++i)
    Hv[i] = std::inner_product(v.begin(), v.end(), H_.begin() + static_cast<std::ptrdiff_t>(n_ * i),
                               0.0);
}

void DenseProblem::hessian_diagonal_blocks(std::size_t block_size, std::span<double> blocks) const {
  std::ranges::fill(blocks, 0.0);
  for (std::size_t i = 0; i < n_; ++i) {
    const std::size_t first = i / block_size * block_size;
    for (std::size_t j = first; j < std::min(n_, first + block_size); ++j)
      blocks[i * block_size + j % block_size] = H_[n_ * i + j];
  }
}

}  // namespace tripus::solver
