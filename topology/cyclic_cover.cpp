#include "topology/cyclic_cover.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "base/big_number.hpp"
#include "base/error.hpp"
#include "topology/detail/relators.hpp"

namespace tripus::topology {
namespace {

using RationalMatrix = std::vector<std::vector<BigRational>>;

std::int64_t shift_at(std::span<const int> shifts, std::size_t t, int f) {
  return shifts[4 * t + static_cast<std::size_t>(f)];
}

void require_unbranched(const Gluings& gluings, std::span<const int> shifts, std::size_t degree) {
  const std::size_t count = gluings.tetrahedron_count();
  if (shifts.size() != 4 * count)
    throw InvalidInput("cyclic cover: " + std::to_string(shifts.size()) +
                       " shifts; expected one for each of the " + std::to_string(4 * count) +
                       " faces");
  if (degree == 0 || degree > kMaxTetrahedra / std::max<std::size_t>(count, 1))
    throw InvalidInput("cyclic cover: degree " + std::to_string(degree) + "; expected 1 to " +
                       std::to_string(kMaxTetrahedra / std::max<std::size_t>(count, 1)));
  const Triangulation triangulation(gluings);
  for (std::size_t t = 0; t < count; ++t)
    for (int f = 0; f < 4; ++f)
      if ((shift_at(shifts, gluings.neighbour(t, f), gluings.gluing(t, f)(f)) +
           shift_at(shifts, t, f)) %
              static_cast<std::int64_t>(degree) !=
          0)
        throw InvalidInput(
            "cyclic cover: the shift through face " + std::to_string(f) + " of tetrahedron " +
            std::to_string(t) +
            " is not the opposite, modulo the degree, of the shift on its other side");
  for (std::size_t e = 0; e < triangulation.edge_count(); ++e) {
    std::int64_t sum = 0;
    detail::walk_around_edge(triangulation, e, [&](std::size_t slot) { sum += shifts[slot]; });
    if (sum % static_cast<std::int64_t>(degree) != 0)
      throw InvalidInput("cyclic cover: the shifts around edge class " + std::to_string(e) +
                         " add up to " + std::to_string(sum) + ", not to 0 modulo " +
                         std::to_string(degree));
  }
}

RationalMatrix relator_matrix(const Triangulation& triangulation,
                              const detail::FaceGenerators& generators) {
  RationalMatrix matrix(triangulation.edge_count(), std::vector<BigRational>(generators.count()));
  for (std::size_t e = 0; e < matrix.size(); ++e)
    detail::walk_around_edge(triangulation, e, [&](std::size_t slot) {
      const std::int32_t code = generators.code(slot);
      if (code > 0) matrix[e][static_cast<std::size_t>(code) - 1] += 1;
      if (code < 0) matrix[e][static_cast<std::size_t>(-code) - 1] -= 1;
    });
  return matrix;
}

/// To reduced row echelon form; returns the pivot column of each of the first rows.
std::vector<std::size_t> reduce(RationalMatrix& matrix, std::size_t width) {
  std::vector<std::size_t> pivots;
  for (std::size_t j = 0; j < width && pivots.size() < matrix.size(); ++j) {
    const std::size_t top = pivots.size();
    std::size_t row = top;
    while (row < matrix.size() && matrix[row][j] == 0) ++row;
    if (row == matrix.size()) continue;
    std::swap(matrix[row], matrix[top]);
    const BigRational scale = matrix[top][j];
    for (BigRational& x : matrix[top]) x /= scale;
    for (std::size_t i = 0; i < matrix.size(); ++i) {
      if (i == top || matrix[i][j] == 0) continue;
      const BigRational factor = matrix[i][j];
      for (std::size_t k = j; k < width; ++k) matrix[i][k] -= factor * matrix[top][k];
    }
    pivots.push_back(j);
  }
  return pivots;
}

/// The primitive integer multiple of the null vector that is 1 at a free column.
std::vector<BigInteger> null_vector(const RationalMatrix& reduced,
                                    const std::vector<std::size_t>& pivots, std::size_t free,
                                    std::size_t width) {
  BigInteger common = 1;
  for (std::size_t row = 0; row < pivots.size(); ++row)
    common = lcm(common, denominator_of(reduced[row][free]));
  std::vector<BigInteger> result(width);
  result[free] = common;
  for (std::size_t row = 0; row < pivots.size(); ++row)
    result[pivots[row]] = -numerator_of(reduced[row][free] * common);
  BigInteger divisor = 0;
  for (const BigInteger& x : result) divisor = gcd(divisor, x);
  for (BigInteger& x : result) x /= divisor;
  return result;
}

BigInteger largest(const std::vector<BigInteger>& values) {
  BigInteger result = 0;
  for (const BigInteger& x : values)
    if (abs(x) > result) result = abs(x);
  return result;
}

}  // namespace

Gluings cyclic_cover(const Gluings& gluings, std::span<const int> shift_per_face,
                     std::size_t degree) {
  require_unbranched(gluings, shift_per_face, degree);
  const std::size_t count = gluings.tetrahedron_count();
  const auto modulus = static_cast<std::int64_t>(degree);
  Gluings cover(count * degree);
  for (std::size_t k = 0; k < degree; ++k)
    for (std::size_t t = 0; t < count; ++t)
      for (int f = 0; f < 4; ++f) {
        std::int64_t sheet =
            (static_cast<std::int64_t>(k) + shift_at(shift_per_face, t, f)) % modulus;
        if (sheet < 0) sheet += modulus;
        cover.set_one_side(k * count + t, f,
                           static_cast<TetrahedronIndex>(static_cast<std::size_t>(sheet) * count +
                                                         gluings.neighbour(t, f)),
                           gluings.gluing(t, f));
      }
  return cover;
}

std::optional<std::vector<int>> primitive_class(const Triangulation& triangulation) {
  if (!triangulation.is_connected()) return std::nullopt;
  const detail::FaceGenerators generators(triangulation.gluings());
  const std::size_t width = generators.count();
  RationalMatrix matrix = relator_matrix(triangulation, generators);
  const auto pivots = reduce(matrix, width);
  std::vector<BigInteger> best;
  for (std::size_t column = 0, row = 0; column < width; ++column) {
    if (row < pivots.size() && pivots[row] == column) {
      ++row;
      continue;
    }
    auto candidate = null_vector(matrix, pivots, column, width);
    if (best.empty() || largest(candidate) < largest(best)) best = std::move(candidate);
  }
  if (best.empty()) return std::nullopt;
  if (largest(best) > std::numeric_limits<int>::max())
    throw Unsupported("cyclic cover: the shifts of every class found exceed an int");
  std::vector<int> shifts(4 * triangulation.tetrahedron_count(), 0);
  for (std::size_t slot = 0; slot < shifts.size(); ++slot) {
    const std::int32_t code = generators.code(slot);
    if (code == 0) continue;
    const auto value =
        static_cast<int>(to_int64(best[static_cast<std::size_t>(code > 0 ? code : -code) - 1]));
    shifts[slot] = code > 0 ? value : -value;
  }
  return shifts;
}

}  // namespace tripus::topology
