#pragma once

#include <vector>

#include "solver/detail/newton_loop.hpp"

namespace tripus::solver::detail {

/// Newton steps by preconditioned conjugate gradients on Evaluation::hessian_times. O(n) memory;
/// the only allocation is in the constructor.
class ConjugateGradients final : public NewtonSystem {
 public:
  /// The preconditioner is the diagonal blocks of block_size consecutive variables; 1 is Jacobi.
  ConjugateGradients(std::size_t dimension, std::size_t block_size);

  std::span<const double> load(const Evaluation& at) override;
  bool solve(const Evaluation& at, std::span<const double> shift, std::span<const double> g,
             double forcing, std::span<double> d) override;
  long linear_iterations() const override { return iterations_; }

 private:
  bool factor_preconditioner(std::span<const double> shift);
  double precondition();

  std::size_t n_, block_size_;
  std::vector<double> blocks_, factors_;          // [blocks x block_size x block_size]
  std::vector<double> diagonal_, r_, z_, p_, q_;  // [n]
  long iterations_ = 0;
};

}  // namespace tripus::solver::detail
