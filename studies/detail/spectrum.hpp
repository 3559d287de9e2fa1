#pragma once

#include <span>

#include "solver/extreme_eigenvalues.hpp"
#include "topology/triangulation.hpp"

namespace tripus::studies::detail {

/// Extreme eigenvalues of the Hessian of the co-volume at lengths [E].
using Spectrum = solver::ExtremeEigenvalues;
Spectrum spectrum(const topology::Triangulation& triangulation, std::span<const double> lengths);

}  // namespace tripus::studies::detail
