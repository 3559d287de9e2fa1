#pragma once

#include <memory>
#include <vector>

#include "solver/detail/newton_loop.hpp"

namespace tripus::solver::detail {

/// Dense Cholesky, for a few dozen variables at most: one allocation in all.
class DenseSystem final : public NewtonSystem {
 public:
  explicit DenseSystem(Problem& problem);
  std::span<const double> load(const Problem& problem) override;
  bool solve(const Problem& problem, std::span<const double> shift, std::span<const double> g,
             double forcing, std::span<double> d) override;

 private:
  const SparsityPattern& pattern_;
  std::size_t n_;
  std::vector<double> memory_;
  std::span<double> values_, diagonal_, factor_;  // [nnz], [n], [n x n]
};

/// Sparse Cholesky by CHOLMOD: supernodal where that pays, ordered by AMD or METIS, whichever fills
/// in less; analysed once, factorised at every step.
class SparseSystem final : public NewtonSystem {
 public:
  /// Throws InvalidInput where the pattern has 2^31 entries or more.
  explicit SparseSystem(Problem& problem);
  ~SparseSystem() override;
  std::span<const double> load(const Problem& problem) override;
  bool solve(const Problem& problem, std::span<const double> shift, std::span<const double> g,
             double forcing, std::span<double> d) override;

  /// Whether memory has run out or the matrix is too large to factorise.
  bool out_of_memory() const;

 private:
  struct Cholmod;
  std::unique_ptr<Cholmod> cholmod_;
  std::vector<double> diagonal_;
};

}  // namespace tripus::solver::detail
