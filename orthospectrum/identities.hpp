#pragma once

#include <array>
#include <optional>

#include "orthospectrum/sums.hpp"

/// What the arcs up to one length say about area, volume and limit set.
namespace tripus::orthospectrum {

/// An estimate with what it may be off.
struct Estimate {
  double value = 0, uncertainty = 0;
};

/// A sum over all arcs that is known otherwise: counted + tail should be exact, within the
/// uncertainty of the tail.
struct Identity {
  double counted = 0;            ///< the arcs that were found
  double exact = 0;              ///< what all of them give
  std::optional<Estimate> tail;  ///< the longer arcs, from N(l) ~ c e^(delta l) alone
};

/// Source: docs/orthospectrum.md section 4.
struct Identities {
  Identity area;    ///< Basmajian: the area of the boundary, known by its Euler characteristic
  Identity volume;  ///< Bridgeman and Kahn: the volume
  /// The volume by the arcs and the area of the boundary, without any volume formula: what is
  /// missing of the area says how many arcs are missing. Much better than counted + tail.
  std::optional<Estimate> volume_from_area;
  /// Hausdorff dimension of the limit set: what is missing of the area goes like e^((delta - 2) l).
  std::optional<Estimate> dimension;
  /// Mean over the boundary of the k-th power of the time that the normal flow takes to come back,
  /// k = 1, 2 (Vlamis), the longer arcs estimated as for volume_from_area.
  std::array<std::optional<Estimate>, 2> return_time;
};

/// Estimates are given from this many unoriented arcs on.
inline constexpr std::uint64_t kArcsForEstimates = 500;

///   sums    of all arcs up to `length`, both orientations of each
///   area    of the boundary, -2 pi chi
///   volume  of the manifold, as the metric gives it
Identities identities_of(const Sums& sums, double length, double area, double volume);

}  // namespace tripus::orthospectrum
