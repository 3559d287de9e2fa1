#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "structure/proof/detail/cone_metric.hpp"
#include "structure/proof/detail/precise_tetrahedron.hpp"

/// Tetrahedra with hyperideal and ideal vertices in doubles, by geometry/enclosure.hpp: those from
/// number `begin` on, as many as `found` has places. A place is left empty where doubles do not
/// prove the tetrahedron to be a true one, and where `skip` says so.
namespace tripus::structure::detail {

/// precise_tetrahedron at the lengths [E]; with volumes not those with both kinds of vertices.
void angles_in_doubles(const ConeMetric& metric, std::span<const double> lengths,
                       std::vector<bool> skip, std::size_t begin, bool with_volume,
                       std::span<std::optional<PreciseTetrahedron>> found);
/// precise_jacobian over lengths +- radii [E].
void jacobians_in_doubles(const ConeMetric& metric, std::span<const double> lengths,
                          std::span<const double> radii, const std::vector<bool>& skip,
                          std::size_t begin, std::span<std::optional<std::array<Arb, 21>>> found);

}  // namespace tripus::structure::detail
