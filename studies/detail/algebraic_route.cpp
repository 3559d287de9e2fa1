#include "studies/detail/algebraic_route.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Dense>
#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

namespace tripus::studies::detail {
namespace {

namespace mp = boost::multiprecision;
using Wide = mp::number<mp::cpp_bin_float<60>, mp::et_off>;
/// For the volumes, whose integrand is costly.
using Medium = mp::number<mp::cpp_bin_float<32>, mp::et_off>;

template <class Real>
using Matrix4 = std::array<std::array<Real, 4>, 4>;

/// (-1)^(i+j) times the minor of row i and column j.
template <class Real>
Real cofactor(const Matrix4<Real>& a, int i, int j) {
  int r[3], c[3];
  for (int k = 0, p = 0, q = 0; k < 4; ++k) {
    if (k != i) r[p++] = k;
    if (k != j) c[q++] = k;
  }
  const auto at = [&](int p, int q) -> const Real& {
    return a[std::size_t(r[p])][std::size_t(c[q])];
  };
  const Real minor = at(0, 0) * (at(1, 1) * at(2, 2) - at(1, 2) * at(2, 1)) -
                     at(0, 1) * (at(1, 0) * at(2, 2) - at(1, 2) * at(2, 0)) +
                     at(0, 2) * (at(1, 0) * at(2, 1) - at(1, 1) * at(2, 0));
  return (i + j) % 2 == 0 ? minor : Real(-minor);
}

template <class Real>
Real determinant(const Matrix4<Real>& a) {
  Real sum = 0;
  for (int j = 0; j < 4; ++j) sum += a[0][std::size_t(j)] * cofactor(a, 0, j);
  return sum;
}

/// Matrix with diagonal 1 and the six entries off it, order 01 02 03 12 13 23.
template <class Real>
Matrix4<Real> symmetric(const std::array<Real, 6>& entries) {
  Matrix4<Real> a;
  for (std::size_t i = 0; i < 4; ++i) a[i][i] = 1;
  for (std::size_t e = 0; e < 6; ++e) {
    const auto [i, j] = topology::kEdgeEnds[e];
    a[std::size_t(i)][std::size_t(j)] = a[std::size_t(j)][std::size_t(i)] = entries[e];
  }
  return a;
}

/// Cosine and sine of a dihedral angle.
template <class Real>
struct Unit {
  Real cosine, sine;
};

/// Of the six edges from c [6] > 1; false where this is not a truncated tetrahedron.
template <class Real>
bool dihedral_units(const std::array<Real, 6>& c, std::array<Unit<Real>, 6>& out) {
  using std::sqrt;
  std::array<Real, 6> entries;
  for (std::size_t e = 0; e < 6; ++e) {
    if (!(c[e] > 1)) return false;
    entries[e] = -c[e];
  }
  const Matrix4<Real> G = symmetric(entries);
  const Real D = -determinant(G);
  if (!(D > 0)) return false;
  for (std::size_t e = 0; e < 6; ++e) {
    const auto [k, l] = topology::kEdgeEnds[5 - e];  // the opposite edge
    const Real size = sqrt(cofactor(G, k, k) * cofactor(G, l, l));
    out[e] = {cofactor(G, k, l) / size, sqrt(D * (c[e] * c[e] - 1)) / size};
  }
  return true;
}

/// The gluing equations in one precision.
template <class Real>
class GluingEquations {
 public:
  explicit GluingEquations(const topology::Triangulation& m) : m_(m) {}

  /// For every edge class the product of its units, and the sum of its angles in double precision.
  /// False outside the truncated tetrahedra.
  bool evaluate(const std::vector<Real>& c, std::vector<Unit<Real>>& product,
                std::vector<double>& sum) const {
    product.assign(c.size(), {Real(1), Real(0)});
    sum.assign(c.size(), 0);
    std::array<Unit<Real>, 6> unit;
    for (std::size_t t = 0; t < m_.tetrahedron_count(); ++t) {
      std::array<Real, 6> entries;
      for (int e = 0; e < 6; ++e) entries[std::size_t(e)] = c[m_.edge_class(t, e)];
      if (!dihedral_units(entries, unit)) return false;
      for (int e = 0; e < 6; ++e) {
        const Unit<Real>& z = unit[std::size_t(e)];
        Unit<Real>& p = product[m_.edge_class(t, e)];
        p = {p.cosine * z.cosine - p.sine * z.sine, p.cosine * z.sine + p.sine * z.cosine};
        sum[m_.edge_class(t, e)] += std::atan2(double(z.sine), double(z.cosine));
      }
    }
    return true;
  }

