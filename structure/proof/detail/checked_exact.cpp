#include "structure/proof/detail/checked_exact.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "structure/proof/detail/checked_tetrahedron.hpp"

namespace tripus::structure::detail {
namespace {

using topology::VertexKind;

/// Half the precision is for the width of the root, and coefficients may cost all their bits.
constexpr long kFewestBits = 512;
/// Bits of coefficients; those of the tables have up to some hundred.
constexpr long kMostHeight = 2000;
constexpr std::int64_t kMostCopies = 64;
/// Square root number 0 is i s of the edge class that is being looked at.
constexpr std::size_t kSlope = 0;

long height_of(const ExactField& text) {
  long height = RationalPolynomial(text.polynomial).height();
  for (const auto* entries : {&text.gram, &text.horospheres})
    for (const std::string& entry : *entries)
      height = std::max(height, RationalPolynomial(entry).height());
  for (const ExactField::Root& root : text.roots)
    height = std::max(height, RationalPolynomial(root.factor).height());
  return height;
}

std::string shown(const Arb& x) { return fmt::format("{:.6g}", x.mid()); }

using Matrix = std::array<std::array<CheckedNumber, 4>, 4>;

/// A minor of a matrix by the first of its rows.
CheckedNumber minor(const Matrix& m, std::vector<std::size_t> rows,
                    const std::vector<std::size_t>& columns, const CheckedNumber& one) {
  if (rows.empty()) return one;
  const std::size_t top = rows.front();
  rows.erase(rows.begin());
  CheckedNumber sum = one - one;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    std::vector<std::size_t> rest = columns;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(k));
    const CheckedNumber term = m[top][columns[k]] * minor(m, rows, rest, one);
    sum = k % 2 == 0 ? sum + term : sum - term;
  }
  return sum;
}

std::vector<std::size_t> all_but(std::size_t i) {
  std::vector<std::size_t> result{0, 1, 2, 3};
  result.erase(result.begin() + static_cast<std::ptrdiff_t>(i));
  return result;
}

}  // namespace

CheckedExact::CheckedExact(const topology::Triangulation& triangulation,
                           std::span<const topology::ConeAngle> cone_angles,
                           std::span<const topology::OrbifoldLink> links, const ExactField& text)
    : triangulation_(triangulation),
      cone_angles_(cone_angles),
      links_(links),
      text_(text),
      field_(RationalPolynomial(text.polynomial)),
      height_(height_of(text)),
      bits_(kFewestBits + 8 * std::min(height_, kMostHeight)) {
  field_.squares.emplace_back();  // kSlope
}

std::string CheckedExact::refusal() {
  if (height_ > kMostHeight)
    return fmt::format("the field's coefficients have {} bits, and there can be {}", height_,
                       kMostHeight);
  const Precision precision(bits_);
  if (std::string why = read_field(); !why.empty()) return why;
  if (std::string why = read_entries(); !why.empty()) return why;
  for (std::size_t t = 0; t < triangulation_.tetrahedron_count(); ++t) {
    if (std::string why = read_tetrahedron(t); !why.empty()) return why;
    if (std::string why = read_root(t); !why.empty()) return why;
  }
  for (std::size_t e = 0; e < triangulation_.edge_count(); ++e)
    if (std::string why = check_edge(e); !why.empty()) return why;
  return read_horospheres();
}

std::string CheckedExact::read_field() {
  const RationalPolynomial f(text_.polynomial);
  if (f.degree() < 1) return "the field's polynomial is constant";
  if (!field_.find_root(Rational(text_.root.lower), Rational(text_.root.upper),
                        Precision::bits() / 2))
    return fmt::format("the field's polynomial does not change its sign from {} to {}",
                       text_.root.lower, text_.root.upper);
  return {};
}

std::string CheckedExact::read_entries() {
  if (text_.gram.size() != triangulation_.edge_count())
    return fmt::format("the field has {} Gram entries for {} edge classes", text_.gram.size(),
                       triangulation_.edge_count());
  for (std::size_t e = 0; e < text_.gram.size(); ++e) {
    gram_.emplace_back(field_, RationalPolynomial(text_.gram[e]));
    const topology::EdgeCorner corner = triangulation_.corners(e)[0];
    const auto ends = topology::kEdgeEnds[static_cast<std::size_t>(corner.edge())];
    const bool between_planes = diagonal(corner.tetrahedron(), ends[0]) == 1 &&
                                diagonal(corner.tetrahedron(), ends[1]) == 1;
    const Arb a = gram_[e].value();
    if (cone_angles_[e].is_parabolic()) {
      if (!(gram_[e] == number(1)))
        return fmt::format("edge class {}: it is parabolic, but its Gram entry is not 1", e);
    } else if (between_planes ? !(a - Arb(1.0)).positive() : !a.positive()) {
      return fmt::format("edge class {}: its Gram entry, near {}, is not > {}", e, shown(a),
                         between_planes ? 1 : 0);
    }
  }
  return {};
}

