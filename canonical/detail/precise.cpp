// The second pass. Newton's method in 50 digits with the Jacobian in double precision: every step
// multiplies the error by the relative error of the Jacobian, some 1e-14, so that a handful of
// steps reach the end of the digits at the cost of one sparse factorisation.
#include "canonical/detail/precise.hpp"

#include <cmath>

#include <Eigen/SparseCholesky>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <fmt/format.h>

#include "base/error.hpp"
#include "canonical/detail/tetrahedron_tilts.hpp"
#include "geometry/truncated_tetrahedron.hpp"

namespace tripus::canonical::detail {
namespace {

using Real = boost::multiprecision::cpp_bin_float_50;
using topology::Triangulation;
using Factor = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>;

/// Curvatures below this are those of the metric as far as 50 digits can tell.
const Real kCurvature("1e-46");
constexpr int kMaxSteps = 12;
/// Curvatures above this are not those of a metric that was found in double precision.
constexpr double kStartingCurvature = 1e-7;

/// The Hessian of the co-volume, factorised.
void factorise(const Triangulation& triangulation, std::span<const double> lengths,
               Factor& factor) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(36 * triangulation.tetrahedron_count());
  std::array<double, 6> l, theta;
  std::array<double, 36> jacobian;
  for (std::size_t t = 0; t < triangulation.tetrahedron_count(); ++t) {
    for (std::size_t e = 0; e < 6; ++e)
      l[e] = lengths[triangulation.edge_class(t, static_cast<int>(e))];
    geometry::dihedral_angles(l, theta, jacobian);
    for (std::size_t e = 0; e < 36; ++e) {
      entries.emplace_back(triangulation.edge_class(t, static_cast<int>(e / 6)),
                           triangulation.edge_class(t, static_cast<int>(e % 6)), jacobian[e]);
    }
  }
  const auto size = static_cast<Eigen::Index>(triangulation.edge_count());
  Eigen::SparseMatrix<double> hessian(size, size);
  hessian.setFromTriplets(entries.begin(), entries.end());
  factor.compute(hessian);
}

Cofactors<Real> cofactors_of(const Triangulation& triangulation, const std::vector<Real>& cosh_l,
                             std::size_t t) {
  std::array<Real, 6> a;
  for (std::size_t e = 0; e < 6; ++e)
    a[e] = cosh_l[triangulation.edge_class(t, static_cast<int>(e))];
  return cofactors(a);
}

std::vector<Real> cosines(const std::vector<Real>& x) {
  std::vector<Real> result;
  result.reserve(x.size());
  for (const Real& l : x) result.push_back(cosh(l));
  return result;
}

/// Edge curvatures without a transcendental function beyond cosh. By docs/theory.md (10) the
/// numbers c_kl + i sqrt(D) s_ij have the dihedral angles as arguments, so that their product
/// around an edge has the argument -K, up to 2 pi; the lengths are those of the metric to double
/// precision already, so that K is small and three terms of the arc sine leave an error of K^7.
std::vector<Real> curvatures(const Triangulation& triangulation, const std::vector<Real>& x) {
  const std::vector<Real> a = cosines(x);
  std::vector<Real> s, re(x.size(), Real(1)), im(x.size(), Real(0));
  for (const Real& c : a) s.push_back(sqrt((c - 1) * (c + 1)));
  for (std::size_t t = 0; t < triangulation.tetrahedron_count(); ++t) {
    const Cofactors<Real> g = cofactors_of(triangulation, a, t);
    const Real root = sqrt(g.D);
    for (int e = 0; e < 6; ++e) {
      const auto opposite = topology::kEdgeEnds[static_cast<std::size_t>(5 - e)];
      const std::size_t k = triangulation.edge_class(t, e);
      const Real& u =
          g.c[static_cast<std::size_t>(opposite[0])][static_cast<std::size_t>(opposite[1])];
      const Real v = root * s[k];
      const Real product = re[k] * u - im[k] * v;
      im[k] = re[k] * v + im[k] * u;
      re[k] = product;
    }
  }
  std::vector<Real> K;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const Real y = -im[k] / sqrt(re[k] * re[k] + im[k] * im[k]);
    if (re[k] < 0 || abs(y) > kStartingCurvature)
      throw InternalError("the lengths are not those of a metric to double precision");
    const Real y2 = y * y;
    K.push_back(y * (1 + y2 * (Real(1) / 6 + y2 * (Real(3) / 40))));
  }
  return K;
}

/// Lengths of the metric to about 48 digits.
std::vector<Real> improved(const Triangulation& triangulation, std::span<const double> lengths) {
  std::vector<Real> x(lengths.begin(), lengths.end());
  Factor factor;
  factorise(triangulation, lengths, factor);
  Eigen::VectorXd right(static_cast<Eigen::Index>(x.size()));
  Real largest = 1;
  for (int step = 0; step < kMaxSteps; ++step) {
    const std::vector<Real> K = curvatures(triangulation, x);
    largest = 0;
    for (const Real& k : K)
      if (abs(k) > largest) largest = abs(k);
    if (largest < kCurvature) return x;
    // The right side is scaled to 1, so that doubles hold it however small it has become.
    for (std::size_t e = 0; e < x.size(); ++e)
      right[static_cast<Eigen::Index>(e)] = static_cast<double>(Real(K[e] / largest));
    const Eigen::VectorXd direction = factor.solve(right);
    for (std::size_t e = 0; e < x.size(); ++e)
      x[e] += largest * Real(direction[static_cast<Eigen::Index>(e)]);
  }
  throw InternalError(
      fmt::format("the lengths could not be improved to 50 digits: the curvature "
                  "{:.3g} remains",
                  static_cast<double>(largest)));
}

}  // namespace

std::vector<double> precise_tilt_sums(const Triangulation& triangulation,
                                      std::span<const double> lengths,
                                      std::span<const FacePlace> faces) {
  const std::vector<Real> a = cosines(improved(triangulation, lengths));
  std::vector<double> sums;
  for (const FacePlace& place : faces) {
    const auto [t, f] = place;
    const auto other = triangulation.gluings().neighbour(t, f);
    const int face = triangulation.gluings().gluing(t, f)(f);
    const auto here = tetrahedron_tilts(cofactors_of(triangulation, a, t));
    const auto there = tetrahedron_tilts(cofactors_of(triangulation, a, other));
    const Real sum = here[static_cast<std::size_t>(f)] + there[static_cast<std::size_t>(face)];
    sums.push_back(static_cast<double>(sum));
  }
  return sums;
}

}  // namespace tripus::canonical::detail
