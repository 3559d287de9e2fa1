#include "studies/detail/spectrum.hpp"

#include "energies/co_volume.hpp"

namespace tripus::studies::detail {

Spectrum spectrum(const topology::Triangulation& triangulation, std::span<const double> lengths) {
  const energies::CoVolume energy(triangulation);
  return solver::extreme_eigenvalues(energy.at(lengths, solver::Order::kSecond));
}

}  // namespace tripus::studies::detail
