#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "structure/detail/lane_kernels.hpp"
#include "topology/triangulation.hpp"

namespace tripus::structure::detail {

/// What one lane ended with. Entry e of a lane's lengths lies at length[kLanes * e], edge e of
/// tetrahedron t at angle[kLanes * (6 * t + e)].
struct LaneResult {
  std::size_t number = 0;  ///< as it was added
  bool found = false;      ///< a metric, by the rules of `assess`; if not, nothing else is set
  int iterations = 0;
  double max_curvature = 0, volume = 0;
  const double* length = nullptr;
  const double* angle = nullptr;
};

/// Newton's method on small triangulations of one shape (the same numbers of tetrahedra and of edge
/// classes), eight at a time, one to a lane; a lane that is done takes the next one. What is found
/// depends neither on the other lanes nor on the instruction set.
///
/// It gives up early: that a lane has not found a metric says nothing.
class LaneNewton {
 public:
  static constexpr std::size_t kLanes = geometry::kLanes;
  static constexpr std::size_t kMostTetrahedra = 8;
  static constexpr std::size_t kMostEdges = 8;

  /// Whether a triangulation may be put into a lane: small, connected, all vertices hyperideal, no
  /// edge of valence 1 or 2, which no metric has.
  static bool takes(const topology::Triangulation& triangulation);

  /// For the shape of this triangulation, which `takes` takes. Results are delivered in any order;
  /// what they point to is valid during the call.
  LaneNewton(const topology::Triangulation& of_shape,
             std::function<void(const LaneResult&)> deliver,
             const geometry::BatchKernels& kernels = geometry::batch_kernels());
  LaneNewton(const LaneNewton&) = delete;
  LaneNewton& operator=(const LaneNewton&) = delete;

  /// Puts a triangulation of this shape into a lane; steps until one is free.
  void add(const topology::Triangulation& triangulation, std::size_t number);

  /// Steps until all lanes are done, and delivers what is left.
  void finish();

 private:
  enum class State : std::uint8_t { kEmpty, kFresh, kRunning };

  struct Lane {
    State state = State::kEmpty;
    std::size_t number = 0;
    int rounds = 0, iterations = 0;
    double last_curvature = 0;  // max|K| of the round before
  };

  void round();
  void judge();
  bool is_metric(std::size_t lane) const;
  void step();
  void put_away(std::size_t lane);
  void deliver_found();

  const std::size_t tetrahedra_, edges_;
  const geometry::BatchKernels& tetrahedra_kernels_;
  const LaneKernels& kernels_;
  const std::function<void(const LaneResult&)> deliver_;
  double start_ = 1;  // length of all edges to begin with
  std::array<Lane, kLanes> lanes_{};
  std::size_t occupied_ = 0;

  std::vector<std::uint32_t> class_;
  std::vector<double> storage_;
  LaneNumbers numbers_{};  // in class_ and storage_
  std::array<double, kLanes> start_slope_{},
      share_{};  // of the latest step: where it began, its size

  // Metrics that wait for their volumes, laid out as the lanes are.
  std::vector<double> found_lengths_, found_theta_, found_x_;
  std::array<LaneResult, kLanes> found_{};
  std::size_t found_count_ = 0;
};

}  // namespace tripus::structure::detail
