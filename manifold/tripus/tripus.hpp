#pragma once

/// Tripus: hyperbolic metrics with geodesic boundary on compact 3-manifolds.
///
///     auto M = tripus::load("cPcbbbihq");
///     if (const auto* metric = M.metric()) std::printf("%.15g\n", metric->volume());
///
/// Everything that most users need is reached from tripus::Manifold; tripus::parameterise_solid maps
/// a solid in space onto one.

#include "base/error.hpp"
#include "base/version.hpp"
#include "manifold/load.hpp"
#include "manifold/manifold.hpp"
#include "manifold/parameterise.hpp"
