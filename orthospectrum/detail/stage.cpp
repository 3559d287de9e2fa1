#include "orthospectrum/detail/stage.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <limits>
#include <mutex>
#include <tuple>

#include <fmt/format.h>

#include "base/threads.hpp"
#include "base/tolerances.hpp"

namespace tripus::orthospectrum::detail {
namespace {

/// So many tiles are searched before their results are put together: memory for those of all tiles
/// of a large triangulation would be more than the arcs take.
constexpr std::size_t kTilesAtATime = 1024;

double shortest_in(const Stage& stage, double otherwise) {
  const auto& histogram = stage.sums.histogram();
  for (std::size_t n = 0; n < histogram.size(); ++n)
    if (histogram[n] > 0) return static_cast<double>(n) * Sums::kBin;
  return otherwise;
}

/// A foot on a side of its tile belongs to the tile whose (tetrahedron, vertex, face) is less, as
/// in Unfolding::search. Goes across if need be; returns the face crossed, or -1.
int settle(const Steps& steps, ArcEnd& end, const std::array<double, 4>& products) {
  const Triangle& triangle =
      steps.triangle(end.tile.tetrahedron, static_cast<int>(end.tile.vertex));
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& a = triangle.feet[(k + 1) % 3];
    const auto& b = triangle.feet[(k + 2) % 3];
    const double ax = a[0] / a[2], ay = a[1] / a[2], dx = b[0] / b[2] - ax, dy = b[1] / b[2] - ay;
    const double over = (dx * (end.y - ay) - dy * (end.x - ax)) / std::sqrt(dx * dx + dy * dy);
    if (over > tolerance::kFootOnLine) continue;
    const int face = triangle.corners[k];
    const Step& across = steps.step(end.tile.tetrahedron, face);
    const Tile there{across.tetrahedron, across.labels[end.tile.vertex]};
    const auto key = [](Tile tile, int f) { return std::tuple(tile.tetrahedron, tile.vertex, f); };
    if (key(there, across.labels[static_cast<std::size_t>(face)]) > key(end.tile, face)) continue;
    const auto foot = foot_on(steps.triangle(there.tetrahedron, static_cast<int>(there.vertex)),
                              static_cast<int>(there.vertex), carried(across, face, products));
    end = {there, foot[0], foot[1]};
    return face;
  }
  return -1;
}

/// Whether an arc is listed from this end: exactly one of its two orientations is.
bool begins_at(const ArcEnd& a, const ArcEnd& b) {
  if (a.tile != b.tile) return a.tile < b.tile;
  if (std::abs(a.x - b.x) > tolerance::kDistinctFeet) return a.x < b.x;
  return a.y < b.y;
}

/// Takes what the search from one tile finds.
class Collector {
 public:
  Collector(const Steps& steps, const SpectrumOptions& options, Tile start, Stage& stage)
      : steps_(steps), options_(options), start_(start), stage_(stage) {}

  void operator()(const Find& find) {
    stage_.sums.add(find.length);
    if (!options_.keep_arcs) return;
    Arc arc;
    arc.length = find.length;
    arc.start = {start_, find.x, find.y};
    arc.end.tile = {find.tetrahedron, static_cast<std::uint32_t>(find.vertex)};
    const auto foot =
        foot_on(steps_.triangle(find.tetrahedron, find.vertex), find.vertex, find.products);
    arc.end.x = foot[0];
    arc.end.y = foot[1];
    const int crossed = settle(steps_, arc.end, find.products);
    if (!begins_at(arc.start, arc.end)) return;
    if (options_.keep_faces) {
      arc.first_face = stage_.faces.size();
      stage_.faces.insert(stage_.faces.end(), find.faces.begin(), find.faces.end());
      if (crossed >= 0) stage_.faces.push_back(static_cast<std::uint8_t>(crossed));
      arc.face_count = static_cast<std::uint32_t>(stage_.faces.size() - arc.first_face);
    }
    stage_.arcs.push_back(arc);
  }

 private:
  const Steps& steps_;
  const SpectrumOptions& options_;
  Tile start_;
  Stage& stage_;
};

void append_stage(Stage& all, Stage&& part) {
  all.sums.add(part.sums);
  const std::size_t shift = all.faces.size();
  for (Arc& arc : part.arcs) {
    arc.first_face += shift;
    all.arcs.push_back(arc);
  }
  all.faces.insert(all.faces.end(), part.faces.begin(), part.faces.end());
  part = Stage();
}

}  // namespace

std::string rounded(double value) { return fmt::format("{:.3g}", value); }

std::string stage_text(double length, std::uint64_t arcs) {
  return fmt::format("{} arcs up to length {:.4g}", arcs, length);
}

std::array<double, 4> carried(const Step& step, int face, const std::array<double, 4>& products) {
  std::array<double, 4> result{};
  double apex = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    result[step.labels[i]] = products[i];
    apex += step.combination[i] * products[i];
  }
  result[step.labels[static_cast<std::size_t>(face)]] = apex;
  return result;
}

