// The textbook algorithm for Smith's form, modulo a number, so that entries stay below it.
#include <cstdint>
#include <utility>

#include "topology/detail/smith_form.hpp"

namespace tripus::topology::detail {
namespace {

using Vector = std::vector<BigInteger>;

/// x - factor * y modulo m, from the place `first` on; in [0, m).
void subtract(Vector& x, const BigInteger& factor, const Vector& y, std::size_t first,
              const BigInteger& m) {
  for (std::size_t i = first; i < x.size(); ++i) {
    if (y[i] == 0) continue;
    x[i] = (x[i] - factor * y[i]) % m;
    if (x[i] < 0) x[i] += m;
  }
}

/// At most k vectors that generate, modulo m, what the columns of k rows generate. Brought to
/// echelon form one by one, as there may be many more columns than rows.
template <class Integer>
std::vector<Vector> generating_columns(const std::vector<SparseRow<Integer>>& rows,
                                       std::size_t column_count, const BigInteger& m,
                                       const Stop& stop) {
  std::vector<SparseRow<Integer>> columns(column_count);
  for (std::uint32_t r = 0; r < rows.size(); ++r)
    for (const auto& entry : rows[r]) columns[entry.column].push_back({r, entry.value});
  std::vector<Vector> basis(rows.size());  // by first place
  for (const SparseRow<Integer>& column : columns) {
    throw_if_stopped(stop);
    Vector vector(rows.size());
    for (const auto& entry : column) vector[entry.column] = ((entry.value % m) + m) % m;
    for (std::size_t first = 0; first < vector.size();) {
      if (vector[first] == 0) {
        ++first;
      } else if (basis[first].empty()) {
        basis[first] = std::move(vector);
        break;
      } else {
        // One step of Euclid's algorithm on the leading entries.
        const BigInteger factor = vector[first] / basis[first][first];
        subtract(vector, factor, basis[first], first, m);
        if (vector[first] != 0) std::swap(vector, basis[first]);
      }
    }
  }
  std::erase_if(basis, [](const Vector& vector) { return vector.empty(); });
  return basis;
}

/// Diagonalises a matrix modulo m, from the block at (corner, corner) on, one entry at a time.
class ModularReducer {
 public:
  ModularReducer(std::vector<Vector> matrix, BigInteger modulus, const Stop& stop)
      : matrix_(std::move(matrix)), m_(std::move(modulus)), stop_(stop) {}

  /// The entries that are not 0 modulo m, divisors of m, each dividing the next.
  Vector diagonal() {
    Vector result;
    for (; move_least_to_corner(); ++corner_) {
      while (!clear_cross() || !divides_the_rest()) (void)move_least_to_corner();
      result.push_back(matrix_[corner_][corner_]);
    }
    return result;
  }

 private:
  std::size_t height() const { return matrix_.size(); }
  std::size_t width() const { return matrix_.empty() ? 0 : matrix_[0].size(); }

  /// Least: with the least common divisor with m, to which it is scaled. False if all are 0.
  bool move_least_to_corner() {
    BigInteger least = 0;
    std::size_t row = 0, column = 0;
    for (std::size_t i = corner_; i < height() && least != 1; ++i)
      for (std::size_t j = corner_; j < width() && least != 1; ++j) {
        if (matrix_[i][j] == 0) continue;
        BigInteger divisor = gcd(matrix_[i][j], m_);
        if (least != 0 && divisor >= least) continue;
        least = std::move(divisor);
        row = i;
        column = j;
      }
    if (least == 0) return false;
    std::swap(matrix_[row], matrix_[corner_]);
    if (column != corner_)
      for (Vector& line : matrix_) std::swap(line[column], line[corner_]);
    scale_corner_to(least);
    return true;
  }

  /// Multiplies the corner's row by a unit modulo m, so that the corner is its divisor with m.
  void scale_corner_to(const BigInteger& divisor) {
    Vector& top = matrix_[corner_];
    const BigInteger part = m_ / divisor;
    BigInteger unit = inverse(top[corner_] / divisor, part);
    while (gcd(unit, m_) != 1) unit += part;
    if (unit != 1)
      for (std::size_t j = corner_; j < width(); ++j) top[j] = top[j] * unit % m_;
  }

  /// 1/x modulo m, for x and m without a common divisor; 1 if m = 1.
  static BigInteger inverse(const BigInteger& x, const BigInteger& m) {
    BigInteger a = m, b = x % m, of_a = 0, of_b = 1;
    while (b > 1) {
      const BigInteger quotient = a / b;
      a -= quotient * b;
      of_a -= quotient * of_b;
      swap(a, b);
      swap(of_a, of_b);
    }
    if (m == 1) return 1;
    of_b %= m;
    return of_b < 0 ? of_b + m : of_b;
  }

  /// Reduces the corner's row and column modulo the corner; true if both vanish.
  bool clear_cross() {
    bool clear = true;
    const Vector& top = matrix_[corner_];
    const BigInteger corner = top[corner_];
    for (std::size_t i = corner_ + 1; i < height(); ++i) {
      throw_if_stopped(stop_);
      const BigInteger factor = matrix_[i][corner_] / corner;
      if (factor != 0) subtract(matrix_[i], factor, top, corner_, m_);
      clear = clear && matrix_[i][corner_] == 0;
    }
    for (std::size_t j = corner_ + 1; j < width(); ++j) {
      const BigInteger factor = top[j] / corner;
      if (factor == 0) continue;
      for (std::size_t i = corner_; i < height(); ++i) {
        BigInteger& x = matrix_[i][j];
        x = (x - factor * matrix_[i][corner_]) % m_;
        if (x < 0) x += m_;
      }
    }
    for (std::size_t j = corner_ + 1; j < width(); ++j) clear = clear && top[j] == 0;
    return clear;
  }

  /// Adds a row with an entry that the corner does not divide to the corner's row, if there is
  /// one, so that the next round finds a smaller corner.
  bool divides_the_rest() {
    Vector& top = matrix_[corner_];
    for (std::size_t i = corner_ + 1; i < height(); ++i)
      for (std::size_t j = corner_ + 1; j < width(); ++j)
        if (matrix_[i][j] % top[corner_] != 0) {
          subtract(top, BigInteger(-1), matrix_[i], corner_, m_);
          return false;
        }
    return true;
  }

  std::vector<Vector> matrix_;
  BigInteger m_;
  Stop stop_;
  std::size_t corner_ = 0;
};

}  // namespace

template <class Integer>
std::vector<BigInteger> diagonal_modulo(const std::vector<SparseRow<Integer>>& rows,
                                        std::size_t column_count, const BigInteger& m,
                                        const Stop& stop) {
  return ModularReducer(generating_columns(rows, column_count, m, stop), m, stop).diagonal();
}

template std::vector<BigInteger> diagonal_modulo(const std::vector<SparseRow<std::int64_t>>&,
                                                 std::size_t, const BigInteger&, const Stop&);
template std::vector<BigInteger> diagonal_modulo(const std::vector<SparseRow<BigInteger>>&,
                                                 std::size_t, const BigInteger&, const Stop&);

}  // namespace tripus::topology::detail
