#pragma once

#include <span>
#include <vector>

#include <Eigen/Dense>

#include "energies/co_volume.hpp"
#include "topology/triangulation.hpp"

namespace tripus::studies::detail {

/// The Hessian of the co-volume at lengths [E], dense.
Eigen::MatrixXd dense_hessian(energies::CoVolume& energy, std::span<const double> lengths);

/// Its extreme eigenvalues, and the unit eigenvector [E] of the smallest.
struct Spectrum {
  double smallest = 0;
  double largest = 0;
  std::vector<double> slowest = {};
  double condition() const { return largest / smallest; }
};
Spectrum spectrum(const topology::Triangulation& triangulation, std::span<const double> lengths);

}  // namespace tripus::studies::detail
