#pragma once

#include "meshing/surface_mesh.hpp"

namespace tripus::meshing {

// Exact signs. A floating-point value with a bound on its rounding decides nearly always; where it
// cannot, the determinant is summed without rounding. Exact for coordinates that in_exact_range
// accepts; validation refuses others.

/// Whether no product of three differences of such numbers over- or underflows, down to its last
/// bit: 0, or between 1e-70 and 1e70 in size.
bool in_exact_range(double coordinate);

/// Sign (-1, 0, 1) of the determinant of (b-a, c-a, d-a): 1 if a, b, c run counterclockwise as seen
/// from d.
int orientation(const Point& a, const Point& b, const Point& c, const Point& d);

/// Sign of the area of a, b, c after projection along `axis` (0, 1, 2): 1 if they run
/// counterclockwise as seen from the positive end of the axis.
int projected_orientation(const Point& a, const Point& b, const Point& c, int axis);

/// An axis along which a, b, c project to a triangle of positive area; -1 if they are collinear.
int projection_axis(const Point& a, const Point& b, const Point& c);

/// Whether the closed segment p q meets the closed triangle a b c, which is not collinear.
bool segment_meets_triangle(const Point& p, const Point& q, const Point& a, const Point& b,
                            const Point& c);

}  // namespace tripus::meshing
