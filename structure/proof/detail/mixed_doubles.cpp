#include "structure/proof/detail/mixed_doubles.hpp"

#include <algorithm>
#include <map>

#include "geometry/enclosure.hpp"

namespace tripus::structure::detail {
namespace {

using geometry::kLanes;
using geometry::kMixedEnclosed;

/// The tetrahedra of a range by what their vertices are: a kernel wants them to be alike.
std::map<Diagonal, std::vector<std::size_t>> by_kind(const ConeMetric& metric,
                                                     const std::vector<bool>& skip,
                                                     std::size_t begin, std::size_t count) {
  std::map<Diagonal, std::vector<std::size_t>> groups;
  for (std::size_t t = begin; t < begin + count; ++t)
    if (!skip[t]) groups[metric.diagonal(t)].push_back(t);
  return groups;
}

/// `values` [E] at the edges of tetrahedra, in blocks; the last is repeated to the end of its
/// block.
std::vector<double> in_blocks(const topology::Triangulation& triangulation,
                              const std::vector<std::size_t>& tetrahedra,
                              std::span<const double> values) {
  const std::size_t blocks = geometry::block_count(tetrahedra.size());
  std::vector<double> result(blocks * 6 * kLanes);
  for (std::size_t k = 0; k < kLanes * blocks; ++k)
    for (std::size_t e = 0; e < 6; ++e)
      result[(k / kLanes * 6 + e) * kLanes + k % kLanes] = values[triangulation.edge_class(
          tetrahedra[std::min(k, tetrahedra.size() - 1)], static_cast<int>(e))];
  return result;
}

/// For each tetrahedron that is sound `use(t, quantity)`, where quantity(q) is a number of it.
template <class Kernel, class Use>
void enclose(const ConeMetric& metric, const std::vector<bool>& skip, std::size_t begin,
             std::size_t count, Kernel kernel, Use use) {
  for (const auto& [diagonal, tetrahedra] : by_kind(metric, skip, begin, count)) {
    const std::size_t blocks = geometry::block_count(tetrahedra.size());
    std::vector<double> out(blocks * kMixedEnclosed * kLanes);
    kernel(blocks, tetrahedra, gram_diagonal(diagonal), out.data());
    for (std::size_t k = 0; k < tetrahedra.size(); ++k) {
      const double* at = out.data() + k / kLanes * kMixedEnclosed * kLanes + k % kLanes;
      const auto quantity = [at](std::size_t q) { return at[q * kLanes]; };
      if (quantity(geometry::kSound) > 0) use(tetrahedra[k], quantity);
    }
  }
}

}  // namespace

void angles_in_doubles(const ConeMetric& metric, std::span<const double> lengths,
                       std::vector<bool> skip, std::size_t begin, bool with_volume,
                       std::span<std::optional<PreciseTetrahedron>> found) {
  // Volumes of tetrahedra with both kinds of vertices are not sharp.
  for (std::size_t t = begin; with_volume && t < begin + found.size(); ++t) {
    const Diagonal diagonal = metric.diagonal(t);
    if (std::ranges::count(diagonal, diagonal[0]) < 4) skip[t] = true;
  }
  const auto kernel = [&](std::size_t blocks, const std::vector<std::size_t>& tetrahedra,
                          const geometry::GramDiagonal& diagonal, double* out) {
    const auto l = in_blocks(metric.triangulation(), tetrahedra, lengths);
    geometry::enclosure_kernels().mixed_angles(blocks, l.data(), diagonal, out, with_volume);
  };
  enclose(metric, skip, begin, found.size(), kernel, [&](std::size_t t, const auto& quantity) {
    PreciseTetrahedron& here = found[t - begin].emplace();
    for (std::size_t e = 0; e < 6; ++e)
      here.angles[e] =
          (Arb(quantity(geometry::kAngleMid + e)) + Arb(quantity(geometry::kAngleLow + e)))
              .widened(quantity(geometry::kAngleRadius + e));
    here.volume = Arb(quantity(geometry::kVolumeMid)).widened(quantity(geometry::kVolumeRadius));
  });
}

void jacobians_in_doubles(const ConeMetric& metric, std::span<const double> lengths,
                          std::span<const double> radii, const std::vector<bool>& skip,
                          std::size_t begin, std::span<std::optional<std::array<Arb, 21>>> found) {
  const auto kernel = [&](std::size_t blocks, const std::vector<std::size_t>& tetrahedra,
                          const geometry::GramDiagonal& diagonal, double* out) {
    const auto l = in_blocks(metric.triangulation(), tetrahedra, lengths);
    const auto r = in_blocks(metric.triangulation(), tetrahedra, radii);
    geometry::enclosure_kernels().mixed_jacobian(blocks, l.data(), r.data(), diagonal, out);
  };
  enclose(metric, skip, begin, found.size(), kernel, [&](std::size_t t, const auto& quantity) {
    auto& here = found[t - begin].emplace();
    for (std::size_t k = 0; k < here.size(); ++k)
      here[k] = Arb(quantity(geometry::kJacobianMid + k))
                    .widened(quantity(geometry::kJacobianRadius + k));
  });
}

}  // namespace tripus::structure::detail
