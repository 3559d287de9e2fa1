#pragma once

namespace tripus::geometry {

/// Clausen's function Cl2(x) = -int_0^x ln|2 sin(t/2)| dt = sum sin(n x) / n^2, for any finite x.
/// Absolute error below 5e-16 for |x| <= 100; odd and 2 pi-periodic.
/// Source: docs/theory.md section 3.
double clausen2(double x);

}  // namespace tripus::geometry
