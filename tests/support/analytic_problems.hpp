#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Dense>

#include "solver/problem.hpp"
#include "solver/run.hpp"

/// Convex functions with known properties, to try minimisers and flows on.
namespace tripus::testing {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

inline std::span<double> as_span(Vector& v) {
  return {v.data(), static_cast<std::size_t>(v.size())};
}

/// Pattern of a full matrix.
inline solver::SparsityPattern full_pattern(std::size_t n) {
  solver::SparsityPattern pattern;
  pattern.column_start.push_back(0);
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = j; i < n; ++i) pattern.row.push_back(static_cast<std::int32_t>(i));
    pattern.column_start.push_back(static_cast<std::int64_t>(pattern.row.size()));
  }
  return pattern;
}

/// max|g| at x; NaN outside the domain.
inline double max_gradient(const solver::Problem& problem, std::span<const double> x) {
  const auto at = problem.at(x);
  return at ? solver::max_abs(at->gradient()) : std::numeric_limits<double>::quiet_NaN();
}

/// A function given by a lambda f(x, g, H): writes the gradient, H where not null, returns false
/// outside its domain. The Hessian is kept as a full matrix; the pattern may be sparser.
class DenseProblem : public solver::Problem {
 public:
  using Function = std::function<bool(const Vector& x, double& f, Vector& g, Matrix* H)>;

  DenseProblem(std::size_t n, Function function)
      : n_(n), function_(std::move(function)), pattern_(full_pattern(n)) {}

  std::size_t dimension() const override { return n_; }

  bool evaluate(std::span<const double> x, solver::Order order,
                std::unique_ptr<solver::Evaluation>& into) const override {
    ++evaluations;
    At& at = solver::reuse<At>(into, *this);
    return function_(Eigen::Map<const Vector>(x.data(), at.g.size()), at.f, at.g,
                     order == solver::Order::kSecond ? &at.H : nullptr);
  }

  const solver::SparsityPattern& hessian_pattern() const override { return pattern_; }

  void set_pattern(solver::SparsityPattern pattern) { pattern_ = std::move(pattern); }

  mutable long evaluations = 0;

 private:
  struct At final : solver::Evaluation {
    explicit At(const DenseProblem& problem)
        : of(&problem),
          g(Vector::Zero(static_cast<Eigen::Index>(problem.n_))),
          H(Matrix::Zero(g.size(), g.size())) {}

    bool is_of(const DenseProblem& problem) const { return of == &problem; }
    std::span<const double> gradient() const override { return {g.data(), of->n_}; }
    double value() const override { return f; }

    void hessian_values(std::span<double> values) const override {
      const solver::SparsityPattern& pattern = of->pattern_;
      for (std::size_t j = 0; j < of->n_; ++j) {
        for (auto k = static_cast<std::size_t>(pattern.column_start[j]);
             k < static_cast<std::size_t>(pattern.column_start[j + 1]); ++k) {
          values[k] = H(pattern.row[k], static_cast<Eigen::Index>(j));
        }
      }
    }

    void hessian_times(std::span<const double> v, std::span<double> Hv) const override {
      Eigen::Map<Vector>(Hv.data(), g.size()).noalias() =
          H * Eigen::Map<const Vector>(v.data(), g.size());
    }

    void hessian_diagonal_blocks(std::size_t b, std::span<double> blocks) const override {
      std::fill(blocks.begin(), blocks.end(), 0.0);
      for (std::size_t i = 0; i < of->n_; ++i) {
        for (std::size_t j = i / b * b; j < std::min(of->n_, i / b * b + b); ++j) {
          blocks[i / b * b * b + i % b * b + j % b] =
              H(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
        }
      }
    }

    const DenseProblem* of;
    double f = 0;
    Vector g;
    Matrix H;
  };

