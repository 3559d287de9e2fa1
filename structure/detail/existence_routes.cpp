#include "structure/detail/existence_routes.hpp"

#include <algorithm>

namespace tripus::structure::detail {

using topology::Triangulation;

std::optional<Certificate> certificate_from(const Triangulation& triangulation,
                                            const AngleConstraints& constraints,
                                            std::vector<std::array<Integer, 4>> w) {
  Integer divisor = 0;
  for (const auto& four : w)
    for (const Integer& each : four) divisor = gcd(divisor, each);
  if (divisor == 0) return std::nullopt;
  Rational r = 0;
  for (auto& four : w) {
    for (Integer& each : four) {
      each /= divisor;
      r += each;
    }
  }
  Certificate certificate;
  certificate.edge.resize(triangulation.edge_count());
  for (std::size_t e = 0; e < certificate.edge.size(); ++e) {
    if (constraints.parabolic[e]) continue;
    bool first = true;
    for (const auto corner : triangulation.corners(e)) {
      const auto& four = w[corner.tetrahedron()];
      const auto& ends = topology::kEdgeEnds[static_cast<std::size_t>(corner.edge())];
      const Integer sum =
          four[static_cast<std::size_t>(ends[0])] + four[static_cast<std::size_t>(ends[1])];
      if (first || sum < certificate.edge[e]) certificate.edge[e] = sum;
      first = false;
    }
    r -= constraints.exact_sum[e] * certificate.edge[e];
  }
  if (r > 0) return std::nullopt;
  certificate.kind = r < 0 ? Certificate::Kind::kNone : Certificate::Kind::kSemi;
  certificate.vertex = std::move(w);
  return certificate;
}

bool is_angle_structure(const Triangulation& triangulation, const AngleConstraints& constraints,
                        const StrictAngles& angles) {
  for (std::size_t t = 0; t < triangulation.tetrahedron_count(); ++t) {
    const auto& x = angles.numerator[t];
    if (std::ranges::any_of(x, [](const Integer& each) { return each < 0; })) return false;
    const Integer sums[] = {x[0] + x[1] + x[2], x[0] + x[3] + x[4], x[1] + x[3] + x[5],
                            x[2] + x[4] + x[5]};
    for (std::size_t v = 0; v < 4; ++v)
      if (constraints.ideal[4 * t + v] ? sums[v] != angles.denominator
                                       : sums[v] > angles.denominator)
        return false;
  }
  for (std::size_t e = 0; e < triangulation.edge_count(); ++e) {
    Integer sum = 0;
    for (const auto corner : triangulation.corners(e))
      sum += angles.numerator[corner.tetrahedron()][static_cast<std::size_t>(corner.edge())];
    if (sum != constraints.exact_sum[e] * angles.denominator) return false;
  }
  return true;
}

}  // namespace tripus::structure::detail
