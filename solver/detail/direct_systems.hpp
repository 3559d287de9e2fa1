#pragma once

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "solver/detail/newton_loop.hpp"

namespace tripus::solver::detail {

/// Dense Cholesky, for a few dozen variables at most: one allocation, two where the problem has to
/// be asked for its pattern.
class DenseSystem final : public NewtonSystem {
 public:
  explicit DenseSystem(const Problem& problem);
  std::span<const double> load(const Evaluation& at) override;
  bool solve(const Evaluation& at, std::span<const double> shift, std::span<const double> g,
             double forcing, std::span<double> d) override;

 private:
  const Problem& problem_;
  std::span<const std::uint32_t> pins_;
  std::size_t n_;
  std::vector<double> memory_;
  std::span<double> matrix_, diagonal_, factor_;  // [n x n], [n], [n x n]
  std::vector<double> values_;                    // [nnz], of problems that have no other form
};

/// Sparse Cholesky, analysed once, factorised at every step. By CHOLMOD: supernodal where that
/// pays, ordered by AMD or METIS, whichever fills in less; by Eigen where CHOLMOD is missing.
class SparseSystem final : public NewtonSystem {
 public:
  /// Indices have 32 bits.
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
  /// The pattern, or InvalidInput.
  static const SparsityPattern& factorisable(const Problem& problem) {
    const SparsityPattern& pattern = problem.hessian_pattern();
    if (pattern.row.size() >= kMaxEntries)
      throw InvalidInput("the Hessian has " + std::to_string(pattern.row.size()) +
                         " entries, too many for a direct solver; use newton-cg");
    return pattern;
  }

  struct Factorisation;
  std::unique_ptr<Factorisation> factorisation_;
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