  std::size_t n_;
  Function function_;
  solver::SparsityPattern pattern_;
};

/// psi(s) of one variable with its first two derivatives.
struct Profile {
  double value, first, second;
};

/// log(1 + e^s): linear to the right, zero to the left, exponentially flat in both.
inline Profile softplus(double s) {
  const double e = std::exp(-std::abs(s));
  const double p = s > 0 ? 1 / (1 + e) : e / (1 + e);
  return {std::max(s, 0.0) + std::log1p(e), p, e / ((1 + e) * (1 + e))};
}
/// sqrt(1 + s^2): the gradient saturates like a power.
inline Profile root(double s) {
  const double r = std::sqrt(1 + s * s);
  return {r, s / r, 1 / (r * r * r)};
}
/// Huber's function: C1, quadratic in [-1,1], exactly linear outside: the Hessian vanishes there.
inline Profile huber(double s) {
  if (std::abs(s) <= 1) return {0.5 * s * s, s, 1};
  return {std::abs(s) - 0.5, s > 0 ? 1.0 : -1.0, 0};
}
inline Profile exponential(double s) { return {std::exp(s), std::exp(s), std::exp(s)}; }
inline Profile quartic(double s) { return {0.25 * s * s * s * s, s * s * s, 3 * s * s}; }
inline Profile square(double s) { return {0.5 * s * s, s, 1}; }

/// sum_k psi(a_k . x - c_k) + b . x, with A [m x n] of rows a_k.
inline std::unique_ptr<DenseProblem> ridge_sum(Profile (*psi)(double), const Matrix& A,
                                               const Vector& c, const Vector& b) {
  return std::make_unique<DenseProblem>(static_cast<std::size_t>(A.cols()),
                                        [=](const Vector& x, double& f, Vector& g, Matrix* H) {
                                          const Vector s = A * x - c;
                                          Vector first(s.size()), second(s.size());
                                          f = b.dot(x);
                                          for (Eigen::Index k = 0; k < s.size(); ++k) {
                                            const Profile p = psi(s[k]);
                                            f += p.value;
                                            first[k] = p.first;
                                            second[k] = p.second;
                                          }
                                          g = A.transpose() * first + b;
                                          if (H != nullptr)
                                            *H = A.transpose() * second.asDiagonal() * A;
                                          return true;
                                        });
}

inline Vector random_vector(Eigen::Index n, std::mt19937& random, double scale = 1) {
  std::uniform_real_distribution<double> uniform(-scale, scale);
  return Vector::NullaryExpr(n, [&](Eigen::Index) { return uniform(random); });
}

/// An orthogonal matrix.
inline Matrix random_rotation(Eigen::Index n, std::mt19937& random) {
  std::normal_distribution<double> normal;
  const Matrix m =
      Matrix::NullaryExpr(n, n, [&](Eigen::Index, Eigen::Index) { return normal(random); });
  return Eigen::HouseholderQR<Matrix>(m).householderQ();
}

/// 1/2 (x - x*).Q(x - x*), eigenvalues of Q spread geometrically over [1, condition].
inline std::unique_ptr<DenseProblem> quadratic(const Vector& minimiser, double condition,
                                               std::mt19937& random) {
  const Eigen::Index n = minimiser.size();
  const Matrix R = random_rotation(n, random);
  const Vector eigenvalues = Vector::NullaryExpr(n, [&](Eigen::Index i) {
    return n == 1 ? condition : std::pow(condition, double(i) / double(n - 1));
  });
  const Matrix Q = R.transpose() * eigenvalues.asDiagonal() * R;
  return std::make_unique<DenseProblem>(static_cast<std::size_t>(n),
                                        [=](const Vector& x, double& f, Vector& g, Matrix* H) {
                                          g = Q * (x - minimiser);
                                          f = 0.5 * g.dot(x - minimiser) + 1e3;
                                          if (H != nullptr) *H = Q;
                                          return true;
                                        });
}

/// log sum_k exp(a_k . x - c_k) + |x|^2 / 20.
inline std::unique_ptr<DenseProblem> log_sum_exp(const Matrix& A, const Vector& c) {
  return std::make_unique<DenseProblem>(
      static_cast<std::size_t>(A.cols()), [=](const Vector& x, double& f, Vector& g, Matrix* H) {
        const Vector s = A * x - c;
        const double top = s.maxCoeff();
        const Vector e = (s.array() - top).exp();
        const Vector p = e / e.sum();
        f = top + std::log(e.sum()) + 0.05 * x.squaredNorm();
        g = A.transpose() * p + 0.1 * x;
        if (H != nullptr) {
          const Vector mean = A.transpose() * p;
          *H = A.transpose() * p.asDiagonal() * A - mean * mean.transpose();
          H->diagonal().array() += 0.1;
        }
        return true;
      });
}

/// c . x - sum log x_i on x > 0, minimiser 1 / c_i.
inline std::unique_ptr<DenseProblem> log_barrier(const Vector& c) {
  return std::make_unique<DenseProblem>(static_cast<std::size_t>(c.size()),
                                        [=](const Vector& x, double& f, Vector& g, Matrix* H) {
                                          if (!(x.minCoeff() > 0)) return false;
                                          f = c.dot(x) - x.array().log().sum();
                                          g = c.array() - x.array().inverse();
                                          if (H != nullptr) {
                                            *H = x.array().square().inverse().matrix().asDiagonal();
                                          }
                                          return true;
                                        });
}

/// A problem, where to start, and its minimiser where it is known (else empty).
struct Case {
  std::string name;
  std::unique_ptr<DenseProblem> problem;
  Vector start;
  Vector minimiser;
};

/// Smooth problems of dimension 1 to 50 with a minimiser and condition numbers below about 1e3.
inline std::vector<Case> well_conditioned_cases(std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<Case> cases;
  for (const Eigen::Index n : {1, 2, 5, 20, 50}) {
    for (const double condition : {1.0, 30.0, 900.0}) {
      Vector minimiser = random_vector(n, random, 3);
      auto problem = quadratic(minimiser, condition, random);
      cases.push_back(
          {"quadratic n=" + std::to_string(n) + " condition=" + std::to_string(condition),
           std::move(problem), Vector::Zero(n), minimiser});
    }
    const Matrix A = Matrix::NullaryExpr(
        4 * n, n, [&](Eigen::Index, Eigen::Index) { return random_vector(1, random)[0]; });
    cases.push_back({"log-sum-exp n=" + std::to_string(n),
                     log_sum_exp(A, random_vector(4 * n, random)),
                     random_vector(n, random, 2),
                     {}});
    cases.push_back({"root n=" + std::to_string(n),
                     ridge_sum(root, A, random_vector(4 * n, random), Vector::Zero(n)),
                     random_vector(n, random, 2),
                     {}});
  }
  return cases;
}

/// Problems with a minimiser, but flat or saturated where the iteration starts.
inline std::vector<Case> flat_start_cases(std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<Case> cases;
  for (const Eigen::Index n : {1, 3, 12}) {
    const Matrix A = Matrix::NullaryExpr(
        5 * n, n, [&](Eigen::Index, Eigen::Index) { return random_vector(1, random)[0]; });
    const Vector c = random_vector(5 * n, random, 0.3);
    // Symmetrised, so that a minimiser exists: psi(s) + psi(-s).
    Matrix both(10 * n, n);
    both << A, -A;
    Vector twice(10 * n);
    twice << c, -c;
    const std::string size = " n=" + std::to_string(n);
    cases.push_back({"huber" + size,
                     ridge_sum(huber, A, c, Vector::Zero(n)),
                     random_vector(n, random, 40),
                     {}});
    cases.push_back({"softplus" + size,
                     ridge_sum(softplus, both, twice, Vector::Zero(n)),
                     random_vector(n, random, 60),
                     {}});
    cases.push_back({"far root" + size,
                     ridge_sum(root, A, c, Vector::Zero(n)),
                     random_vector(n, random, 100),
                     {}});
    // Every variable on its own, minimisers at different distances: saturated one by one.
    const Vector centre = random_vector(n, random, 50);
    cases.push_back({"separate huber" + size,
                     ridge_sum(huber, Matrix::Identity(n, n), centre, Vector::Zero(n)),
                     Vector::Zero(n), centre});
  }
  return cases;
}

/// Functions without a minimiser.
inline std::vector<Case> unbounded_cases() {
  std::vector<Case> cases;
  for (const Eigen::Index n : {1, 4}) {
    const Matrix one = Matrix::Identity(n, n);
    const Vector zero = Vector::Zero(n);
    const std::string size = " n=" + std::to_string(n);
    cases.push_back(
        {"linear" + size, ridge_sum(square, Matrix::Zero(n, n), zero, Vector::Ones(n)), zero, {}});
    cases.push_back({"exponential" + size,
                     ridge_sum(exponential, one, zero, zero),
                     Vector::Constant(n, 1.5),
                     {}});
    cases.push_back(
        {"softplus" + size, ridge_sum(softplus, one, zero, zero), Vector::Constant(n, 6), {}});
    cases.push_back({"softplus minus linear" + size,
                     ridge_sum(softplus, one, zero, Vector::Constant(n, -2)),
                     Vector::Constant(n, 1),
                     {}});
  }
  return cases;
}

}  // namespace tripus::testing
