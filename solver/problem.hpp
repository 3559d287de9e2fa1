#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <typeinfo>
#include <vector>

namespace tripus::solver {

/// Lower triangle of a symmetric sparse matrix in compressed columns: rows ascending within a
/// column, the diagonal entry always present and first.
struct SparsityPattern {
  std::vector<std::int64_t> column_start;  ///< [n + 1]
  std::vector<std::int32_t> row;           ///< [column_start[n]]
};

/// Up to which derivatives a function is evaluated.
enum class Order { kFirst, kSecond };

/// A function at one point: a value that owns all that it answers from. What it says does not
/// depend on what else is evaluated, before or after. Its problem must outlive it.
class Evaluation {
 public:
  virtual ~Evaluation() = default;

  /// [n].
  virtual std::span<const double> gradient() const = 0;

  /// f(x). Computed when asked for: it may cost as much as the gradient.
  virtual double value() const = 0;

  // Of the second order only.

  /// Hessian values [nnz] in the order of `Problem::hessian_pattern`.
  virtual void hessian_values(std::span<double> values) const = 0;

  /// The lower triangle of the Hessian as a full matrix [n x n] in columns, 0 above: for few
  /// variables, where a pattern is not worth its making. False, with nothing done, where the
  /// function cannot; `hessian_values` always can.
  virtual bool dense_hessian(std::span<double> lower) const {
    static_cast<void>(lower);
    return false;
  }

  /// Hv = Hessian * v, without assembling. [n], [n].
  virtual void hessian_times(std::span<const double> v, std::span<double> Hv) const = 0;

  /// The diagonal blocks of the Hessian for consecutive groups of `block_size` variables (the last
  /// group may be shorter). blocks: [ceil(n / block_size) x block_size x block_size], row-major,
  /// missing variables as zero rows and columns. block_size 1 is the diagonal.
  virtual void hessian_diagonal_blocks(std::size_t block_size, std::span<double> blocks) const = 0;

 protected:
  Evaluation() = default;
  Evaluation(const Evaluation&) = default;
  Evaluation& operator=(const Evaluation&) = default;
};

/// A convex function of n variables with gradient and sparse Hessian, to be minimised. Does not
/// change by being evaluated, and may be evaluated by several threads at once. Few variables need
/// two functions: derive from `DenseProblem`.
class Problem {
 public:
  virtual ~Problem() = default;

  /// Number of variables n.
  virtual std::size_t dimension() const = 0;

  /// Puts the function at x [n] into `into`. Returns false where it is not defined (outside an open
  /// domain); ask nothing of `into` then. An earlier evaluation of this problem that is passed in
  /// is overwritten, with its memory used again: a loop that does so allocates once.
  virtual bool evaluate(std::span<const double> x, Order order,
                        std::unique_ptr<Evaluation>& into) const = 0;

  /// The function at x [n]; null where it is not defined.
  std::unique_ptr<Evaluation> at(std::span<const double> x, Order order = Order::kFirst) const {
    std::unique_ptr<Evaluation> result;
    if (!evaluate(x, order, result)) result.reset();
    return result;
  }

  /// The pattern of the Hessian, built once.
  virtual const SparsityPattern& hessian_pattern() const = 0;

  /// Variables that fix the directions along which f is constant everywhere, as many as there are
  /// such directions: none of these but 0 vanishes at all pins. A factorisation adds to the
  /// diagonal there; a solution for a gradient, which is orthogonal to these directions, is then
  /// the one that is 0 at the pins. The Hessian above does not contain this. Conjugate gradients
  /// need it not.
  virtual std::span<const std::uint32_t> pins() const { return {}; }
};

/// What `into` points to, as an evaluation of type E of `problem`; made where it is none. E has a
/// constructor from the problem, and `is_of(problem)`.
template <class E, class P>
E& reuse(std::unique_ptr<Evaluation>& into, const P& problem) {
  if (Evaluation* at = into.get(); at != nullptr && typeid(*at) == typeid(E))
    if (E& found = static_cast<E&>(*at); found.is_of(problem)) return found;
  auto made = std::make_unique<E>(problem);
  E& result = *made;
  into = std::move(made);
  return result;
}

}  // namespace tripus::solver
