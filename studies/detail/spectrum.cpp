#include "studies/detail/spectrum.hpp"

#include <Eigen/Eigenvalues>

namespace tripus::studies::detail {

Eigen::MatrixXd dense_hessian(energies::CoVolume& energy, std::span<const double> lengths) {
  std::vector<double> gradient(lengths.size());
  energy.evaluate(lengths, gradient, {.value = nullptr, .second_derivatives = true});
  const solver::SparsityPattern& pattern = energy.hessian_pattern();
  std::vector<double> values(pattern.row.size());
  energy.hessian_values(values);
  const auto n = static_cast<Eigen::Index>(lengths.size());
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    for (auto k = pattern.column_start[std::size_t(j)];
         k < pattern.column_start[std::size_t(j) + 1]; ++k) {
      const Eigen::Index i = pattern.row[std::size_t(k)];
      H(i, j) = H(j, i) = values[std::size_t(k)];
    }
  }
  return H;
}

Spectrum spectrum(const topology::Triangulation& triangulation, std::span<const double> lengths) {
  energies::CoVolume energy(triangulation);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(dense_hessian(energy, lengths));
  const Eigen::VectorXd slowest = solver.eigenvectors().col(0);
  return {solver.eigenvalues().minCoeff(),
          solver.eigenvalues().maxCoeff(),
          {slowest.data(), slowest.data() + slowest.size()}};
}

}  // namespace tripus::studies::detail
