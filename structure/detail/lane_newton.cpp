#include "structure/detail/lane_newton.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/tolerances.hpp"
#include "structure/detail/small_decision.hpp"
#include "structure/starting_lengths.hpp"

namespace tripus::structure::detail {
namespace {

/// Rounds after which a lane gives up. Metrics of four tetrahedra take 3.8 on average.
constexpr int kMostRounds = 16;

/// Curvatures below this are rounding.
constexpr double kRounded = 4e-15;
/// With more corners around an edge class rounding may leave more. A step from below the second
/// bound, as Newton's method converges, leaves nothing else.
constexpr double kNearlyRounded = 1e-13, kLastStep = 1e-11;

/// A step has gone too far where the slope is upwards by more than this share of what it was
/// downwards. Then it is cut at the zero of the chord of the slope, within these shares.
constexpr double kOvershoot = 0.5, kLeastCut = 0.1, kMostCut = 0.6;

/// The length of regular tetrahedra whose angles have the mean that the edges ask for, to all its
/// digits: where there is one edge class it is the metric.
double polished(double length, const topology::Triangulation& of_shape,
                const geometry::BatchKernels& kernels) {
  constexpr std::size_t kLanes = geometry::kLanes;
  const double mean = 2 * std::numbers::pi * static_cast<double>(of_shape.edge_count()) /
                      static_cast<double>(6 * of_shape.tetrahedron_count());
  std::array<double, 6 * kLanes> lengths, theta;
  std::array<double, geometry::kPackedJacobian * kLanes> jacobian;
  lengths.fill(length);
  kernels.angles(1, lengths.data(), theta.data(), jacobian.data());
  double slope = 0;
  for (std::size_t e = 0; e < 6; ++e) slope += jacobian[kLanes * e];
  const double better = length + (mean - theta[0]) / slope;
  return std::fabs(better - length) < 1e-6 * length ? better : length;
}

}  // namespace

bool LaneNewton::takes(const topology::Triangulation& triangulation) {
  if (triangulation.tetrahedron_count() > kMostTetrahedra ||
      triangulation.edge_count() > kMostEdges || !triangulation.is_connected() ||
      has_low_valence(triangulation))
    return false;
  for (std::size_t v = 0; v < triangulation.vertex_count(); ++v)
    if (triangulation.link(v).euler_characteristic >= 0) return false;
  return true;
}

LaneNewton::LaneNewton(const topology::Triangulation& of_shape,
                       std::function<void(const LaneResult&)> deliver,
                       const geometry::BatchKernels& kernels)
    : tetrahedra_(of_shape.tetrahedron_count()),
      edges_(of_shape.edge_count()),
      tetrahedra_kernels_(kernels),
      kernels_(lane_kernels(kernels)),
      deliver_(std::move(deliver)),
      start_(polished(starting_lengths(of_shape, {}).front(), of_shape, kernels)),
      class_(tetrahedra_ * 6 * kLanes),
      found_lengths_(tetrahedra_ * 6 * kLanes, start_),
      found_theta_(tetrahedra_ * 6 * kLanes),
      found_x_(edges_ * kLanes) {
  for (std::size_t q = 0; q < class_.size(); ++q)  // empty lanes hold something harmless
    class_[q] = static_cast<std::uint32_t>(q % kLanes);
  const std::size_t square = edges_ * edges_;
  const std::pair<double * LaneNumbers::*, std::size_t> parts[] = {
      {&LaneNumbers::x, edges_},
      {&LaneNumbers::lengths, 6 * tetrahedra_},
      {&LaneNumbers::theta, 6 * tetrahedra_},
      {&LaneNumbers::jacobian, geometry::kPackedJacobian * tetrahedra_},
      {&LaneNumbers::curvature, edges_},
      {&LaneNumbers::max_curvature, 1},
      {&LaneNumbers::hessian, square},
      {&LaneNumbers::diagonal, edges_},
      {&LaneNumbers::factor, square},
      {&LaneNumbers::convexity, 1},
      {&LaneNumbers::delta, edges_},
      {&LaneNumbers::next, edges_},
      {&LaneNumbers::slope, 1},
      {&LaneNumbers::next_slope, 1},
      {&LaneNumbers::next_share, 1},
      {&LaneNumbers::move, 1},
      {&LaneNumbers::forward, 1}};
  std::size_t total = 0;
  for (const auto& [part, count] : parts) total += count;
  storage_.assign(total * kLanes, 0);
  numbers_.tetrahedra = tetrahedra_;
  numbers_.edges = edges_;
  numbers_.edge_class = class_.data();
  double* at = storage_.data();
  for (const auto& [part, count] : parts) {
    numbers_.*part = at;
    at += count * kLanes;
  }
  std::fill_n(numbers_.x, edges_ * kLanes, start_);
}

void LaneNewton::add(const topology::Triangulation& triangulation, std::size_t number) {
  while (occupied_ == kLanes) round();
  std::size_t lane = 0;
  while (lanes_[lane].state != State::kEmpty) ++lane;
  lanes_[lane] = {.state = State::kFresh, .number = number};
  ++occupied_;
  const auto classes = triangulation.edge_classes();
  for (std::size_t q = 0; q < classes.size(); ++q)
    class_[kLanes * q + lane] = static_cast<std::uint32_t>(kLanes * classes[q] + lane);
  for (std::size_t e = 0; e < edges_; ++e) numbers_.x[kLanes * e + lane] = start_;
}

void LaneNewton::finish() {
  while (occupied_ > 0) round();
  deliver_found();
}

void LaneNewton::round() {
  kernels_.gather(numbers_);
  tetrahedra_kernels_.angles(tetrahedra_, numbers_.lengths, numbers_.theta, numbers_.jacobian);
  kernels_.weigh(numbers_);
  judge();
  step();
}

/// Which lanes are at their metric, and which will not get there.
void LaneNewton::judge() {
  for (std::size_t k = 0; k < kLanes; ++k) {
    Lane& lane = lanes_[k];
    if (lane.state == State::kEmpty) continue;
    const double curvature = numbers_.max_curvature[k];
    const bool at_rest =
        curvature <= kRounded || (curvature <= kNearlyRounded && lane.last_curvature <= kLastStep &&
                                  lane.state == State::kRunning);
    const bool lost = !std::isfinite(curvature) || ++lane.rounds > kMostRounds ||
                      (lane.state == State::kFresh && !(numbers_.convexity[k] > 0));
    lane.last_curvature = curvature;
    if (!at_rest && !lost) continue;
    if (at_rest && is_metric(k))
      put_away(k);
    else
      deliver_({.number = lane.number});
    lane.state = State::kEmpty;
    for (std::size_t e = 0; e < edges_; ++e) numbers_.x[kLanes * e + k] = start_;
    --occupied_;
  }
}

/// Whether a critical point is close, as `assess` asks, and no tetrahedron flat within rounding.
bool LaneNewton::is_metric(std::size_t lane) const {
  double squares = 0, shortest = 1, largest_angle = 0;
  for (std::size_t e = 0; e < edges_; ++e) {
    const double k = numbers_.curvature[kLanes * e + lane];
    squares += k * k;
    shortest = std::min(shortest, numbers_.x[kLanes * e + lane]);
  }
  for (std::size_t q = lane; q < 6 * kLanes * tetrahedra_; q += kLanes)
    largest_angle = std::max(largest_angle, numbers_.theta[q]);
  const double curvature = std::max(std::sqrt(squares), tolerance::kCurvatureRounding);
  return shortest > 0 &&
         numbers_.convexity[lane] * tolerance::kMaxDistanceToMetric * shortest >= curvature &&
         largest_angle < std::numbers::pi - tolerance::kFlatAngleMargin;
}

/// A metric waits until its volume is found together with those of others.
void LaneNewton::put_away(std::size_t lane) {
  const std::size_t to = found_count_++;
  found_[to] = {.number = lanes_[lane].number,
                .found = true,
                .iterations = lanes_[lane].iterations,
                .max_curvature = numbers_.max_curvature[lane]};
  for (std::size_t q = 0; q < 6 * kLanes * tetrahedra_; q += kLanes) {
    found_lengths_[q + to] = numbers_.lengths[q + lane];
    found_theta_[q + to] = numbers_.theta[q + lane];
  }
  for (std::size_t e = 0; e < edges_; ++e)
    found_x_[kLanes * e + to] = numbers_.x[kLanes * e + lane];
  if (found_count_ == kLanes) deliver_found();
}

void LaneNewton::deliver_found() {
  if (found_count_ == 0) return;
  std::array<double, kMostTetrahedra * kLanes> volumes;
  tetrahedra_kernels_.volumes(tetrahedra_, found_lengths_.data(), found_theta_.data(),
                              volumes.data());
  for (std::size_t k = 0; k < found_count_; ++k) {
    LaneResult& result = found_[k];
    for (std::size_t t = 0; t < tetrahedra_; ++t) result.volume += volumes[kLanes * t + k];
    result.length = &found_x_[k];
    result.angle = &found_theta_[k];
    deliver_(result);
  }
  found_count_ = 0;
}

/// Where the latest step has not gone too far, the next one. Elsewhere back along the latest one;
/// the energy is convex, so that its least value on that line lies between.
void LaneNewton::step() {
  kernels_.aim(numbers_);
  for (std::size_t k = 0; k < kLanes; ++k) {
    Lane& lane = lanes_[k];
    const double slope = numbers_.slope[k];
    numbers_.forward[k] = 0;
    if (lane.state == State::kEmpty) {
      numbers_.move[k] = 0;
    } else if (lane.state == State::kRunning &&
               (!(numbers_.convexity[k] > 0) || slope > kOvershoot * start_slope_[k])) {
      const double cut =
          std::clamp(start_slope_[k] / (start_slope_[k] + slope), kLeastCut, kMostCut);
      numbers_.move[k] = (cut - 1) * share_[k];
      share_[k] *= cut;
    } else {
      lane.state = State::kRunning;
      ++lane.iterations;
      numbers_.forward[k] = 1;
      numbers_.move[k] = share_[k] = numbers_.next_share[k];
      start_slope_[k] = -numbers_.next_slope[k];
    }
  }
  kernels_.go(numbers_);
}

}  // namespace tripus::structure::detail
