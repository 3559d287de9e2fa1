#pragma once

#include <vector>

#include "structure/proof/detail/cone_metric.hpp"

namespace tripus::structure::detail {

/// Moves the horospheres of lengths [E] to one common area, structure::kHorosphereArea. The areas
/// are sums of Euclidean triangles, docs/theory.md (80).
void equalise_horospheres(const ConeMetric& metric, std::vector<Arb>& lengths);

}  // namespace tripus::structure::detail