std::string CheckedExact::read_tetrahedron(std::size_t t) {
  const CheckedNumber zero(field_), one = number(1);
  Matrix g = {{{zero, zero, zero, zero},
               {zero, zero, zero, zero},
               {zero, zero, zero, zero},
               {zero, zero, zero, zero}}};
  for (std::size_t i = 0; i < 4; ++i) g[i][i] = number(diagonal(t, static_cast<int>(i)));
  for (int e = 0; e < 6; ++e) {
    const auto i = static_cast<std::size_t>(kCheckedEnds[e][0]);
    const auto j = static_cast<std::size_t>(kCheckedEnds[e][1]);
    g[i][j] = g[j][i] = -gram_[triangulation_.edge_class(t, e)];
  }
  CheckedCofactors<CheckedNumber> found{g, zero};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      const CheckedNumber without = minor(g, all_but(i), all_but(j), one);
      found.c[i][j] = (i + j) % 2 == 0 ? without : -without;
    }
  found.D = -minor(g, {0, 1, 2, 3}, {0, 1, 2, 3}, one);
  for (std::size_t i = 0; i < 4; ++i)
    if (!found.c[i][i].value().negative())
      return fmt::format("tetrahedron {}: the minor at vertex {} < 0 fails, it is near {}", t, i,
                         shown(found.c[i][i].value()));
  if (!found.D.value().positive())
    return fmt::format("tetrahedron {}: det G < 0 fails, -det G is near {}", t,
                       shown(found.D.value()));
  tetrahedra_.push_back(std::move(found));
  return {};
}

/// sqrt D as the proof says: one that is adjoined, or a product of such and a number.
std::string CheckedExact::read_root(std::size_t t) {
  if (text_.roots.size() != triangulation_.tetrahedron_count())
    return fmt::format("the field has {} square roots for {} tetrahedra", text_.roots.size(),
                       triangulation_.tetrahedron_count());
  const ExactField::Root& text = text_.roots[t];
  const CheckedNumber& D = tetrahedra_[t].D;
  if (text.of == std::vector<std::size_t>{t}) {
    if (!(CheckedNumber(field_, RationalPolynomial(text.factor)) == number(1)))
      return fmt::format("tetrahedron {}: its square root is not itself times {}", t, text.factor);
    const std::size_t k = field_.squares.size();
    if (k == CheckedField::kMostRoots) return "the field has too many square roots";
    field_.squares.push_back(D.rational_part());
    generator_.push_back(t);
    root_.emplace_back(field_, RationalPolynomial(1), 1u << k);
    return {};
  }
  const RationalPolynomial factor(text.factor);
  CheckedNumber square = CheckedNumber(field_, factor) * CheckedNumber(field_, factor);
  unsigned roots = 0;
  for (const std::size_t u : text.of) {
    const auto found = std::ranges::find(generator_, u);
    const unsigned bit = found == generator_.end() ? 0 : 2u << (found - generator_.begin());
    if (bit == 0 || (roots & bit) != 0)
      return fmt::format("tetrahedron {}: its square root is not made of others by {}", t, u);
    roots |= bit;
    square = square * tetrahedra_[u].D;
  }
  if (!(square == D))
    return fmt::format("tetrahedron {}: the square of its square root is not -det G", t);
  if (!field_.value(factor).positive())
    return fmt::format("tetrahedron {}: its square root is not > 0", t);
  root_.emplace_back(field_, factor, roots);
  return {};
}

/// The product of the rotations c + i s sqrt D around an edge is real, and the angles are nearly
/// what is wanted: theory (103).
std::string CheckedExact::check_edge(std::size_t e) {
  const topology::ConeAngle& wanted = cone_angles_[e];
  if (wanted.is_parabolic()) return {};
  if (!wanted.is_rational() || wanted.denominator() > kMostCopies)
    return fmt::format("edge class {}: its cone angle is no fraction of pi that is dealt with", e);
  CheckedNumber product = number(1);
  Arb sum;
  for (const topology::EdgeCorner& corner : triangulation_.corners(e)) {
    const std::size_t t = corner.tetrahedron();
    const int* ends = kCheckedEnds[corner.edge()];
    const int* others = kCheckedEnds[5 - corner.edge()];
    const auto k = static_cast<std::size_t>(others[0]), l = static_cast<std::size_t>(others[1]);
    const auto& c = tetrahedra_[t].c;
    // (i s)^2 = G_ii G_jj - a^2.
    field_.squares[kSlope] =
        (number(diagonal(t, ends[0]) * diagonal(t, ends[1])) - gram_[e] * gram_[e]).rational_part();
    product = product * (c[k][l] + root_[t] * CheckedNumber(field_, RationalPolynomial(1), 1u));
    Arb cosine = c[k][l].value() / square_root(c[k][k].value() * c[l][l].value()), angle;
    arb_acos(angle.get(), cosine.get(), Precision::bits());
    sum = sum + angle;
  }
  CheckedNumber power = number(1);
  for (std::int64_t n = 0; n < wanted.denominator(); ++n) power = power * product;
  if (power.has_root(kSlope))
    return fmt::format("edge class {}: the product of the rotations around it is not real", e);
  const Arb pi = number_pi(sum);
  const Arb off = Arb(static_cast<double>(wanted.denominator())) * sum -
                  Arb(static_cast<double>(wanted.numerator())) * pi;
  if (!(pi - off.magnitude()).positive())
    return fmt::format("edge class {}: its angles add up to {}", e, shown(sum));
  return {};
}

