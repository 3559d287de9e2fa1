#include "structure/proof/detail/edge_sums.hpp"

#include <algorithm>
#include <atomic>

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

}  // namespace tripus::structure::detail
