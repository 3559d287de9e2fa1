// The arithmetic of LaneNewton. CMake compiles this file once for each instruction set, with
// TRIPUS_LANE_KERNELS naming the table to define; everything else in here is internal to the
// translation unit, and calls nothing that another one could share.
#include <cstring>

#include "structure/detail/lane_kernels.hpp"

// Packs of doubles are passed between functions of this file only.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace tripus::structure::detail {
namespace {

constexpr std::size_t kLanes = geometry::kLanes;

/// One number for each lane; the compiler makes of it what the instruction set has.
typedef double Eight __attribute__((vector_size(kLanes * sizeof(double))));

inline Eight load(const double* from) {
  Eight x;
  std::memcpy(&x, from, sizeof x);
  return x;
}
inline void store(double* to, const Eight& x) { std::memcpy(to, &x, sizeof x); }

constexpr double kTwoPi = 0x1.921fb54442d18p+2;

void gather(LaneNumbers& n) {
  const std::size_t count = 6 * kLanes * n.tetrahedra;
  for (std::size_t q = 0; q < count; ++q) n.lengths[q] = n.x[n.edge_class[q]];
}

void add_up_curvature(LaneNumbers& n) {
  for (std::size_t e = 0; e < n.edges; ++e) store(n.curvature + kLanes * e, Eight{} + kTwoPi);
  const std::size_t count = 6 * kLanes * n.tetrahedra;
  for (std::size_t q = 0; q < count; ++q) n.curvature[n.edge_class[q]] -= n.theta[q];
  Eight largest = {};
  for (std::size_t e = 0; e < n.edges; ++e) {
    const Eight k = load(n.curvature + kLanes * e);
    const Eight size = k < 0.0 ? -k : k;
    largest = size > largest ? size : largest;
  }
  store(n.max_curvature, largest);
}

/// The entries above the diagonals of the Jacobians count for both triangles: they are added up
/// once, in one of the two places, and the triangles are then added to each other.
void add_up_hessian(LaneNumbers& n) {
  const std::size_t row = n.edges * kLanes;
  for (std::size_t q = 0; q < n.edges; ++q) store(n.diagonal + kLanes * q, Eight{});
  for (std::size_t q = 0; q < n.edges * n.edges; ++q) store(n.hessian + kLanes * q, Eight{});
  const double* entry = n.jacobian;
  for (std::size_t t = 0; t < n.tetrahedra; ++t) {
    const std::uint32_t* edge = n.edge_class + 6 * kLanes * t;
    for (std::size_t a = 0; a < 6; ++a) {
      for (std::size_t lane = 0; lane < kLanes; ++lane)
        n.diagonal[edge[kLanes * a + lane]] += entry[lane];
      entry += kLanes;
      double* line[kLanes];
      for (std::size_t lane = 0; lane < kLanes; ++lane)
        line[lane] = n.hessian + (edge[kLanes * a + lane] / kLanes) * row;
      for (std::size_t b = a + 1; b < 6; ++b, entry += kLanes)
        for (std::size_t lane = 0; lane < kLanes; ++lane)
          line[lane][edge[kLanes * b + lane]] += entry[lane];
    }
  }
  for (std::size_t i = 0; i < n.edges; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      double* lower = n.hessian + i * row + j * kLanes;
      const Eight sum = load(lower) + load(n.hessian + j * row + i * kLanes);
      store(lower, i == j ? sum + load(n.diagonal + i * kLanes) : sum);
    }
}

/// H = L D L^T, and the reciprocal of the trace of its inverse, a lower bound of its least
/// eigenvalue.
void factorise(LaneNumbers& n) {
  const std::size_t row = n.edges * kLanes;
  Eight trace = {}, least_pivot = Eight{} + 1.0;
  for (std::size_t j = 0; j < n.edges; ++j) {
    const double* above = n.factor + j * row;
    Eight pivot = load(n.hessian + j * row + j * kLanes);
    for (std::size_t k = 0; k < j; ++k) {
      const Eight l = load(above + k * kLanes);
      pivot -= l * l * load(n.factor + k * row + k * kLanes);
    }
    least_pivot = least_pivot < pivot ? least_pivot : pivot;  // a pivot that is no number stays
    pivot = pivot > 0.0 ? pivot : Eight{} + 1.0;
    store(n.factor + j * row + j * kLanes, pivot);
    const Eight reciprocal = 1.0 / pivot;
    for (std::size_t i = j + 1; i < n.edges; ++i) {
      Eight sum = load(n.hessian + i * row + j * kLanes);
      for (std::size_t k = 0; k < j; ++k)
        sum -= load(n.factor + i * row + k * kLanes) * load(above + k * kLanes) *
               load(n.factor + k * row + k * kLanes);
      store(n.factor + i * row + j * kLanes, sum * reciprocal);
    }
  }
  // Column j of the inverse of L, squared, over D. `next` is free here.
  for (std::size_t j = 0; j < n.edges; ++j) {
    store(n.next + j * kLanes, Eight{} + 1.0);
    trace += 1.0 / load(n.factor + j * row + j * kLanes);
    for (std::size_t i = j + 1; i < n.edges; ++i) {
      Eight sum = {};
      for (std::size_t k = j; k < i; ++k)
        sum -= load(n.factor + i * row + k * kLanes) * load(n.next + k * kLanes);
      store(n.next + i * kLanes, sum);
      trace += sum * sum / load(n.factor + i * row + i * kLanes);
    }
  }
  store(n.convexity, least_pivot > 0.0 ? 1.0 / trace : Eight{});
}

void weigh(LaneNumbers& n) {
  add_up_curvature(n);
  add_up_hessian(n);
  factorise(n);
}

void aim(LaneNumbers& n) {
  const std::size_t row = n.edges * kLanes;
  Eight slope = {};
  for (std::size_t e = 0; e < n.edges; ++e)
    slope -= load(n.curvature + kLanes * e) * load(n.delta + kLanes * e);
  store(n.slope, slope);
  for (std::size_t i = 0; i < n.edges; ++i) {
    Eight sum = load(n.curvature + i * kLanes);
    for (std::size_t k = 0; k < i; ++k)
      sum -= load(n.factor + i * row + k * kLanes) * load(n.next + k * kLanes);
    store(n.next + i * kLanes, sum);
  }
  Eight share = Eight{} + 1.0, next_slope = {};
  for (std::size_t i = n.edges; i-- > 0;) {
    Eight d = load(n.next + i * kLanes) / load(n.factor + i * row + i * kLanes);
    for (std::size_t k = i + 1; k < n.edges; ++k)
      d -= load(n.factor + k * row + i * kLanes) * load(n.next + k * kLanes);
    store(n.next + i * kLanes, d);
    const Eight size = d < 0.0 ? -d : d;
    const Eight shrink = (1 - kLeastShare) * load(n.x + i * kLanes);
    const Eight longest = Eight{} + kLongestStep;
    const Eight lower = shrink < longest ? shrink : longest;
    const Eight room = d < 0.0 ? lower : longest;
    share = size * share > room ? room / size : share;
    next_slope -= load(n.curvature + i * kLanes) * d;
  }
  store(n.next_share, share);
  store(n.next_slope, next_slope);
}

void go(LaneNumbers& n) {
  const Eight forward = load(n.forward), move = load(n.move);
  for (std::size_t i = 0; i < n.edges; ++i) {
    const Eight delta = forward > 0.0 ? load(n.next + i * kLanes) : load(n.delta + i * kLanes);
    store(n.delta + i * kLanes, delta);
    const Eight x = load(n.x + i * kLanes);
    store(n.x + i * kLanes, move != 0.0 ? x + move * delta : x);
  }
}

}  // namespace

extern const LaneKernels TRIPUS_LANE_KERNELS;
const LaneKernels TRIPUS_LANE_KERNELS{gather, weigh, aim, go};

}  // namespace tripus::structure::detail
