#pragma once

/// The two expansions of Clausen's function whose logarithmic part is explicit, so that what
/// remains is an even entire-like function given by a short polynomial:
///   Cl2(x)      = x (1 - ln x) + x^3 A(x^2)         on [0, 2 pi/3],
///   Cl2(pi - y) = y (ln 2 - y^2 B(y^2))             on [0, pi/3].
/// A and B are the series with coefficients |B_2n| / (2n (2n+1)!) and (2^2n - 1) times that,
/// replaced by their Chebyshev interpolants of degree 9 (errors 3.4e-18 and 3.7e-18).
namespace tripus::geometry::clausen {

inline constexpr double kPi = 0x1.921fb54442d18p+1;
inline constexpr double kPiLow = 0x1.1a62633145c07p-53;
inline constexpr double kLn2 = 0x1.62e42fefa39efp-1;

/// Coefficients of A and of B.
inline constexpr double kNearZero[] = {
    0x1.c71c71c71c71cp-7,  0x1.23456789abe0bp-14, 0x1.a6b4d4f3a34dfp-21, 0x1.8a86a4d27a2f7p-27,
    0x1.a1597762ef30ep-33, 0x1.dcbc597f259eep-39, 0x1.1ebef3a598376p-44, 0x1.6c3d73fbe5342p-50,
    0x1.932d251dc8042p-56, 0x1.ee115622b1cb0p-61};
inline constexpr double kNearPi[] = {
    0x1.5555555555555p-5,  0x1.111111111123dp-10, 0x1.a01a019fd3a75p-15, 0x1.88fc1e2ddacc4p-19,
    0x1.a0f1210063ec2p-23, 0x1.dc9e8df8ce8d6p-27, 0x1.1eba77a854609p-30, 0x1.6c3c0cbb76b69p-34,
    0x1.932cb20a57c52p-38, 0x1.ee1140ac205afp-41};

}  // namespace tripus::geometry::clausen