 private:
  const topology::Triangulation& m_;
};

/// J_ef = d (angle sum of e) / d c_f by central differences; near a solution also the derivative of
/// the imaginary parts. False where a neighbouring point is outside.
bool jacobian(const GluingEquations<double>& equations, const std::vector<double>& c,
              Eigen::MatrixXd& J) {
  const auto n = Eigen::Index(c.size());
  J.resize(n, n);
  std::vector<Unit<double>> product;
  std::vector<double> above, below;
  for (Eigen::Index f = 0; f < n; ++f) {
    std::vector<double> moved = c;
    const double h = 1e-5 * (c[std::size_t(f)] - 1);
    moved[std::size_t(f)] = c[std::size_t(f)] + h;
    if (!equations.evaluate(moved, product, above)) return false;
    moved[std::size_t(f)] = c[std::size_t(f)] - h;
    if (!equations.evaluate(moved, product, below)) return false;
    for (Eigen::Index e = 0; e < n; ++e)
      J(e, f) = (above[std::size_t(e)] - below[std::size_t(e)]) / (2 * h);
  }
  return J.allFinite();
}

double defect(const std::vector<double>& sum) {
  double squares = 0;
  for (const double s : sum) squares += std::pow(s - 2 * std::numbers::pi, 2);
  return std::sqrt(squares);
}

/// Damped Newton steps on the angle sums from equal lengths, in double precision.
bool approach(const topology::Triangulation& m, std::vector<double>& c) {
  const GluingEquations<double> equations(m);
  // Regular tetrahedra whose mean angle is right: c = cos t / (2 cos t - 1).
  const double t =
      2 * std::numbers::pi * double(m.edge_count()) / (6.0 * double(m.tetrahedron_count()));
  c.assign(m.edge_count(), std::cos(t) / (2 * std::cos(t) - 1));
  std::vector<Unit<double>> product;
  std::vector<double> sum;
  Eigen::MatrixXd J;
  for (int step = 0; step < 200; ++step) {
    if (!equations.evaluate(c, product, sum)) return false;
    const double now = defect(sum);
    if (now < 1e-9) return true;
    if (!jacobian(equations, c, J)) return false;
    Eigen::VectorXd rhs(Eigen::Index(c.size()));
    for (std::size_t e = 0; e < c.size(); ++e) rhs[Eigen::Index(e)] = 2 * std::numbers::pi - sum[e];
    const Eigen::VectorXd direction = J.partialPivLu().solve(rhs);
    std::vector<double> trial(c.size());
    double length = 1;
    for (;; length /= 2) {
      if (length < 1e-10) return false;
      for (std::size_t e = 0; e < c.size(); ++e)
        trial[e] = c[e] + length * direction[Eigen::Index(e)];
      if (equations.evaluate(trial, product, sum) && defect(sum) < now) break;
    }
    c = trial;
  }
  return false;
}

/// Newton steps in 60 digits with the Jacobian of the start: each gains as many digits as that has.
bool polish(const topology::Triangulation& m, const std::vector<double>& start,
            std::vector<Wide>& c, AlgebraicMetric& result) {
  Eigen::MatrixXd J;
  if (!jacobian(GluingEquations<double>(m), start, J)) return false;
  const Eigen::PartialPivLU<Eigen::MatrixXd> lu(J);
  const GluingEquations<Wide> equations(m);
  std::vector<Unit<Wide>> product;
  std::vector<double> sum;
  c.assign(start.begin(), start.end());
  for (int step = 0; step <= 40; ++step) {
    if (!equations.evaluate(c, product, sum)) return false;
    Wide largest = 0;
    for (const auto& p : product) largest = std::max(largest, Wide(abs(p.sine)));
    Eigen::VectorXd rhs(Eigen::Index(c.size()));
    // Scaled, for the right side may be below what a double can hold next to 1.
    for (std::size_t e = 0; e < c.size(); ++e)
      rhs[Eigen::Index(e)] = largest > 0 ? double(Wide(product[e].sine / largest)) : 0;
    const Eigen::VectorXd direction = lu.solve(rhs);
    result.newton_steps = step;
    result.residual = double(largest);
    result.distance_bound = direction.cwiseAbs().maxCoeff() * double(largest);
    if (largest < Wide("1e-55")) break;
    for (std::size_t e = 0; e < c.size(); ++e) c[e] -= Wide(direction[Eigen::Index(e)]) * largest;
  }
  if (!(result.residual < 1e-50)) return false;
  for (std::size_t e = 0; e < c.size(); ++e)  // 2 pi, and not 0 or 4 pi
    if (!(product[e].cosine > 0) || std::fabs(sum[e] - 2 * std::numbers::pi) > 1e-6) return false;
  return true;
}

/// Lengths [6] of the truncated tetrahedron with dihedral angles theta [6]: the same cofactors for
/// the matrix with entries -cos theta, in which edge e stands for the opposite one.
std::array<Medium, 6> lengths_of(const std::array<Medium, 6>& theta) {
  std::array<Medium, 6> entries;
  // Faces k and l meet in the edge that has neither vertex.
  for (std::size_t e = 0; e < 6; ++e) entries[5 - e] = -cos(theta[e]);
  const Matrix4<Medium> g = symmetric(entries);
  std::array<Medium, 6> lengths;
  for (std::size_t e = 0; e < 6; ++e) {
    const auto [i, j] = topology::kEdgeEnds[e];
    const Medium ratio = cofactor(g, i, j) / sqrt(cofactor(g, i, i) * cofactor(g, j, j));
    lengths[e] = ratio > 1 ? acosh(ratio) : Medium(0);  // 1 within rounding next to s = 0
  }
  return lengths;
}

/// Schlaefli: dV = -1/2 sum l dtheta, along s theta from the regular ideal octahedron at s = 0,
/// where all lengths are 0 and the volume is 4 times Catalan's constant.
Medium schlaefli_volume(const std::array<Medium, 6>& theta) {
  thread_local boost::math::quadrature::tanh_sinh<Medium> rule(8);  // its tables are costly
  const auto integrand = [&](const Medium& s) {
    std::array<Medium, 6> scaled;
    for (std::size_t e = 0; e < 6; ++e) scaled[e] = s * theta[e];
    const std::array<Medium, 6> l = lengths_of(scaled);
    Medium sum = 0;
    for (std::size_t e = 0; e < 6; ++e) sum += l[e] * theta[e];
    return sum;
  };
  const Medium integral = rule.integrate(integrand, Medium(0), Medium(1), Medium("1e-11"));
  return 4 * boost::math::constants::catalan<Medium>() - integral / 2;
}

}  // namespace

std::optional<std::array<double, 6>> dihedral_angles_in_60_digits(const std::array<double, 6>& l) {
  std::array<Wide, 6> c;
  for (std::size_t e = 0; e < 6; ++e) c[e] = cosh(Wide(l[e]));
  std::array<Unit<Wide>, 6> unit;
  if (!dihedral_units(c, unit)) return std::nullopt;
  std::array<double, 6> angles;
  for (std::size_t e = 0; e < 6; ++e) angles[e] = double(Wide(atan2(unit[e].sine, unit[e].cosine)));
  return angles;
}

AlgebraicMetric solve_algebraically(const topology::Triangulation& m, const Stop& stop) {
  AlgebraicMetric result;
  std::vector<double> start;
  std::vector<Wide> c;
  result.found = approach(m, start) && !stop && polish(m, start, c, result);
  if (!result.found) return result;
  for (const Wide& value : c) result.lengths.push_back(double(Wide(acosh(value))));
  Medium volume = 0;
  for (std::size_t t = 0; t < m.tetrahedron_count() && !stop; ++t) {
    std::array<Wide, 6> entries;
    std::array<Unit<Wide>, 6> unit;
    for (int e = 0; e < 6; ++e) entries[std::size_t(e)] = c[m.edge_class(t, e)];
    dihedral_units(entries, unit);
    std::array<Medium, 6> theta;
    for (std::size_t e = 0; e < 6; ++e) {
      const Wide angle = atan2(unit[e].sine, unit[e].cosine);
      result.angles.push_back(double(angle));
      theta[e] = Medium(angle);
    }
    volume += schlaefli_volume(theta);
  }
  result.volume = double(volume);
  return result;
}

}  // namespace tripus::studies::detail
