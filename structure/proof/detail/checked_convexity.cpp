#include "structure/proof/detail/checked_convexity.hpp"

#include <cmath>
#include <cstdint>
#include <set>
#include <utility>

namespace tripus::structure::detail {
namespace {

enum class Definite { kYes, kNo, kUnclear };

constexpr long kMostBits = 4096;
constexpr int kHalvings = 40;

/// Elimination without roots, the row with the fewest entries next.
Definite eliminate(CheckedMatrix a) {
  std::set<std::pair<std::size_t, std::size_t>> left;  // entries, row
  for (std::size_t i = 0; i < a.size(); ++i) left.emplace(a[i].size(), i);
  while (!left.empty()) {
    const std::size_t v = left.begin()->second;
    left.erase(left.begin());
    const Arb pivot = std::move(a[v][v]);
    if (!pivot.positive()) return pivot.negative() ? Definite::kNo : Definite::kUnclear;
    a[v].erase(v);
    for (const auto& [i, at_i] : a[v]) {
      left.erase({a[i].size(), i});
      a[i].erase(v);
      const Arb factor = at_i / pivot;
      for (const auto& [j, at_j] : a[v]) {
        Arb& entry = a[i][j];
        entry = entry - factor * at_j;
      }
      left.emplace(a[i].size(), i);
    }
    a[v].clear();
  }
  return Definite::kYes;
}

/// The midpoints scaled to a diagonal near 1, and a bound for what the radii can do to them.
struct Scaled {
  CheckedMatrix mid;
  Arb norm;
};

Scaled scaled(const CheckedMatrix& matrix) {
  Scaled result{CheckedMatrix(matrix.size()), Arb()};
  std::vector<Arb> scale;
  for (std::size_t i = 0; i < matrix.size(); ++i)
    scale.push_back((Arb(1.0) / square_root(matrix[i].at(i).midpoint())).midpoint());
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    Arb row;
    for (const auto& [j, entry] : matrix[i]) {
      const Arb here = scale[i] * entry * scale[j];
      result.mid[i][j] = here.midpoint();
      row = row + (here - here.midpoint()).magnitude();
    }
    if (larger(row, result.norm)) result.norm = row.upper_end();
  }
  // From both sides of the diagonal the same, so that the matrix stays symmetric.
  for (std::size_t i = 0; i < matrix.size(); ++i)
    for (auto& [j, entry] : result.mid[i])
      if (j < i) entry = result.mid[j].at(i);
  result.norm = 2.0 * result.norm;
  return result;
}

/// Whether all members of the matrix less `share` on the diagonal are positive definite.
bool passes(const Scaled& matrix, double share, long& bits) {
  for (;; bits *= 2) {
    const Precision precision(bits);
    CheckedMatrix shifted = matrix.mid;
    const Arb shift = matrix.norm + Arb(share);
    for (std::size_t i = 0; i < shifted.size(); ++i) shifted[i][i] = shifted[i][i] - shift;
    const Definite definite = eliminate(std::move(shifted));
    if (definite != Definite::kUnclear) return definite == Definite::kYes;
    if (bits > kMostBits) return false;
  }
}

}  // namespace

double checked_share(const CheckedMatrix& matrix) {
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    const auto diagonal = matrix[i].find(i);
    if (diagonal == matrix[i].end() || !(diagonal->second.mid() > 0) ||
        !std::isfinite(diagonal->second.mid()))
      return 0;
  }
  const Scaled same_size = scaled(matrix);
  if (!same_size.norm.finite()) return 0;
  long bits = Precision::bits();
  double shown = 0, failed = 1;
  for (int halving = 0; halving < kHalvings && (shown == 0 || failed > 1.2 * shown); ++halving) {
    const double share = shown == 0 ? failed / 2 : (shown + failed) / 2;
    (passes(same_size, share, bits) ? shown : failed) = share;
  }
  return shown * (1 - 0x1p-40);
}

std::vector<std::size_t> checked_pins(const topology::Triangulation& triangulation,
                                      std::span<const topology::OrbifoldLink> links,
                                      const std::vector<bool>& excluded) {
  constexpr std::int64_t kPrime = 2147483647;  // what is not 0 modulo a prime is not 0
  std::vector<std::size_t> column(links.size());
  std::size_t cusps = 0;
  for (std::size_t v = 0; v < links.size(); ++v)
    if (links[v].kind == topology::VertexKind::kIdeal) column[v] = cusps++;
  std::vector<std::vector<std::int64_t>> rows;  // reduced, each with a 1 where it leads
  std::vector<std::size_t> leads, pins;
  for (std::size_t e = 0; e < triangulation.edge_count() && pins.size() < cusps; ++e) {
    if (!excluded.empty() && excluded[e]) continue;
    std::vector<std::int64_t> row(cusps);
    const topology::EdgeCorner corner = triangulation.corners(e)[0];
    for (const int end : topology::kEdgeEnds[static_cast<std::size_t>(corner.edge())]) {
      const std::size_t v = triangulation.vertex_class(corner.tetrahedron(), end);
      if (links[v].kind == topology::VertexKind::kIdeal) ++row[column[v]];
    }
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const std::int64_t factor = row[leads[k]];
      for (std::size_t c = 0; factor != 0 && c < cusps; ++c)
        row[c] = ((row[c] - factor * rows[k][c]) % kPrime + kPrime) % kPrime;
    }
    std::size_t lead = 0;
    while (lead < cusps && row[lead] == 0) ++lead;
    if (lead == cusps) continue;
    std::int64_t inverse = 1;  // Fermat: x^(p - 2)
    for (std::int64_t power = row[lead], n = kPrime - 2; n > 0; n /= 2) {
      if (n % 2 == 1) inverse = inverse * power % kPrime;
      power = power * power % kPrime;
    }
    for (std::int64_t& x : row) x = x * inverse % kPrime;
    rows.push_back(std::move(row));
    leads.push_back(lead);
    pins.push_back(e);
  }
  return pins;
}

}  // namespace tripus::structure::detail
