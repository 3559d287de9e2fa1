#pragma once

#include <cstddef>
#include <cstdint>

#include "geometry/batch.hpp"

namespace tripus::structure::detail {

/// The numbers of eight triangulations of one shape, lane by lane: quantity q of lane i at
/// [8 q + i]. T tetrahedra, E edge classes.
struct LaneNumbers {
  std::size_t tetrahedra, edges;
  std::uint32_t* edge_class;   ///< [T][6][8], times 8, plus the lane
  double* x;                   ///< [E][8] lengths
  double* lengths;             ///< [T][6][8] the same, of each tetrahedron
  double* theta;               ///< [T][6][8]
  double* jacobian;            ///< [T][21][8]
  double* curvature;           ///< [E][8] 2 pi less the angles around each edge class
  double* max_curvature;       ///< [8]
  double* hessian;             ///< [E][E][8], the lower triangle
  double* diagonal;            ///< [E][8] scratch
  double* factor;              ///< [E][E][8] H = L D L^T: unit lower triangle, D on the diagonal
  double* convexity;           ///< [8] at most the least eigenvalue of H; 0: not definite
  double *delta, *next;        ///< [E][8] the latest step, before its share was taken; the next one
  double *slope, *next_slope;  ///< [8] at x along delta; along next, < 0
  double* next_share;          ///< [8] of `next` that leaves all lengths positive
  double* move;                ///< [8] what x moves by, in units of delta; 0 changes nothing
  double* forward;             ///< [8] > 0 where `next` takes the place of delta first
};

/// A step leaves each length at least this share of itself, and changes none by more than this.
inline constexpr double kLeastShare = 0.3, kLongestStep = 2;

/// The arithmetic of LaneNewton for one instruction set. All give the same bits.
struct LaneKernels {
  void (*gather)(LaneNumbers&);  ///< lengths from x
  /// From theta and jacobian: curvature, hessian, factor, convexity.
  void (*weigh)(LaneNumbers&);
  /// slope; and the next step H d = K with its slope and share.
  void (*aim)(LaneNumbers&);
  /// x += move delta.
  void (*go)(LaneNumbers&);
};

/// Those for the instruction set of these kernels.
const LaneKernels& lane_kernels(const geometry::BatchKernels& for_tetrahedra);

}  // namespace tripus::structure::detail
