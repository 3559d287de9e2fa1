#pragma once

#include <cstddef>

namespace tripus::geometry {

/// Lengths up to here go through the unscaled Gram matrix: the largest product that the kernel
/// forms has six of its entries, and (e^64 / 2)^6 is far from overflow.
inline constexpr double kUnscaledLimit = 64.0;

/// One lane of a block by the scaled Gram matrix, for lengths that the unscaled one cannot hold.
/// lengths, theta and jacobian (or null) point to the lane's entry of the first row of the block;
/// rows are kLanes apart. Returns 1 if the lane is flat, else 0.
std::size_t scaled_angles_of_lane(const double* lengths, double* theta, double* jacobian);

/// The same with ideal vertices: diagonal points to the lane's entry of G_00, rows kLanes apart.
std::size_t mixed_scaled_angles_of_lane(const double* lengths, const double* diagonal,
                                        double* theta, double* jacobian);

}  // namespace tripus::geometry
