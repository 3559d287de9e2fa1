#include "studies/detail/spectrum.hpp"

#include <vector>

#include "energies/co_volume.hpp"

namespace tripus::studies::detail {

Spectrum spectrum(const topology::Triangulation& triangulation, std::span<const double> lengths) {
  energies::CoVolume energy(triangulation);
  std::vector<double> gradient(lengths.size());
  energy.evaluate(lengths, gradient, {.value = nullptr, .second_derivatives = true});
  return solver::extreme_eigenvalues(energy);
}

}  // namespace tripus::studies::detail
