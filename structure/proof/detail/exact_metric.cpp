#include "structure/proof/detail/exact_metric.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "structure/proof/detail/arb_number.hpp"

// The argument is in docs/theory.md 9.7. Guesses come from lattice reduction; everything that is
// concluded is an identity modulo the polynomial f, or an inequality between balls at a root of f.

namespace tripus::structure::detail {
namespace {

/// Sums of products of roots have 2^r terms.
constexpr std::size_t kMostRoots = 6;
constexpr std::size_t kMostCopies = 64;  // of the denominator of a cone angle

Arb exponential(const Arb& x) {
  Arb result;
  arb_exp(result.get(), x.get(), Precision::bits());
  return result;
}

/// Numbers of ends of edge e at the cusp v.
int ends_at(const ConeMetric& metric, std::size_t e, std::size_t v) {
  const auto ends = metric.ends(e);
  return int(ends[0] == v) + int(ends[1] == v);
}

/// a = -G_ij of each edge class, theory (77), for horospheres with a = 1 at the pins.
std::optional<std::vector<Arb>> normalised_entries(const ConeMetric& metric,
                                                   const std::vector<Arb>& lengths) {
  const topology::Triangulation& triangulation = metric.triangulation();
  std::vector<Arb> entries(lengths.size());
  for (std::size_t t = 0; t < triangulation.tetrahedron_count(); ++t) {
    const GramEntries found =
        gram_entries(lengths_of(triangulation, lengths, t), metric.diagonal(t));
    for (int e = 0; e < 6; ++e) entries[triangulation.edge_class(t, e)] = found.c[e];
  }
  const auto& pins = metric.pins();
  if (pins.empty()) return entries;
  std::vector<std::size_t> cusps;
  for (std::size_t v = 0; v < triangulation.vertex_count(); ++v)
    if (metric.is_ideal(v)) cusps.push_back(v);
  // sum over the ends of the pins of the shifts = -log a.
  ArbMatrix ends(pins.size(), cusps.size()), shift(cusps.size(), 1), wanted(pins.size(), 1);
  for (std::size_t p = 0; p < pins.size(); ++p) {
    for (std::size_t c = 0; c < cusps.size(); ++c)
      arb_set_si(ends.at(p, c), ends_at(metric, pins[p], cusps[c]));
    arb_log(wanted.at(p, 0), entries[pins[p]].get(), Precision::bits());
    arb_neg(wanted.at(p, 0), wanted.at(p, 0));
  }
  if (arb_mat_solve(shift.get(), ends.get(), wanted.get(), Precision::bits()) == 0)
    return std::nullopt;
  for (std::size_t e = 0; e < entries.size(); ++e)
    for (std::size_t c = 0; c < cusps.size(); ++c) {
      const int count = ends_at(metric, e, cusps[c]);
      if (count == 0) continue;
      Arb move;
      arb_mul_si(move.get(), shift.at(c, 0), count, Precision::bits());
      entries[e] = entries[e] * exponential(move);
    }
  return entries;
}

/// A number that generates the field of all of them, as a rule: their sum with different factors,
/// those that are equal taken once.
Arb generator_of(const std::vector<Arb>& entries) {
  std::vector<Arb> different;
  Arb sum;
  for (const Arb& entry : entries) {
    const bool known = std::ranges::any_of(
        different, [&](const Arb& other) { return arb_overlaps(entry.get(), other.get()) != 0; });
    if (known) continue;
    different.push_back(entry);
    sum = sum + static_cast<double>(different.size()) * entry;
  }
  return sum;
}

}  // namespace

std::optional<ExactMetric> ExactMetric::find(const ConeMetric& metric,
                                             const std::vector<Arb>& lengths, int most_degree) {
  if (metric.has_finite_vertex()) return std::nullopt;
  const auto entries = normalised_entries(metric, lengths);
  if (!entries) return std::nullopt;
  auto field = NumberField::guess(generator_of(*entries), most_degree);
  if (!field) return std::nullopt;
  ExactMetric result(metric, std::move(*field));
  if (!result.guess_entries(*entries) || !result.fill_tetrahedra() || !result.all_true())
    return std::nullopt;
  for (std::size_t e = 0; e < entries->size(); ++e)
    if (!result.angles_close(e)) return std::nullopt;
  if (!result.find_horospheres()) result.horosphere_.clear();
  return result;
}

bool ExactMetric::guess_entries(const std::vector<Arb>& entries) {
  std::vector<std::size_t> different;
  for (std::size_t e = 0; e < entries.size(); ++e) {
    const auto same = std::ranges::find_if(different, [&](std::size_t other) {
      return arb_overlaps(entries[e].get(), entries[other].get()) != 0;
    });
    if (same != different.end()) {
      gram_.push_back(gram_[*same]);
      continue;
    }
    auto guess = field_.guess_member(entries[e]);
    if (!guess) return false;
    gram_.push_back(std::move(*guess));
    different.push_back(e);
  }
  return true;
}

bool ExactMetric::fill_tetrahedra() {
  const topology::Triangulation& triangulation = metric_->triangulation();
  for (std::size_t t = 0; t < triangulation.tetrahedron_count(); ++t) {
    std::array<Algebraic, 6> a;
    std::array<Arb, 6> near;
    for (std::size_t e = 0; e < 6; ++e) {
      a[e] = gram_[triangulation.edge_class(t, static_cast<int>(e))];
      near[e] = field_.value(a[e]);
    }
    exact_.emplace_back(a, metric_->diagonal(t));
    near_.emplace_back(near, metric_->diagonal(t));
    if (!near_[t].minus_det.positive() || !add_root(t)) return false;
  }
  return true;
}

/// sqrt D as a multiple of a product of the roots so far, or as a new one.
bool ExactMetric::add_root(std::size_t t) {
  const Algebraic& D = exact_[t].minus_det;
  for (std::size_t s = 0; s < t; ++s)
    if (exact_[s].minus_det == D) {
      root_.push_back(root_[s]);
      return true;
    }
  for (std::uint32_t roots = 0; roots < (1u << radicand_.size()); ++roots) {
    Algebraic square = D, others(1);
    for (std::size_t k = 0; k < radicand_.size(); ++k)
      if ((roots >> k & 1u) != 0) others = others * radicand_[k];
    square = square * others;
    // sqrt D * prod sqrt D_k = r in the field: sqrt D = (r / prod D_k) prod sqrt D_k.
    const auto r = field_.guess_member(square_root(field_.approximation(square)));
    if (!r || !(*r * *r == square) || !field_.value(*r).positive()) continue;
    const auto inverse = others.inverse();
    if (!inverse) return false;
    root_.push_back({*r * *inverse, roots});
    return true;
  }
  if (radicand_.size() == kMostRoots) return false;
  root_.push_back({Algebraic(1), std::uint32_t{1} << radicand_.size()});
  radicand_.push_back(D);
  first_.push_back(t);
  return true;
}

std::pair<Algebraic, std::vector<std::size_t>> ExactMetric::root(std::size_t t) const {
  std::vector<std::size_t> of;
  for (std::size_t k = 0; k < first_.size(); ++k)
    if ((root_[t].roots >> k & 1u) != 0) of.push_back(first_[k]);
  return {root_[t].factor, of};
}

/// Whether the numbers at the root are those of true tetrahedra.
bool ExactMetric::all_true() const {
  for (const auto& gram : near_)
    for (const Arb& minor : gram.minor)
      if (!minor.positive()) return false;
  for (std::size_t e = 0; e < gram_.size(); ++e) {
    const Arb a = field_.value(gram_[e]);
    if (metric_->is_fixed(e)          ? !(gram_[e] == Algebraic(1))
        : metric_->may_be_negative(e) ? !a.positive()
                                      : !(a - Arb(1.0)).positive())
      return false;
  }
  return true;
}

/// Whether the angles around an edge class have the sum that is wanted.
bool ExactMetric::angles_close(std::size_t e) const {
  if (metric_->is_fixed(e)) return true;  // the angles are 0
  const topology::ConeAngle& wanted = metric_->cone_angles()[e];
  if (!wanted.is_rational()) return false;
  const auto copies = static_cast<std::size_t>(wanted.denominator());
  if (copies > kMostCopies) return false;
  const topology::Triangulation& triangulation = metric_->triangulation();
  // The product of c + i s sqrt D over the corners is re + i s im; s^2 = a^2 - d_i d_j.
  Sum re = one(), im(re.size());
  Arb angle;
  Algebraic squared_slope;
  for (const topology::EdgeCorner& corner : triangulation.corners(e)) {
    const std::size_t t = corner.tetrahedron();
    const auto edge = static_cast<std::size_t>(corner.edge());
    const auto [i, j] = topology::kEdgeEnds[edge];
    const Diagonal diagonal = metric_->diagonal(t);
    const int both = diagonal[static_cast<std::size_t>(i)] * diagonal[static_cast<std::size_t>(j)];
    squared_slope = gram_[e] * gram_[e] - Algebraic(both);
    const Algebraic& c = exact_[t].cofactor[edge];
    Sum next = sum(scaled(re, c), scaled(times_root(im, root_[t]), -squared_slope));
    im = sum(scaled(im, c), times_root(re, root_[t]));
    re = std::move(next);
    const Arb slope = square_root(field_.value(squared_slope));
    angle = angle + angle_of(slope * square_root(near_[t].minus_det), near_[t].cofactor[edge]);
  }
  // As often as the denominator says: then the wanted angle is a multiple of pi.
  Sum power_re = one(), power_im(re.size());
  for (std::size_t k = 0; k < copies; ++k) {
    Sum next = sum(product(power_re, re), scaled(product(power_im, im), -squared_slope));
    power_im = sum(product(power_re, im), product(power_im, re));
    power_re = std::move(next);
  }
  if (!std::ranges::all_of(power_im, [](const Algebraic& x) { return x.is_zero(); })) return false;
  // So it is a multiple of pi / copies; the balls say which.
  const Arb off = static_cast<double>(copies) * (angle - metric_->target(e));
  return (number_pi(off) - off.magnitude()).positive();
}

/// Areas of the horospheres: the link triangle of a tetrahedron at the ideal vertex i has the area
/// sqrt D / (2 a_ij a_ik a_il).
bool ExactMetric::find_horospheres() {
  const topology::Triangulation& triangulation = metric_->triangulation();
  std::vector<Sum> area(triangulation.vertex_count());
  std::vector<Arb> near(area.size());
  for (std::size_t t = 0; t < exact_.size(); ++t)
    for (int i = 0; i < 4; ++i) {
      const std::size_t v = triangulation.vertex_class(t, i);
      if (!metric_->is_ideal(v)) continue;
      Algebraic product(1);
      Arb near_product(1.0);
      for (int j = 0; j < 4; ++j) {
        if (j == i) continue;
        const Algebraic& a = gram_[triangulation.edge_class(t, geometry::kEdgeBetween[i][j])];
        product = product * a;
        near_product = near_product * field_.approximation(a);
      }
      const auto inverse = product.inverse();
      if (!inverse) return false;
      if (area[v].empty()) area[v].resize(one().size());
      area[v] = sum(area[v], scaled(times_root(one(), root_[t]), *inverse));
      near[v] = near[v] + square_root(field_.approximation(exact_[t].minus_det)) / near_product;
    }
  horosphere_.assign(area.size(), Algebraic(1));
  std::optional<std::size_t> first;
  for (std::size_t v = 0; v < area.size(); ++v) {
    if (area[v].empty()) continue;
    if (!first) {
      first = v;
      continue;
    }
    const auto ratio = field_.guess_member(square_root(near[*first] / near[v]));
    if (!ratio || !field_.value(*ratio).positive() ||
        scaled(area[v], *ratio * *ratio) != area[*first])
      return false;
    horosphere_[v] = *ratio;
  }
  return true;
}

/// t_i sqrt(p_i D) of docs/canonical.md (T3), over the vertices of one kind.
Algebraic ExactMetric::numerator(std::size_t t, int f, int kind) const {
  const Diagonal diagonal = metric_->diagonal(t);
  Algebraic result;
  for (int j = 0; j < 4; ++j) {
    if (diagonal[static_cast<std::size_t>(j)] != kind) continue;
    const Algebraic term =
        j == f ? exact_[t].minor[static_cast<std::size_t>(f)] : -exact_[t].opposite(f, j);
    // N_ij / R_i of the vector at j, which is multiplied by what its horosphere was moved by.
    result = kind == 1 ? result + term
                       : result + term * horosphere_[metric_->triangulation().vertex_class(t, j)];
  }
  return result;
}

/// p_f is the same on both sides: N / sqrt D + N' / sqrt D' = 0.
bool ExactMetric::sum_is_zero(std::size_t t, int f, int kind) const {
  if (kind == 0 && horosphere_.empty()) return false;
  const topology::Gluings& gluings = metric_->triangulation().gluings();
  const std::size_t other = gluings.neighbour(t, f);
  const Algebraic here = numerator(t, f, kind);
  const Algebraic there = numerator(other, gluings.gluing(t, f)(f), kind);
  if (here.is_zero() && there.is_zero()) return true;
  if (!(here * here * exact_[other].minus_det == there * there * exact_[t].minus_det)) return false;
  const Arb a = field_.value(here), b = field_.value(there);
  return (a.positive() && b.negative()) || (a.negative() && b.positive());
}

// ---- sums of products of roots ------------------------------------------------------------------

ExactMetric::Sum ExactMetric::one() const {
  Sum result(std::size_t{1} << radicand_.size());
  result[0] = Algebraic(1);
  return result;
}

ExactMetric::Sum ExactMetric::scaled(const Sum& a, const Algebraic& factor) const {
  Sum result = a;
  for (Algebraic& x : result)
    if (!x.is_zero()) x = x * factor;
  return result;
}

ExactMetric::Sum ExactMetric::sum(const Sum& a, const Sum& b) const {
  Sum result = a;
  for (std::size_t k = 0; k < b.size(); ++k)
    if (!b[k].is_zero()) result[k] = result[k] + b[k];
  return result;
}

ExactMetric::Sum ExactMetric::times_root(const Sum& a, const Root& root) const {
  Sum result(a.size());
  for (std::uint32_t k = 0; k < a.size(); ++k) {
    if (a[k].is_zero()) continue;
    Algebraic factor = a[k] * root.factor;
    for (std::size_t r = 0; r < radicand_.size(); ++r)
      if ((k & root.roots & (1u << r)) != 0) factor = factor * radicand_[r];
    Algebraic& at = result[k ^ root.roots];
    at = at + factor;
  }
  return result;
}

ExactMetric::Sum ExactMetric::product(const Sum& a, const Sum& b) const {
  Sum result(a.size());
  for (std::uint32_t k = 0; k < b.size(); ++k)
    if (!b[k].is_zero()) result = sum(result, times_root(a, {b[k], k}));
  return result;
}

}  // namespace tripus::structure::detail
