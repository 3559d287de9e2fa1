#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>
#include <vector>

#include <Eigen/Dense>

#include "geometry/paper_formulae.hpp"
#include "studies/study.hpp"
#include "topology/triangulation.hpp"

// The founding paper's own way, in any precision: its formulae for the angles, an explicit flow
// dx/dt = K with a fixed step, and Newton's method on the same formulae, differentiated exactly.

namespace tripus::studies::detail {

/// A number with its derivatives by the six lengths of a tetrahedron.
template <class Real>
struct Dual {
  Real value{};
  Real by[6]{};

  static Dual make(Real value, const Dual& a, Real da) {
    Dual result{value, {}};
    for (int i = 0; i < 6; ++i) result.by[i] = da * a.by[i];
    return result;
  }
  static Dual make(Real value, const Dual& a, Real da, const Dual& b, Real db) {
    Dual result{value, {}};
    for (int i = 0; i < 6; ++i) result.by[i] = da * a.by[i] + db * b.by[i];
    return result;
  }
  friend Dual operator+(const Dual& a, const Dual& b) {
    return make(a.value + b.value, a, 1, b, 1);
  }
  friend Dual operator-(const Dual& a, const Dual& b) {
    return make(a.value - b.value, a, 1, b, -1);
  }
  friend Dual operator*(const Dual& a, const Dual& b) {
    return make(a.value * b.value, a, b.value, b, a.value);
  }
  friend Dual operator/(const Dual& a, const Dual& b) {
    return make(a.value / b.value, a, 1 / b.value, b, -a.value / (b.value * b.value));
  }
  friend bool operator==(const Dual& a, const Dual& b) { return a.value == b.value; }
  friend Dual cosh(const Dual& a) { return make(std::cosh(a.value), a, std::sinh(a.value)); }
  friend Dual sinh(const Dual& a) { return make(std::sinh(a.value), a, std::cosh(a.value)); }
  friend Dual acosh(const Dual& a) {
    return make(std::acosh(a.value), a, 1 / std::sqrt((a.value - 1) * (a.value + 1)));
  }
  friend Dual acos(const Dual& a) {
    return make(std::acos(a.value), a, -1 / std::sqrt((1 - a.value) * (1 + a.value)));
  }
};

/// How a run on the paper's formulae ended.
struct PaperRun {
  std::string_view outcome;  ///< metric, not a number, length not positive, no convergence
  int iterations = 0;
  std::vector<double> lengths;
};

template <class Real>
class PaperRoute {
 public:
  /// Both runs end early, as not converged, once `stop` is set.
  PaperRoute(const topology::Triangulation& triangulation, const Stop& stop)
      : triangulation_(triangulation), stop_(stop) {}

  /// Edge curvatures K [E] at x [E]; false if an angle is not a number.
  bool curvature(const std::vector<Real>& x, std::vector<Real>& K) const {
    K.assign(x.size(), 2 * std::numbers::pi_v<Real>);
    for (std::size_t t = 0; t < triangulation_.tetrahedron_count(); ++t) {
      Real l[6], theta[6];
      for (int e = 0; e < 6; ++e) l[e] = x[triangulation_.edge_class(t, e)];
      if (!geometry::paper_dihedral_angles(l, theta)) return false;
      for (int e = 0; e < 6; ++e) K[triangulation_.edge_class(t, e)] -= theta[e];
    }
    return true;
  }

  /// The same with the matrix A = -dK/dx [E x E]; false if something is not a number.
  bool curvature(const std::vector<Real>& x, std::vector<Real>& K, Eigen::MatrixXd& A) const {
    const auto n = static_cast<Eigen::Index>(x.size());
    K.assign(x.size(), 2 * std::numbers::pi_v<Real>);
    A.setZero(n, n);
    for (std::size_t t = 0; t < triangulation_.tetrahedron_count(); ++t) {
      Dual<Real> l[6], theta[6];
      for (int e = 0; e < 6; ++e) {
        l[e].value = x[triangulation_.edge_class(t, e)];
        l[e].by[e] = 1;
      }
      if (!geometry::paper_dihedral_angles(l, theta)) return false;
      for (int e = 0; e < 6; ++e) {
        const std::size_t row = triangulation_.edge_class(t, e);
        K[row] -= theta[e].value;
        for (int f = 0; f < 6; ++f)
          A(Eigen::Index(row), Eigen::Index(triangulation_.edge_class(t, f))) +=
              double(theta[e].by[f]);
      }
    }
    return A.allFinite();
  }

  /// x += step K until max|K| <= tolerance.
  PaperRun flow(std::vector<Real> x, Real step, Real tolerance, int max_steps) const {
    std::vector<Real> K;
    for (int k = 0;; ++k) {
      if (!curvature(x, K)) return end("not a number", k, x);
      if (largest(K) <= tolerance) return end("metric", k, x);
      if (k == max_steps || stop_) return end("no convergence", k, x);
      for (std::size_t e = 0; e < x.size(); ++e) {
        x[e] += step * K[e];
        if (!(x[e] > 0)) return end("length not positive", k + 1, x);
      }
    }
  }

  /// Newton's method, steps halved while the trial is undefined or has larger |K|.
  PaperRun newton(std::vector<Real> x, Real tolerance, int max_steps) const {
    std::vector<Real> K, trial(x.size()), trial_K;
    Eigen::MatrixXd A;
    for (int k = 0;; ++k) {
      if (!curvature(x, K, A)) return end("not a number", k, x);
      if (largest(K) <= tolerance) return end("metric", k, x);
      if (k == max_steps || stop_) return end("no convergence", k, x);
      Eigen::VectorXd rhs(static_cast<Eigen::Index>(x.size()));
      for (std::size_t e = 0; e < x.size(); ++e) rhs[Eigen::Index(e)] = double(K[e]);
      const Eigen::VectorXd step = A.ldlt().solve(rhs);
      if (!step.allFinite()) return end("not a number", k, x);
      Real length = 1;
      for (;; length /= 2) {
        if (length < Real(1e-9)) return end("no convergence", k, x);
        bool positive = true;
        for (std::size_t e = 0; e < x.size(); ++e) {
          trial[e] = x[e] + length * Real(step[Eigen::Index(e)]);
          positive = positive && trial[e] > 0;
        }
        if (positive && curvature(trial, trial_K) && squares(trial_K) < squares(K)) break;
      }
      x = trial;
    }
  }

 private:
  static Real largest(const std::vector<Real>& K) {
    Real result = 0;
    for (const Real k : K) result = std::max(result, std::fabs(k));
    return result;
  }
  static Real squares(const std::vector<Real>& K) {
    Real result = 0;
    for (const Real k : K) result += k * k;
    return result;
  }
  static PaperRun end(std::string_view outcome, int iterations, const std::vector<Real>& x) {
    return {outcome, iterations, std::vector<double>(x.begin(), x.end())};
  }

  const topology::Triangulation& triangulation_;
  Stop stop_;
};

}  // namespace tripus::studies::detail
