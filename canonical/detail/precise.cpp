// The second pass. Newton's method in 50 digits with the Jacobian in double precision: every step
// multiplies the error by the relative error of the Jacobian, some 1e-14, so that a handful of
// steps reach the end of the digits at the cost of one sparse factorisation.
#include "canonical/detail/precise.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/SparseCholesky>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <fmt/format.h>

#include "base/error.hpp"
#include "energies/co_volume.hpp"

namespace tripus::canonical::detail {
namespace {

using Real = boost::multiprecision::cpp_bin_float_50;
using topology::ConeAngle;
using topology::Triangulation;
using Factor = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>;

/// Curvatures below this are those of the metric as far as 50 digits can tell.
const Real kCurvature("1e-46");
constexpr int kMaxSteps = 12;
/// Curvatures above this are not those of a metric that was found in double precision.
constexpr double kStartingCurvature = 1e-7;

/// The Hessian of the co-volume, factorised. Lengths that change no angle are held: of one edge a
/// cusp, the pins of docs/theory.md 10.3, and of parabolic edges.
void factorise(const energies::CoVolume& energy, std::span<const double> lengths, Factor& factor) {
  const auto at = energy.at(lengths, solver::Order::kSecond);
  if (!at.is_defined()) throw InternalError("the lengths are not those of true tetrahedra");
  const solver::SparsityPattern& pattern = energy.hessian_pattern();
  std::vector<double> values(pattern.row.size());
  at.hessian_values(values);
  const auto size = static_cast<Eigen::Index>(lengths.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index column = 0; column < size; ++column) {
    const auto c = static_cast<std::size_t>(column);
    for (auto k = pattern.column_start[c]; k < pattern.column_start[c + 1]; ++k)
      entries.emplace_back(pattern.row[static_cast<std::size_t>(k)], column,
                           values[static_cast<std::size_t>(k)]);
    if (energy.cone_angles()[c] == 0) entries.emplace_back(column, column, 1.0);
  }
  // Anything > 0 would do; 1 also where the length of the pin matters to nothing.
  for (const std::uint32_t pin : energy.pins())
    entries.emplace_back(
        pin, pin, std::max(1.0, values[static_cast<std::size_t>(pattern.column_start[pin])]));
  Eigen::SparseMatrix<double> hessian(size, size);
  hessian.setFromTriplets(entries.begin(), entries.end());
  factor.compute(hessian);
}

/// The metric in 50 digits.
class Metric {
 public:
  Metric(const Triangulation& triangulation, std::span<const double> lengths,
         std::span<const ConeAngle> cone_angles, std::span<const Diagonal> diagonals)
      : triangulation_(triangulation), diagonals_(diagonals), x_(lengths.begin(), lengths.end()) {
    const Real pi = boost::math::constants::pi<Real>();
    for (const ConeAngle& k : topology::completed(cone_angles, x_.size())) {
      const Real angle =
          k.is_rational() ? Real(pi * k.numerator() / k.denominator()) : Real(k.radians());
      turn_.push_back({cos(angle), k.is_full() ? Real(0) : Real(sin(angle))});
    }
    for (std::size_t e = 0; e < x_.size(); ++e) {
      const auto corner = triangulation.corners(e)[0];
      const auto& d = diagonals[corner.tetrahedron()];
      const auto ends = topology::kEdgeEnds[static_cast<std::size_t>(corner.edge())];
      ends_.push_back({d[static_cast<std::size_t>(ends[0])], d[static_cast<std::size_t>(ends[1])]});
    }
    const energies::CoVolume energy(triangulation, cone_angles);
    improve(energy, lengths);
    set_horospheres(energy);
  }

  std::array<TiltTerms<Real>, 4> tilts(std::size_t t) const {
    return tetrahedron_tilts(cofactors_of(t), diagonals_[t]);
  }

