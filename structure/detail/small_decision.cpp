#include "structure/detail/small_decision.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

namespace tripus::structure::detail {
namespace {

constexpr std::size_t kNowhere = static_cast<std::size_t>(-1);

/// Products of two such numbers, and the difference of two products, are exact.
constexpr double kLargest = 1 << 25;

/// In groups, so that the compiler makes vectors of it.
bool has_small_entries(const std::vector<double>& table) {
  constexpr std::size_t kGroup = 8;
  std::array<double, kGroup> least{}, greatest{};
  std::size_t k = 0;
  for (; k + kGroup <= table.size(); k += kGroup)
    for (std::size_t i = 0; i < kGroup; ++i) {
      greatest[i] = table[k + i] > greatest[i] ? table[k + i] : greatest[i];
      least[i] = table[k + i] < least[i] ? table[k + i] : least[i];
    }
  double largest = 0;
  for (; k < table.size(); ++k) largest = std::max(largest, std::fabs(table[k]));
  for (std::size_t i = 0; i < kGroup; ++i) largest = std::max({largest, greatest[i], -least[i]});
  return largest < kLargest;
}

/// Steps after which the rule of Bland chooses, which never goes in circles, and after which it is
/// given up.
constexpr int kGreedySteps = 100;
constexpr int kMostSteps = 1000;

}  // namespace

SmallProgramme::SmallProgramme(const topology::Triangulation& triangulation,
                               std::span<const int> flat)
    : flat_(flat.begin(), flat.end()),
      tetrahedra_(triangulation.tetrahedron_count()),
      is_zero_(6 * tetrahedra_, 0),
      row_of_(10 * tetrahedra_, kNowhere) {
  const std::vector<double> sums = edge_sums(triangulation);
  std::size_t edges = 0, corners = 0;
  for (std::size_t e = 0; e < sums.size(); ++e) {
    std::size_t live = 0;
    for (const auto corner : triangulation.corners(e)) {
      if (is_flat(corner.tetrahedron())) continue;
      ++live;
      if (sums[e] == 0)
        is_zero_[6 * corner.tetrahedron() + static_cast<std::size_t>(corner.edge())] = 1;
    }
    if (sums[e] < 0 || (sums[e] > 0 && live == 0)) impossible_ = true;
    if (sums[e] <= 0) continue;
    ++edges;
    corners += live;
  }
  if (impossible_ || edges == 0) return;
  std::size_t live = 0;
  for (std::size_t t = 0; t < tetrahedra_; ++t) live += !is_flat(t);
  rows_ = edges + 4 * live - 1;
  width_ = 1 + corners - edges + 1;
  table_.resize((rows_ + 1) * width_);
  basic_.resize(rows_);
  nonbasic_.assign(width_, kNowhere);
  fill(triangulation, sums);
}

/// [E] what the flat tetrahedra leave of 2.
std::vector<double> SmallProgramme::edge_sums(const topology::Triangulation& triangulation) const {
  std::vector<double> sums(triangulation.edge_count(), 2);
  for (std::size_t t = 0; t < flat_.size(); ++t) {
    if (flat_[t] < 0) continue;
    for (const int edge : {flat_[t], 5 - flat_[t]}) --sums[triangulation.edge_class(t, edge)];
  }
  return sums;
}

void SmallProgramme::fill(const topology::Triangulation& triangulation,
                          const std::vector<double>& edge_sums) {
  // Vertex sums in the corners that are 0, when one corner of each edge has all of its angle: the
  // one that makes the largest sum smallest.
  std::vector<double> sums(4 * tetrahedra_ * width_);
  const auto sum_row = [&](std::size_t t, int v) {
    return sums.data() + (4 * t + static_cast<std::size_t>(v)) * width_;
  };
  std::size_t column = 1, row = 0;
  std::vector<topology::EdgeCorner> corners;
  for (std::size_t e = 0; e < edge_sums.size(); ++e) {
    if (edge_sums[e] == 0) continue;
    corners.clear();
    for (const auto corner : triangulation.corners(e))
      if (!is_flat(corner.tetrahedron())) corners.push_back(corner);
    const auto load = [&](const topology::EdgeCorner& corner) {
      const auto& ends = topology::kEdgeEnds[static_cast<std::size_t>(corner.edge())];
      return std::max(*sum_row(corner.tetrahedron(), ends[0]),
                      *sum_row(corner.tetrahedron(), ends[1]));
    };
    std::size_t chosen = 0;
    for (std::size_t k = 1; k < corners.size(); ++k)
      if (load(corners[k]) < load(corners[chosen])) chosen = k;
    const auto add = [&](const topology::EdgeCorner& corner, std::size_t place, double value) {
      for (const int v : topology::kEdgeEnds[static_cast<std::size_t>(corner.edge())])
        sum_row(corner.tetrahedron(), v)[place] += value;
    };
    const auto variable = [](const topology::EdgeCorner& corner) {
      return 6 * corner.tetrahedron() + static_cast<std::size_t>(corner.edge());
    };
    basic_[row] = variable(corners[chosen]);
    row_of_[basic_[row]] = row;
    at(row, 0) = edge_sums[e];
    add(corners[chosen], 0, edge_sums[e]);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      if (k == chosen) continue;
      nonbasic_[column] = variable(corners[k]);
      at(row, column) = -1;
      add(corners[k], column, 1);
      add(corners[chosen], column, -1);
      ++column;
    }
    ++row;
  }
  std::size_t top = kNowhere;  // the vertex with the largest sum, whose slack is 0
  for (std::size_t v = 0; v < 4 * tetrahedra_; ++v)
    if (!is_flat(v / 4) && (top == kNowhere || sums[v * width_] > sums[top * width_])) top = v;
  nonbasic_[column] = 6 * tetrahedra_ + top;
  for (std::size_t v = 0; v < 4 * tetrahedra_; ++v) {
    if (v == top || is_flat(v / 4)) continue;
    basic_[row] = 6 * tetrahedra_ + v;
    row_of_[basic_[row]] = row;
    for (std::size_t k = 0; k < width_; ++k)
      at(row, k) = sums[top * width_ + k] - sums[v * width_ + k];
    at(row, column) = 1;
    ++row;
  }
  for (std::size_t k = 0; k < width_; ++k) at(rows_, k) = sums[top * width_ + k];
  at(rows_, column) = 1;
}

