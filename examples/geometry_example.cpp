// The regular truncated tetrahedron with dihedral angles pi/6, of which the tripus is made.
#include <cmath>
#include <cstdio>
#include <numbers>

#include "geometry/truncated_tetrahedron.hpp"
#include "geometry/volume.hpp"

int main() {
  using namespace tripus::geometry;
  const double length = std::acosh((3 + std::sqrt(3.0)) / 4);
  const double l[6] = {length, length, length, length, length, length};
  double theta[6];
  const TetrahedronKind kind = dihedral_angles(l, theta);
  std::printf("angle %.15f, volume %.15f\n", theta[0], volume(theta));
  const bool right = kind == TetrahedronKind::kTruncated &&
                     std::fabs(theta[0] - std::numbers::pi / 6) < 1e-14 &&
                     std::fabs(2 * volume(theta) - 6.4519902708350328) < 1e-13;
  return right ? 0 : 1;
}