 private:
  std::array<Real, 6> gram_of(std::size_t t) const {
    std::array<Real, 6> a;
    for (std::size_t e = 0; e < 6; ++e)
      a[e] = gram_[triangulation_.edge_class(t, static_cast<int>(e))];
    return a;
  }
  Cofactors<Real> cofactors_of(std::size_t t) const { return cofactors(gram_of(t), diagonals_[t]); }

  void set_gram() {
    gram_.clear();
    slope_.clear();
    for (std::size_t e = 0; e < x_.size(); ++e) {
      gram_.push_back(minus_gram(x_[e], ends_[e][0], ends_[e][1]));
      slope_.push_back(sqrt(squared_slope(gram_[e], ends_[e][0], ends_[e][1])));
    }
  }

  /// Edge curvatures without a transcendental function beyond those of the Gram entries. By
  /// docs/theory.md (10) the numbers c_kl + i sqrt(D) s_ij have the dihedral angles as arguments,
  /// so that their product around an edge has the argument k - K, k the cone angle; the lengths are
  /// those of the metric to double precision already, so that K is small and three terms of the arc
  /// sine leave an error of K^7.
  std::vector<Real> curvatures() {
    set_gram();
    std::vector<Real> re, im;
    for (const auto& [c, s] : turn_) re.push_back(c), im.push_back(-s);
    for (std::size_t t = 0; t < triangulation_.tetrahedron_count(); ++t) {
      const Cofactors<Real> g = cofactors_of(t);
      const Real root = sqrt(g.D);
      for (int e = 0; e < 6; ++e) {
        const auto opposite = topology::kEdgeEnds[static_cast<std::size_t>(5 - e)];
        const std::size_t k = triangulation_.edge_class(t, e);
        const Real& u =
            g.c[static_cast<std::size_t>(opposite[0])][static_cast<std::size_t>(opposite[1])];
        const Real v = root * slope_[k];
        const Real product = re[k] * u - im[k] * v;
        im[k] = re[k] * v + im[k] * u;
        re[k] = product;
      }
    }
    std::vector<Real> K;
    for (std::size_t k = 0; k < x_.size(); ++k) {
      const Real y = -im[k] / sqrt(re[k] * re[k] + im[k] * im[k]);
      if (re[k] < 0 || abs(y) > kStartingCurvature)
        throw InternalError("the lengths are not those of a metric to double precision");
      const Real y2 = y * y;
      K.push_back(y * (1 + y2 * (Real(1) / 6 + y2 * (Real(3) / 40))));
    }
    return K;
  }

  /// Lengths of the metric to about 48 digits.
  void improve(const energies::CoVolume& energy, std::span<const double> lengths) {
    Factor factor;
    factorise(energy, lengths, factor);
    Eigen::VectorXd right(static_cast<Eigen::Index>(x_.size()));
    Real largest = 1;
    for (int step = 0; step < kMaxSteps; ++step) {
      const std::vector<Real> K = curvatures();
      largest = 0;
      for (const Real& k : K)
        if (abs(k) > largest) largest = abs(k);
      if (largest < kCurvature) return;
      // The right side is scaled to 1, so that doubles hold it however small it has become.
      for (std::size_t e = 0; e < x_.size(); ++e)
        right[static_cast<Eigen::Index>(e)] = static_cast<double>(Real(K[e] / largest));
      const Eigen::VectorXd direction = factor.solve(right);
      for (std::size_t e = 0; e < x_.size(); ++e)
        x_[e] += largest * Real(direction[static_cast<Eigen::Index>(e)]);
    }
    throw InternalError(
        fmt::format("the lengths could not be improved to 50 digits: the curvature "
                    "{:.3g} remains",
                    static_cast<double>(largest)));
  }

