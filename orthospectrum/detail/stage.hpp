#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "orthospectrum/detail/halt.hpp"
#include "orthospectrum/detail/unfold.hpp"
#include "orthospectrum/spectrum.hpp"

namespace tripus::orthospectrum::detail {

/// All arcs up to one length.
struct Stage {
  Sums sums;
  std::vector<Arc> arcs;  // in the order of tiles, then as found
  std::vector<std::uint8_t> faces;
};

/// Runs stages, tile by tile on several threads.
class StageRunner {
 public:
  StageRunner(const topology::Triangulation& triangulation, std::span<const double> edge_lengths,
              const SpectrumOptions& options, unsigned threads, Halt& halt);

  /// Nothing if it was halted. The first run finds the shortest arc, which makes the next ones
  /// faster.
  std::optional<Stage> run(double length);
  std::uint64_t window_count() const { return windows_; }
  /// The length of the shortest edge that is an arc; 1 if all edges run into cusps.
  double first_length() const;

 private:
  void run_tiles(const Reach& reach, std::span<const Lid> lids, std::size_t first,
                 std::span<Stage> results);
  void add_edges(double length, Stage& stage) const;
  bool is_arc(std::size_t edge) const;

  const topology::Triangulation& triangulation_;
  std::span<const double> edge_lengths_;
  const SpectrumOptions& options_;
  Halt& halt_;
  Steps steps_;
  unsigned threads_;
  double shortest_ = 0;
  std::uint64_t windows_ = 0;
};

/// Products with the four vertices of the tetrahedron beyond a face.
std::array<double, 4> carried(const Step& step, int face, const std::array<double, 4>& products);

/// The foot of the common perpendicular with the plane of a tile.
std::array<double, 2> foot_on(const Triangle& triangle, int vertex,
                              const std::array<double, 4>& products);

/// For the progress: "527 arcs up to length 6".
std::string stage_text(double length, std::uint64_t arcs);

/// A number with three digits for a message.
std::string rounded(double value);

}  // namespace tripus::orthospectrum::detail