void SmallProgramme::pivot(std::size_t row, std::size_t column) {
  // theory (50''): p < 0 is the pivot, -p the new denominator.
  const double p = at(row, column);
  const double* pivot_row = table_.data() + row * width_;
  const bool plain = denominator_ == 1;
  for (std::size_t i = 0; i < rows_ + 1; ++i) {
    if (i == row) continue;
    double* here = table_.data() + i * width_;
    const double q = here[column];
    if (q == 0 && p == -denominator_) continue;
    if (plain) {
      for (std::size_t k = 0; k < width_; ++k) here[k] = q * pivot_row[k] - p * here[k];
    } else {
      for (std::size_t k = 0; k < width_; ++k)  // without remainder, so exact
        here[k] = (q * pivot_row[k] - p * here[k]) / denominator_;
    }
    here[column] = -q;
  }
  double* here = table_.data() + row * width_;
  here[column] = -denominator_;
  denominator_ = -p;
  std::swap(basic_[row], nonbasic_[column]);
  row_of_[basic_[row]] = row;
  row_of_[nonbasic_[column]] = kNowhere;
}

bool SmallProgramme::minimise() {
  for (int step = 0; step < kMostSteps; ++step) {
    const bool greedy = step < kGreedySteps;
    const double* value = table_.data() + rows_ * width_;
    std::size_t column = 0;
    for (std::size_t k = 1; k < width_; ++k) {
      if (!(value[k] < 0)) continue;
      const bool better =
          column == 0 || (greedy ? value[k] < value[column] : nonbasic_[k] < nonbasic_[column]);
      if (better) column = k;
    }
    if (column == 0) return true;
    std::size_t row = kNowhere;
    for (std::size_t i = 0; i < rows_; ++i) {
      const double a = at(i, column);
      if (!(a < 0)) continue;
      if (row == kNowhere) {
        row = i;
        continue;
      }
      const double here = at(i, 0) * at(row, column), best = at(row, 0) * a;
      // b_i / -a_i < b_r / -a_r, with a_i, a_r < 0
      const bool tie_wins = greedy ? a < at(row, column) : basic_[i] < basic_[row];
      if (-here < -best || (here == best && tie_wins)) row = i;
    }
    if (row == kNowhere) return false;  // cannot be: all angles are bounded
    pivot(row, column);
    if (!has_small_entries(table_)) return false;
  }
  return false;
}

