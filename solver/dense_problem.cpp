#include "solver/dense_problem.hpp"

#include <algorithm>
#include <numeric>

namespace tripus::solver {
namespace {

class DenseAt final : public Evaluation {
 public:
  explicit DenseAt(const Problem& of)
      : gradient_(of.dimension()), of_(&of), n_(of.dimension()), H_(n_ * n_) {}

  bool is_of(const Problem& problem) const { return of_ == &problem; }
  std::span<const double> gradient() const override { return gradient_; }
  double value() const override { return value_; }

  void hessian_values(std::span<double> values) const override {
    auto to = values.begin();
    for (std::size_t j = 0; j < n_; ++j)
      for (std::size_t i = j; i < n_; ++i) *to++ = H_[n_ * i + j];
  }

  void hessian_times(std::span<const double> v, std::span<double> Hv) const override {
    for (std::size_t i = 0; i < n_; ++i)
      Hv[i] = std::inner_product(v.begin(), v.end(),
                                 H_.begin() + static_cast<std::ptrdiff_t>(n_ * i), 0.0);
  }

  void hessian_diagonal_blocks(std::size_t block_size, std::span<double> blocks) const override {
    std::ranges::fill(blocks, 0.0);
    for (std::size_t i = 0; i < n_; ++i) {
      const std::size_t first = i / block_size * block_size;
      for (std::size_t j = first; j < std::min(n_, first + block_size); ++j)
        blocks[i * block_size + j % block_size] = H_[n_ * i + j];
    }
  }

  std::span<double> matrix() { return H_; }

  double value_ = 0;
  std::vector<double> gradient_;

 private:
  const Problem* of_;
  std::size_t n_;
  std::vector<double> H_;  // [n x n]
};

}  // namespace

DenseProblem::DenseProblem(std::size_t dimension) : n_(dimension) {
  for (std::size_t j = 0; j < n_; ++j) {
    pattern_.column_start.push_back(static_cast<std::int64_t>(pattern_.row.size()));
    for (std::size_t i = j; i < n_; ++i) pattern_.row.push_back(static_cast<std::int32_t>(i));
  }
  pattern_.column_start.push_back(static_cast<std::int64_t>(pattern_.row.size()));
}

bool DenseProblem::evaluate(std::span<const double> x, Order order,
                            std::unique_ptr<Evaluation>& into) const {
  auto& at = reuse<DenseAt>(into, static_cast<const Problem&>(*this));
  const auto f = value(x, at.gradient_);
  if (!f) return false;
  at.value_ = *f;
  if (order == Order::kSecond) hessian(x, at.matrix());
  return true;
}

}  // namespace tripus::solver
