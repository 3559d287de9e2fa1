#include "structure/proof/detail/edge_sums.hpp"

#include <algorithm>
#include <atomic>
#include <map>

#include "base/threads.hpp"
#include "geometry/enclosure.hpp"

namespace tripus::structure::detail {
namespace {

using geometry::kEnclosed;
using geometry::kLanes;
using topology::Triangulation;

constexpr std::size_t kBlocksOfChunk = 64;
constexpr std::size_t kTetrahedraOfChunk = kBlocksOfChunk * kLanes;
constexpr std::size_t kChunksOfThread = 4;

/// The numbers of a chunk of tetrahedra.
struct Chunk {
  explicit Chunk(std::size_t blocks)
      : lengths(blocks * 6 * kLanes),
        radii(blocks * 6 * kLanes),
        found(blocks * kEnclosed * kLanes) {}
  std::vector<double> lengths, radii, found;
};

struct EnclosingPass {
  const Triangulation& triangulation;
  std::span<const double> lengths, box;
  const ProveOptions& options;
  const Context& context;
  Pass pass{};

  std::size_t chunk_size(std::size_t first) const {
    return std::min(kTetrahedraOfChunk, triangulation.tetrahedron_count() - first);
  }

  void compute(std::size_t first, Chunk& chunk) const {
    const std::size_t count = chunk_size(first), blocks = geometry::block_count(count);
    const auto classes = triangulation.edge_classes().subspan(6 * first);
    for (std::size_t t = 0; t < kLanes * blocks; ++t) {
      for (std::size_t e = 0; e < 6; ++e) {
        const std::size_t at = (t / kLanes * 6 + e) * kLanes + t % kLanes;
        const std::size_t edge = classes[6 * std::min(t, count - 1) + e];
        chunk.lengths[at] = lengths[edge];
        chunk.radii[at] = box[edge];
      }
    }
    geometry::enclosure_kernels().enclose(blocks, chunk.lengths.data(), chunk.radii.data(),
                                          chunk.found.data(), options.volume);
  }

  void add(std::size_t first, const Chunk& chunk) {
    const std::size_t count = chunk_size(first);
    SumEnclosure volume;
    auto flat = std::ranges::lower_bound(options.flat, first);
    for (std::size_t t = 0; t < count; ++t) {
      if (flat != options.flat.end() && *flat == first + t) {
        ++flat;
        continue;
      }
      const double* found = chunk.found.data() + t / kLanes * kEnclosed * kLanes + t % kLanes;
      if (!(found[geometry::kWeight * kLanes] > 0)) {
        pass.unsound.push_back(first + t);
        continue;
      }
      for (std::size_t e = 0; e < 6; ++e) {
        EdgeSum& sum = pass.edges[triangulation.edge_class(first + t, static_cast<int>(e))];
        sum.angle.add(found[(geometry::kAngleMid + e) * kLanes],
                      found[(geometry::kAngleRadius + e) * kLanes],
                      found[(geometry::kAngleLow + e) * kLanes]);
        sum.weight = (sum.weight + found[(geometry::kWeight + e) * kLanes]) * (1 - 0x1p-48);
      }
      volume.add(found[geometry::kVolumeMid * kLanes], found[geometry::kVolumeRadius * kLanes]);
    }
    pass.volume.add(volume);
  }

  void run() {
    const std::size_t count = triangulation.tetrahedron_count();
    const std::size_t chunks = (count + kTetrahedraOfChunk - 1) / kTetrahedraOfChunk;
    const std::size_t threads = std::clamp<std::size_t>(thread_count(context.threads), 1,
                                                        std::max<std::size_t>(1, chunks / 2));
    std::vector<Chunk> wave(std::min(chunks, threads == 1 ? 1 : threads * kChunksOfThread),
                            Chunk(geometry::block_count(std::min(count, kTetrahedraOfChunk))));
    for (std::size_t begin = 0; begin < chunks; begin += wave.size()) {
      if (context.stop_requested() || context.expired()) {
        pass.stopped = true;
        return;
      }
      const std::size_t end = std::min(chunks, begin + wave.size());
      std::atomic<std::size_t> next = begin;
      const auto work = [&] {
        for (std::size_t c = next++; c < end; c = next++)
          compute(c * kTetrahedraOfChunk, wave[c - begin]);
      };
      run_on_threads(threads, work);
      for (std::size_t c = begin; c < end; ++c) add(c * kTetrahedraOfChunk, wave[c - begin]);
    }
  }
};

}  // namespace

Pass enclose_all(const Triangulation& triangulation, std::span<const double> lengths,
                 std::span<const double> box, const ProveOptions& options, const Context& context) {
  EnclosingPass run{triangulation, lengths, box, options, context};
  run.pass.edges.resize(triangulation.edge_count());
  run.run();
  return std::move(run.pass);
}

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