bool SmallProgramme::solve() {
  if (impossible_) {
    sign_ = 1;
    return true;
  }
  if (rows_ == 0) {
    sign_ = -1;
    return true;
  }
  if (!minimise()) return false;
  const double excess = at(rows_, 0) - denominator_;
  sign_ = excess > 0 ? 1 : excess < 0 ? -1 : 0;
  return true;
}

std::vector<std::array<std::int64_t, 4>> SmallProgramme::vertex_multipliers() const {
  std::vector<std::array<std::int64_t, 4>> w(tetrahedra_);
  for (std::size_t k = 1; k < width_; ++k) {
    if (nonbasic_[k] < 6 * tetrahedra_) continue;
    const std::size_t v = nonbasic_[k] - 6 * tetrahedra_;
    w[v / 4][v % 4] = static_cast<std::int64_t>(at(rows_, k));
  }
  return w;
}

std::vector<std::array<std::int64_t, 6>> SmallProgramme::angles() const {
  std::vector<std::array<std::int64_t, 6>> x(tetrahedra_);
  for (std::size_t c = 0; c < 6 * tetrahedra_; ++c)
    if (row_of_[c] != kNowhere) x[c / 6][c % 6] = static_cast<std::int64_t>(at(row_of_[c], 0));
  return x;
}

std::optional<std::size_t> SmallProgramme::never_true() const {
  for (std::size_t c = 0; c < is_zero_.size(); ++c)
    if (is_zero_[c]) return c / 6;
  if (sign_ < 0) return std::nullopt;
  // What a multiplier of the optimum presses on is 0 in every angle structure.
  for (std::size_t k = 1; k < width_; ++k) {
    if (at(rows_, k) == 0) continue;
    const bool is_corner = nonbasic_[k] < 6 * tetrahedra_;
    return is_corner ? nonbasic_[k] / 6 : (nonbasic_[k] - 6 * tetrahedra_) / 4;
  }
  return std::nullopt;
}

bool SmallProgramme::may_be_positive(std::size_t t, std::size_t edge) const {
  const std::size_t corner = 6 * t + edge;
  if (is_zero_[corner]) return false;
  if (sign_ < 0) return true;
  for (std::size_t k = 1; k < width_; ++k)
    if (nonbasic_[k] == corner && at(rows_, k) != 0) return false;
  return true;
}

