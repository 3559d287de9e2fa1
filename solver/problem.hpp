#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tripus::solver {

/// Lower triangle of a symmetric sparse matrix in compressed columns: rows ascending within a
/// column, the diagonal entry always present and first.
struct SparsityPattern {
  std::vector<std::int64_t> column_start;  ///< [n + 1]
  std::vector<std::int32_t> row;           ///< [column_start[n]]
};

/// A convex function of n variables with gradient and sparse Hessian, to be minimised.
///
/// All second-derivative queries refer to the point of the latest call of `evaluate` that asked
/// for second derivatives. Implementations keep their workspace between calls: nothing here
/// allocates after the first evaluation.
class Problem {
 public:
  virtual ~Problem() = default;

  /// Number of variables n.
  virtual std::size_t dimension() const = 0;

  /// What an evaluation shall compute besides the gradient.
  struct Request {
    double* value = nullptr;          ///< f(x), where not null
    bool second_derivatives = false;  ///< prepare the hessian_* queries at x
  };

  /// Evaluates at x [n]; writes the gradient [n]. Returns false where f is not defined (outside an
  /// open domain); the outputs are then unspecified.
  virtual bool evaluate(std::span<const double> x, std::span<double> gradient,
                        const Request& request) = 0;

  /// The pattern of the Hessian, built once.
  virtual const SparsityPattern& hessian_pattern() = 0;

  /// Hessian values [nnz] in the order of `hessian_pattern`.
  virtual void hessian_values(std::span<double> values) const = 0;

  /// Hv = Hessian * v, without assembling. [n], [n].
  virtual void hessian_times(std::span<const double> v, std::span<double> Hv) const = 0;

  /// The diagonal blocks of the Hessian for consecutive groups of `block_size` variables (the last
  /// group may be shorter). blocks: [ceil(n / block_size) x block_size x block_size], row-major,
  /// missing variables as zero rows and columns. block_size 1 is the diagonal.
  virtual void hessian_diagonal_blocks(std::size_t block_size, std::span<double> blocks) const = 0;

  /// Variables that fix the directions along which f is constant everywhere, as many as there are
  /// such directions: none of these but 0 vanishes at all pins. A factorisation adds to the
  /// diagonal there; a solution for a gradient, which is orthogonal to these directions, is then
  /// the one that is 0 at the pins. The Hessian above does not contain this. Conjugate gradients
  /// need it not.
  virtual std::span<const std::uint32_t> pins() const { return {}; }
};

}  // namespace tripus::solver