/// r_v with r_v^2 A_v the same for all cusps, where A_v is the area of a horosphere.
std::string CheckedExact::read_horospheres() {
  const std::size_t count = triangulation_.vertex_count();
  const bool any =
      std::ranges::any_of(links_, [](const auto& link) { return link.kind == VertexKind::kIdeal; });
  horosphere_.assign(count, number(1));
  if (text_.horospheres.empty()) {
    has_horospheres_ = !any;
    return {};
  }
  if (text_.horospheres.size() != count)
    return fmt::format("the field has {} horospheres for {} vertex classes",
                       text_.horospheres.size(), count);
  std::vector<CheckedNumber> area(count, CheckedNumber(field_));
  for (std::size_t t = 0; t < tetrahedra_.size(); ++t)
    for (int i = 0; i < 4; ++i) {
      if (diagonal(t, i) != 0) continue;
      CheckedNumber product = number(2);
      for (int e = 0; e < 6; ++e)
        if (kCheckedEnds[e][0] == i || kCheckedEnds[e][1] == i)
          product = product * gram_[triangulation_.edge_class(t, e)];
      const auto inverse = field_.inverse(product.rational_part());
      if (!inverse) return fmt::format("tetrahedron {}: the area at vertex {} is no number", t, i);
      CheckedNumber& sum = area[triangulation_.vertex_class(t, i)];
      sum = sum + root_[t] * CheckedNumber(field_, *inverse);
    }
  std::optional<CheckedNumber> common;
  for (std::size_t v = 0; v < count; ++v) {
    horosphere_[v] = CheckedNumber(field_, RationalPolynomial(text_.horospheres[v]));
    if (links_[v].kind != VertexKind::kIdeal) {
      if (!(horosphere_[v] == number(1)))
        return fmt::format("vertex class {} is no cusp, but has a horosphere", v);
      continue;
    }
    const CheckedNumber scaled = horosphere_[v] * horosphere_[v] * area[v];
    if (!horosphere_[v].value().positive())
      return fmt::format("the horosphere at vertex class {} is not > 0", v);
    if (!common) common = scaled;
    if (!(scaled == *common))
      return fmt::format("the horosphere at vertex class {} has not the area of the others", v);
  }
  return {};
}

// ---- tilts --------------------------------------------------------------------------------------

/// The tilt (T2), (T3) of docs/canonical.md without - 1 / sqrt(-c_ff D).
CheckedNumber CheckedExact::row_sum(std::size_t t, int f, VertexKind kind) const {
  CheckedNumber sum(field_);
  for (int j = 0; j < 4; ++j)
    if (link(t, j).kind == kind)
      sum = sum + tetrahedra_[t].c[static_cast<std::size_t>(f)][static_cast<std::size_t>(j)] *
                      horosphere_[triangulation_.vertex_class(t, j)];
  return sum;
}

bool CheckedExact::sum_is_zero(std::size_t t, int f, VertexKind kind) const {
  if (kind == VertexKind::kIdeal && !has_horospheres_) return false;
  const topology::Gluings& gluings = triangulation_.gluings();
  const std::size_t other = gluings.neighbour(t, f);
  const int g = gluings.gluing(t, f)(f);
  // c_ff is the determinant of the face, the same on both sides.
  return (row_sum(t, f, kind) * root_[other] + row_sum(other, g, kind) * root_[t]).is_zero();
}

CheckedCofactors<Arb> CheckedExact::cofactors(std::size_t t) const {
  const Precision precision(bits_);
  CheckedCofactors<Arb> result;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) result.c[i][j] = tetrahedra_[t].c[i][j].value();
  result.D = tetrahedra_[t].D.value();
  return result;
}

}  // namespace tripus::structure::detail
