#include "solver/extreme_eigenvalues.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <utility>

#include <Eigen/Dense>

// Lanczos with full reorthogonalisation. The largest eigenvalue comes from the Hessian H, the
// smallest as the largest one of H^-1: its spectrum is spread out where that of H is crowded, and a
// few dozen steps are enough. Conjugate gradients, preconditioned by the diagonal of H, apply H^-1
// to nearly all digits.

namespace tripus::solver {
namespace {

using Vector = Eigen::VectorXd;
using Apply = std::function<bool(const Vector& v, Vector& out)>;

constexpr Eigen::Index kMostSteps = 200;  // of Lanczos
constexpr double kRitzResidual = 1e-11;   // relative, where the largest Ritz value has settled
constexpr double kInverseResidual = 1e-13;
constexpr int kMostConjugate = 20000;  // steps of conjugate gradients, for one solve

std::span<const double> view(const Vector& v) { return {v.data(), std::size_t(v.size())}; }
std::span<double> view(Vector& v) { return {v.data(), std::size_t(v.size())}; }

/// No eigenvector of a problem of ours is orthogonal to this: signs and sizes follow no pattern.
Vector start_vector(Eigen::Index n) {
  Vector v(n);
  std::uint64_t state = 1;
  for (Eigen::Index i = 0; i < n; ++i) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    v[i] = double(state >> 11) * 0x1p-52 - 1;
  }
  return v.normalized();
}

/// Largest eigenvalue of a symmetric operator with its unit eigenvector; 0 where it fails.
double largest_eigenvalue(Eigen::Index n, const Apply& apply, Vector& vector) {
  const Eigen::Index most = std::min(n, kMostSteps);
  std::vector<Vector> basis = {start_vector(n)};
  Vector alpha(most), beta(most), w(n);
  for (Eigen::Index k = 0;; ++k) {
    if (!apply(basis.back(), w)) return 0;
    alpha[k] = basis.back().dot(w);
    for (int twice = 0; twice < 2; ++twice)
      for (const Vector& q : basis) w -= q.dot(w) * q;
    beta[k] = w.norm();
    const Eigen::Index size = k + 1;
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> small;
    small.computeFromTridiagonal(alpha.head(size), beta.head(k));
    const double value = small.eigenvalues()[k];
    const double residual = std::fabs(beta[k] * small.eigenvectors()(k, k));
    if (size == most || !(residual > kRitzResidual * std::fabs(value))) {
      vector = Vector::Zero(n);
      for (Eigen::Index i = 0; i < size; ++i)
        vector += small.eigenvectors()(i, k) * basis[std::size_t(i)];
      vector.normalize();
      return value;
    }
    basis.push_back(w / beta[k]);
  }
}

/// out = H^-1 v. False where H is not positive definite to rounding.
bool apply_inverse(const Evaluation& at, const Vector& diagonal, const Vector& v, Vector& out) {
  Vector r = v, z = r.cwiseQuotient(diagonal), p = z, Hp(v.size());
  out = Vector::Zero(v.size());
  double rz = r.dot(z);
  const double enough = kInverseResidual * v.norm();
  for (int step = 0; step < kMostConjugate && r.norm() > enough; ++step) {
    at.hessian_times(view(std::as_const(p)), view(Hp));
    const double pHp = p.dot(Hp);
    if (!(pHp > 0)) return false;
    out += (rz / pHp) * p;
    r -= (rz / pHp) * Hp;
    z = r.cwiseQuotient(diagonal);
    const double next = r.dot(z);
    p = z + (next / rz) * p;
    rz = next;
  }
  return r.norm() <= 1e3 * enough;
}

}  // namespace

ExtremeEigenvalues extreme_eigenvalues(const Evaluation& at) {
  const auto n = Eigen::Index(at.gradient().size());
  ExtremeEigenvalues result;
  if (n == 0) return result;
  Vector vector(n), diagonal(n);
  result.largest = largest_eigenvalue(
      n,
      [&](const Vector& v, Vector& out) {
        at.hessian_times(view(v), view(out));
        return out.allFinite();
      },
      vector);
  at.hessian_diagonal_blocks(1, view(diagonal));
  if (!(diagonal.minCoeff() > 0)) return result;
  const double inverse = largest_eigenvalue(
      n, [&](const Vector& v, Vector& out) { return apply_inverse(at, diagonal, v, out); }, vector);
  if (!(inverse > 0) || !std::isfinite(inverse)) return result;
  result.smallest = 1 / inverse;
  result.slowest.assign(vector.begin(), vector.end());
  return result;
}

}  // namespace tripus::solver