namespace {

using topology::Triangulation;
using Multipliers = std::vector<std::array<std::int64_t, 4>>;

/// The certificate from vertex multipliers, as certificate_from makes it (existence_routes.hpp), in
/// machine numbers.
std::optional<Certificate> small_certificate(const Triangulation& triangulation, Multipliers w) {
  std::int64_t divisor = 0, r = 0;
  for (const auto& four : w)
    for (const std::int64_t each : four) divisor = std::gcd(divisor, each);
  if (divisor == 0) return std::nullopt;
  for (auto& four : w)
    for (std::int64_t& each : four) r += each /= divisor;
  Certificate certificate;
  certificate.edge.reserve(triangulation.edge_count());
  for (std::size_t e = 0; e < triangulation.edge_count(); ++e) {
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    for (const auto corner : triangulation.corners(e)) {
      const auto& four = w[corner.tetrahedron()];
      const auto& ends = topology::kEdgeEnds[static_cast<std::size_t>(corner.edge())];
      least = std::min(
          least, four[static_cast<std::size_t>(ends[0])] + four[static_cast<std::size_t>(ends[1])]);
    }
    certificate.edge.emplace_back(least);
    r -= 2 * least;
  }
  if (r > 0) return std::nullopt;
  certificate.kind = r < 0 ? Certificate::Kind::kNone : Certificate::Kind::kSemi;
  certificate.vertex.resize(w.size());
  for (std::size_t t = 0; t < w.size(); ++t)
    for (std::size_t v = 0; v < 4; ++v) certificate.vertex[t][v] = w[t][v];
  return certificate;
}

/// One vertex sum that holds a whole edge angle of 2 pi, if there is one: an edge of valence 1, or
/// one of valence 2 whose corners are at one tetrahedron's vertex.
std::optional<Certificate> by_one_vertex(const Triangulation& triangulation) {
  for (std::size_t e = 0; e < triangulation.edge_count(); ++e) {
    const auto corners = triangulation.corners(e);
    if (corners.size() > 2 || corners[0].tetrahedron() != corners.back().tetrahedron()) continue;
    for (const int v : topology::kEdgeEnds[static_cast<std::size_t>(corners[0].edge())]) {
      const auto& other = topology::kEdgeEnds[static_cast<std::size_t>(corners.back().edge())];
      if (other[0] != v && other[1] != v) continue;
      Multipliers w(triangulation.tetrahedron_count());
      w[corners[0].tetrahedron()][static_cast<std::size_t>(v)] = 1;
      return small_certificate(triangulation, std::move(w));
    }
  }
  return std::nullopt;
}

bool is_plain(const Triangulation& triangulation,
              std::span<const topology::ConeAngle> cone_angles) {
  if (!topology::all_full(cone_angles)) return false;
  for (std::size_t v = 0; v < triangulation.vertex_count(); ++v)
    if (triangulation.link(v).euler_characteristic >= 0) return false;
  return true;
}

/// Exactly: angles >= 0, vertex sums <= 1, edge sums 2.
bool is_structure(const Triangulation& triangulation, const SmallProgramme& programme) {
  const std::int64_t one = programme.denominator();
  std::vector<std::int64_t> edge_sum(triangulation.edge_count());
  const auto angles = programme.angles();
  for (std::size_t t = 0; t < angles.size(); ++t) {
    std::array<std::int64_t, 4> vertex_sum{};
    for (std::size_t e = 0; e < 6; ++e) {
      if (angles[t][e] < 0) return false;
      edge_sum[triangulation.edge_class(t, static_cast<int>(e))] += angles[t][e];
      for (const int v : topology::kEdgeEnds[e])
        vertex_sum[static_cast<std::size_t>(v)] += angles[t][e];
    }
    if (std::ranges::any_of(vertex_sum, [&](std::int64_t sum) { return sum > one; })) return false;
  }
  return std::ranges::all_of(edge_sum, [&](std::int64_t sum) { return sum == 2 * one; });
}

/// Whether some angle structure consists of true tetrahedra and of flat ones, those of `flat` among
/// these; docs/theory.md (53'). A tetrahedron that is never a true one must be flat, in one of
/// three ways, and so on with what that leaves. Nothing if numbers grew too large.
std::optional<bool> may_be_degenerate(const Triangulation& triangulation,
                                      const SmallProgramme& programme, std::vector<int>& flat) {
  if (programme.sign() > 0) return false;
  const auto t = programme.never_true();
  if (!t) return true;
  for (int pair = 0; pair < 3; ++pair) {
    if (!programme.may_be_positive(*t, static_cast<std::size_t>(pair)) ||
        !programme.may_be_positive(*t, static_cast<std::size_t>(5 - pair)))
      continue;
    flat[*t] = pair;
    SmallProgramme rest(triangulation, flat);
    if (!rest.solve()) return std::nullopt;
    const auto possible = may_be_degenerate(triangulation, rest, flat);
    flat[*t] = -1;
    if (!possible || *possible) return possible;
  }
  return false;
}

}  // namespace

bool has_low_valence(const Triangulation& triangulation) {
  for (std::size_t e = 0; e < triangulation.edge_count(); ++e)
    if (triangulation.valence(e) <= 2) return true;
  return false;
}

std::optional<SmallDecision> decide_small(const Triangulation& triangulation,
                                          std::span<const topology::ConeAngle> cone_angles) {
  if (triangulation.tetrahedron_count() > SmallProgramme::kMostTetrahedra ||
      !is_plain(triangulation, cone_angles))
    return std::nullopt;
  if (auto certificate = by_one_vertex(triangulation))
    return SmallDecision{.certificate = std::move(certificate)};
  SmallProgramme programme(triangulation);
  if (!programme.solve()) return std::nullopt;
  if (programme.sign() < 0) return SmallDecision{};
  auto certificate = small_certificate(triangulation, programme.vertex_multipliers());
  const auto kind = programme.sign() > 0 ? Certificate::Kind::kNone : Certificate::Kind::kSemi;
  if (!certificate || certificate->kind != kind) return std::nullopt;
  if (kind == Certificate::Kind::kNone) return SmallDecision{.certificate = std::move(certificate)};
  std::vector<int> flat(triangulation.tetrahedron_count(), -1);
  const auto degenerate = may_be_degenerate(triangulation, programme, flat);
  if (!degenerate || !is_structure(triangulation, programme)) return std::nullopt;
  return SmallDecision{.certificate = std::move(certificate), .may_be_degenerate = *degenerate};
}

}  // namespace tripus::structure::detail
