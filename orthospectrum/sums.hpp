#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace tripus::orthospectrum {

/// What one arc of length l > 0 contributes to the identities. Unoriented arcs: both ends.
/// Source: docs/orthospectrum.md section 4.
double boundary_area_of(double length);  ///< of its two discs, 8 pi / (e^{2l} - 1) (Basmajian)
double volume_of(double length);         ///< 2 pi (l + 1) / (e^{2l} - 1) (Bridgeman and Kahn)
/// The integral over its two discs of the k-th power of the time in which the normal flow comes
/// back, k = 1, 2 (Vlamis). By the series of the polylogarithm.
double return_time_of(double length, int k);

/// Radius of the disc of normals around the foot of an arc that run into the same plane as the arc:
/// log coth(l/2). Discs of all arcs fill the boundary but for measure 0.
double disc_radius(double length);

/// Counts and sums over arcs, in memory that does not depend on their number.
class Sums {
 public:
  static constexpr double kBin = 1.0 / 64;

  void add(double length);
  void add(const Sums& other);

  /// Twice the number of arcs: what was added, as oriented arcs are.
  std::uint64_t oriented_count() const { return count_; }
  /// The shortest length; nothing if there is none.
  std::optional<double> shortest() const {
    return count_ == 0 ? std::nullopt : std::optional(shortest_);
  }
  double area() const { return area_; }
  double volume() const { return volume_; }
  double return_time(int k) const { return return_time_[static_cast<std::size_t>(k - 1)]; }
  /// Arcs with lengths in [n kBin, (n + 1) kBin): how many, oriented, and the area of their discs.
  const std::vector<std::uint64_t>& histogram() const { return histogram_; }
  const std::vector<double>& area_histogram() const { return area_histogram_; }

 private:
  std::uint64_t count_ = 0;
  double shortest_ = std::numeric_limits<double>::infinity();
  double area_ = 0, volume_ = 0;
  std::array<double, 2> return_time_{};
  std::vector<std::uint64_t> histogram_;
  std::vector<double> area_histogram_;
};

}  // namespace tripus::orthospectrum
