#include "topology/covers/detail/abelianization.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "base/error.hpp"

namespace tripus::topology::detail {
namespace {

constexpr std::size_t kMostGenerators = 1000;

using Row = std::vector<BigInteger>;
using Matrix = std::vector<Row>;

/// R Q, diagonal up to row operations, with the Q that makes it so: coordinates of a row vector x
/// modulo the rows of R are those of x Q modulo the diagonal.
class Diagonalization {
 public:
  Diagonalization(Matrix rows, std::size_t width)
      : rows_(std::move(rows)), columns_(width, Row(width)), width_(width) {
    for (std::size_t j = 0; j < width; ++j) columns_[j][j] = 1;
  }

  /// Makes the matrix diagonal, each entry dividing the next; returns their number.
  std::size_t run() {
    std::size_t rank = 0;
    while (place_smallest(rank)) {
      if (clear(rank)) ++rank;
    }
    return rank;
  }

  BigInteger diagonal(std::size_t i) const { return abs(rows_[i][i]); }
  const Matrix& columns() const { return columns_; }

 private:
  /// Brings an entry of least size from rows and columns >= k to (k, k); false if all are 0.
  bool place_smallest(std::size_t k) {
    std::size_t row = 0;
    std::size_t column = 0;
    BigInteger least = 0;
    for (std::size_t i = k; i < rows_.size(); ++i)
      for (std::size_t j = k; j < width_; ++j) {
        if (rows_[i][j] == 0 || (least != 0 && abs(rows_[i][j]) >= least)) continue;
        least = abs(rows_[i][j]);
        row = i;
        column = j;
      }
    if (least == 0) return false;
    std::swap(rows_[k], rows_[row]);
    for (Row& x : rows_) std::swap(x[k], x[column]);
    for (Row& x : columns_) std::swap(x[k], x[column]);
    return true;
  }

  /// Row and column k reduced by the pivot. True if all is 0 but the pivot, which divides the rest;
  /// if not, there is a smaller entry now.
  bool clear(std::size_t k) {
    bool clean = true;
    for (std::size_t i = k + 1; i < rows_.size(); ++i) {
      const BigInteger quotient = rows_[i][k] / rows_[k][k];
      if (quotient != 0)
        for (std::size_t j = k; j < width_; ++j) rows_[i][j] -= quotient * rows_[k][j];
      clean = clean && rows_[i][k] == 0;
    }
    for (std::size_t j = k + 1; j < width_; ++j) {
      const BigInteger quotient = rows_[k][j] / rows_[k][k];
      if (quotient != 0) {
        for (Row& x : rows_) x[j] -= quotient * x[k];
        for (Row& x : columns_) x[j] -= quotient * x[k];
      }
      clean = clean && rows_[k][j] == 0;
    }
    return clean && divides_rest(k);
  }

  bool divides_rest(std::size_t k) {
    if (abs(rows_[k][k]) == 1) return true;
    for (std::size_t i = k + 1; i < rows_.size(); ++i)
      for (std::size_t j = k + 1; j < width_; ++j)
        if (rows_[i][j] % rows_[k][k] != 0) {
          for (std::size_t c = k; c < width_; ++c) rows_[k][c] += rows_[i][c];
          return false;
        }
    return true;
  }

  Matrix rows_;
  Matrix columns_;  // Q
  std::size_t width_;
};

Matrix exponents(const Presentation& presentation) {
  Matrix rows;
  rows.reserve(presentation.relators.size());
  for (const Word& relator : presentation.relators) {
    Row row(presentation.generator_count);
    for (const Letter letter : relator) row[generator_of(letter)] += letter > 0 ? 1 : -1;
    if (std::ranges::any_of(row, [](const BigInteger& x) { return x != 0; }))
      rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace

Abelianization abelianization(const Presentation& presentation) {
  const ReducedPresentation short_form = reduced(presentation);
  const std::size_t width = short_form.kept.size();
  if (width > kMostGenerators)
    throw Unsupported("H1 with a basis: " + std::to_string(width) +
                      " generators are left; at most " + std::to_string(kMostGenerators) +
                      " are supported, so start from a smaller triangulation");
  Diagonalization form(exponents(short_form.presentation), width);
  const std::size_t pivots = form.run();
  std::vector<std::size_t> basis;  // columns of Q, free part first
  for (std::size_t j = pivots; j < width; ++j) basis.push_back(j);
  Abelianization result{.rank = width - pivots, .factors = {}, .coordinates = {}};
  for (std::size_t j = 0; j < pivots; ++j) {
    if (form.diagonal(j) == 1) continue;
    basis.push_back(j);
    result.factors.push_back(form.diagonal(j));
  }
  result.coordinates.assign(presentation.generator_count, Row(basis.size()));
  for (std::size_t i = 0; i < width; ++i)
    for (std::size_t j = 0; j < basis.size(); ++j)
      result.coordinates[short_form.kept[i]][j] = form.columns()[i][basis[j]];
  for (auto solved = short_form.solved.rbegin(); solved != short_form.solved.rend(); ++solved)
    for (const Letter letter : solved->word)
      for (std::size_t j = 0; j < basis.size(); ++j) {
        BigInteger& sum = result.coordinates[solved->generator][j];
        const BigInteger& x = result.coordinates[generator_of(letter)][j];
        if (letter > 0) {
          sum += x;
        } else {
          sum -= x;
        }
      }
  return result;
}

}  // namespace tripus::topology::detail