std::array<double, 2> foot_on(const Triangle& triangle, int vertex,
                              const std::array<double, 4>& products) {
  const double own = products[static_cast<std::size_t>(vertex)];
  std::array<double, 3> foot{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double product = products[triangle.corners[k]] - triangle.gram[k] * own;
    for (std::size_t r = 0; r < 3; ++r) foot[r] += triangle.project[r][k] * product;
  }
  return {foot[0] / foot[2], foot[1] / foot[2]};
}

StageRunner::StageRunner(const topology::Triangulation& triangulation,
                         std::span<const double> edge_lengths, const SpectrumOptions& options,
                         unsigned threads, Halt& halt)
    : triangulation_(triangulation),
      edge_lengths_(edge_lengths),
      options_(options),
      halt_(halt),
      steps_(triangulation, edge_lengths),
      threads_(thread_count(threads)) {}

std::optional<Stage> StageRunner::run(double length) {
  const Reach reach(length, shortest_);
  const std::vector<Lid> lids = steps_.lids(shortest_);
  Stage all;
  const std::size_t tiles = 4 * triangulation_.tetrahedron_count();
  std::vector<Stage> results(std::min(tiles, kTilesAtATime));
  for (std::size_t first = 0; first < tiles; first += results.size()) {
    const std::size_t count = std::min(results.size(), tiles - first);
    run_tiles(reach, lids, first, std::span(results).first(count));
    if (halt_.reason() != Halt::kNone) return std::nullopt;
    for (std::size_t n = 0; n < count; ++n) append_stage(all, std::move(results[n]));
  }
  add_edges(length, all);
  if (shortest_ == 0) shortest_ = shortest_in(all, length);
  return all;
}

void StageRunner::run_tiles(const Reach& reach, std::span<const Lid> lids, std::size_t first,
                            std::span<Stage> results) {
  std::atomic<std::size_t> next{0};
  std::mutex guard;
  std::exception_ptr failure;
  const auto work = [&] {
    Unfolding unfolding(steps_, reach, lids);
    try {
      for (std::size_t n = next++; n < results.size() && !halt_.now(); n = next++) {
        const Tile tile{static_cast<std::uint32_t>((first + n) / 4),
                        static_cast<std::uint32_t>((first + n) % 4)};
        results[n] = Stage();
        if (steps_.is_ideal(tile.tetrahedron, static_cast<int>(tile.vertex))) continue;
        unfolding.search(tile.tetrahedron, static_cast<int>(tile.vertex),
                         Collector(steps_, options_, tile, results[n]), halt_);
      }
    } catch (...) {
      const std::scoped_lock lock(guard);
      if (!failure) failure = std::current_exception();
      halt_.stop();
    }
    const std::scoped_lock lock(guard);
    windows_ += unfolding.window_count();
  };
  run_on_threads(std::min<std::size_t>(threads_, results.size()), work);
  if (failure) std::rethrow_exception(failure);
}

/// Not if it runs into a cusp.
bool StageRunner::is_arc(std::size_t edge) const {
  const topology::EdgeCorner corner = triangulation_.corners(edge).front();
  const auto [i, j] = topology::kEdgeEnds[static_cast<std::size_t>(corner.edge())];
  return !steps_.is_ideal(corner.tetrahedron(), i) && !steps_.is_ideal(corner.tetrahedron(), j);
}

double StageRunner::first_length() const {
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t e = 0; e < edge_lengths_.size(); ++e)
    if (is_arc(e)) shortest = std::min(shortest, edge_lengths_[e]);
  return std::isinf(shortest) ? 1 : shortest;
}

void StageRunner::add_edges(double length, Stage& stage) const {
  for (std::size_t e = 0; e < edge_lengths_.size(); ++e) {
    if (!is_arc(e) || edge_lengths_[e] > length) continue;
    stage.sums.add(edge_lengths_[e]);
    stage.sums.add(edge_lengths_[e]);
    if (!options_.keep_arcs) continue;
    const topology::EdgeCorner corner = triangulation_.corners(e).front();
    const auto [i, j] = topology::kEdgeEnds[static_cast<std::size_t>(corner.edge())];
    const auto t = static_cast<std::uint32_t>(corner.tetrahedron());
    const auto end_at = [&](int at, int from) {
      const Triangle& triangle = steps_.triangle(t, at);
      const auto k = static_cast<std::size_t>(
          std::ranges::find(triangle.corners, static_cast<std::uint8_t>(from)) -
          triangle.corners.begin());
      const auto& foot = triangle.feet[k];
      return ArcEnd{{t, static_cast<std::uint32_t>(at)}, foot[0] / foot[2], foot[1] / foot[2]};
    };
    Arc arc;
    arc.length = edge_lengths_[e];
    arc.start = end_at(i, j);
    arc.end = end_at(j, i);
    arc.edge = static_cast<std::uint32_t>(e);
    arc.first_face = stage.faces.size();
    stage.arcs.push_back(arc);
  }
}

}  // namespace tripus::orthospectrum::detail
