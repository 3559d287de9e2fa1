#pragma once

#include <limits>
#include <memory>
#include <vector>

#include "solver/detail/newton_loop.hpp"

namespace tripus::solver::detail {

/// Dense Cholesky, for a few dozen variables at most: one allocation in all.
class DenseSystem final : public NewtonSystem {
 public:
  explicit DenseSystem(const Problem& problem);
  std::span<const double> load(const Evaluation& at) override;
  bool solve(const Evaluation& at, std::span<const double> shift, std::span<const double> g,
             double forcing, std::span<double> d) override;

 private:
  const SparsityPattern& pattern_;
  std::span<const std::uint32_t> pins_;
  std::size_t n_;
  std::vector<double> memory_;
  std::span<double> values_, diagonal_, factor_;  // [nnz], [n], [n x n]
};

/// Sparse Cholesky by CHOLMOD: supernodal where that pays, ordered by AMD or METIS, whichever fills
/// in less; analysed once, factorised at every step.
class SparseSystem final : public NewtonSystem {
 public:
  /// CHOLMOD is used with 32-bit indices.
  static constexpr std::size_t kMaxEntries = std::numeric_limits<int>::max();

  /// Throws InvalidInput where the pattern has kMaxEntries entries or more.
  explicit SparseSystem(const Problem& problem);
  ~SparseSystem() override;
  std::span<const double> load(const Evaluation& at) override;
  bool solve(const Evaluation& at, std::span<const double> shift, std::span<const double> g,
             double forcing, std::span<double> d) override;

  /// Whether memory has run out or the matrix is too large to factorise.
  bool out_of_memory() const;

 private:
  struct Cholmod;
  std::unique_ptr<Cholmod> cholmod_;
  std::span<const std::uint32_t> pins_;
  std::vector<double> diagonal_;
};

/// Up to here a dense factorisation beats the bookkeeping of a sparse one.
inline constexpr std::size_t kDenseDimension = 64;

/// The one that suits the dimension.
inline std::unique_ptr<NewtonSystem> make_direct_system(const Problem& problem) {
  if (problem.dimension() <= kDenseDimension) return std::make_unique<DenseSystem>(problem);
  return std::make_unique<SparseSystem>(problem);
}

}  // namespace tripus::solver::detail
