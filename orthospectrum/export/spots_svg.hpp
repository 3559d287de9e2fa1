#pragma once

#include <span>
#include <string>

#include "orthospectrum/identities.hpp"
#include "orthospectrum/spectrum.hpp"

namespace tripus::orthospectrum {

/// Leopard spots: each boundary component developed in the Poincare disc, with its tiling by
/// truncation triangles (a fundamental domain in black), covered by the discs of normals that run
/// into one plane, coloured by the lengths of their arcs. Source: Calegari, arXiv 1005.4858.
/// `spectrum` has its arcs.
std::string spots_as_svg(const topology::Triangulation& triangulation,
                         std::span<const double> edge_lengths, const Spectrum& spectrum,
                         const std::string& title);

/// The counting function: how many arcs there are up to each length, in logarithmic scale, with
/// the growth that the dimension of the limit set gives.
std::string counting_as_svg(const Spectrum& spectrum, const Identities& identities,
                            const std::string& title);

}  // namespace tripus::orthospectrum