  /// Twice the areas [V] of the horospheres that belong to the lengths: at ideal vertex i two sides
  /// of its triangle (80) and the sine (10) of the angle between them.
  std::vector<Real> horosphere_areas() const {
    std::vector<Real> areas(triangulation_.vertex_count(), Real(0));
    for (std::size_t t = 0; t < triangulation_.tetrahedron_count(); ++t) {
      const Diagonal& d = diagonals_[t];
      const std::array<Real, 6> a = gram_of(t);
      const Cofactors<Real> g = cofactors(a, d);
      for (std::size_t i = 0; i < 4; ++i) {
        if (d[i] != 0) continue;
        const std::size_t j = (i + 1) % 4, k = (i + 2) % 4, l = (i + 3) % 4;
        const auto side = [&](std::size_t u, std::size_t v) {
          const Real& iu = a[edge(i, u)];
          const Real& iv = a[edge(i, v)];
          return Real(sqrt(d[u] / (iu * iu) + d[v] / (iv * iv) + 2 * a[edge(u, v)] / (iu * iv)));
        };
        const Real& slope = slope_[triangulation_.edge_class(t, static_cast<int>(edge(i, j)))];
        const Real sine = sqrt(g.D / (g.c[k][k] * g.c[l][l])) * slope;
        areas[triangulation_.vertex_class(t, static_cast<int>(i))] +=
            side(j, k) * side(j, l) * sine;
      }
    }
    return areas;
  }

  void set_horospheres(const energies::CoVolume& energy) {
    if (energy.is_hyperideal()) return;
    std::vector<Real> shift = horosphere_areas();
    for (Real& s : shift) s = s == 0 ? Real(0) : Real(log(s) / 2);
    for (std::size_t e = 0; e < x_.size(); ++e) {
      const auto corner = triangulation_.corners(e)[0];
      for (const int end : topology::kEdgeEnds[static_cast<std::size_t>(corner.edge())])
        x_[e] += shift[triangulation_.vertex_class(corner.tetrahedron(), end)];
    }
    set_gram();
  }

  static std::size_t edge(std::size_t i, std::size_t j) {
    return static_cast<std::size_t>(topology::kEdgeNumber[i][j]);
  }

  const Triangulation& triangulation_;
  std::span<const Diagonal> diagonals_;
  std::vector<std::array<Real, 2>> turn_;  // [E] cosine and sine of the cone angle
  std::vector<std::array<int, 2>> ends_;   // [E] diagonal entries at the ends
  std::vector<Real> x_;                    // [E]
  std::vector<Real> gram_, slope_;         // [E] of x_
};

}  // namespace

std::vector<Diagonal> diagonals(const Triangulation& triangulation,
                                std::span<const ConeAngle> cone_angles) {
  const auto links = topology::orbifold_links(triangulation, cone_angles);
  std::vector<Diagonal> result(triangulation.tetrahedron_count());
  for (std::size_t t = 0; t < result.size(); ++t) {
    for (std::size_t v = 0; v < 4; ++v) {
      const auto kind = links[triangulation.vertex_class(t, static_cast<int>(v))].kind;
      if (kind == topology::VertexKind::kFinite)
        throw InvalidInput("a finite vertex: tilts are for hyperideal and ideal vertices");
      result[t][v] = kind == topology::VertexKind::kHyperideal ? 1 : 0;
    }
  }
  return result;
}

std::vector<Tilt> precise_tilt_sums(const Triangulation& triangulation,
                                    std::span<const double> lengths,
                                    std::span<const ConeAngle> cone_angles,
                                    std::span<const Diagonal> diagonals,
                                    std::span<const FacePlace> faces) {
  const Metric metric(triangulation, lengths, cone_angles, diagonals);
  std::vector<Tilt> sums;
  for (const FacePlace& place : faces) {
    const auto [t, f] = place;
    const auto other = triangulation.gluings().neighbour(t, f);
    const int face = triangulation.gluings().gluing(t, f)(f);
    const auto here = metric.tilts(t)[static_cast<std::size_t>(f)];
    const auto there = metric.tilts(other)[static_cast<std::size_t>(face)];
    sums.push_back({static_cast<double>(Real(here.geodesic + there.geodesic)),
                    static_cast<double>(Real(here.cusp + there.cusp))});
  }
  return sums;
}

}  // namespace tripus::canonical::detail
