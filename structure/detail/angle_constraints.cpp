#include "structure/detail/angle_constraints.hpp"

#include <algorithm>
#include <numbers>

#include "topology/vertex_kinds.hpp"

namespace tripus::structure::detail {

AngleConstraints::AngleConstraints(const topology::Triangulation& triangulation,
                                   std::span<const topology::ConeAngle> cone_angles) {
  const auto angles = topology::completed(cone_angles, triangulation.edge_count());
  const bool rational = std::ranges::all_of(angles, &topology::ConeAngle::is_rational);
  for (const topology::ConeAngle& k : angles) {
    plain = plain && k.is_full();
    parabolic.push_back(k.is_parabolic());
    edge_sum.push_back(rational ? static_cast<double>(k.numerator()) /
                                      static_cast<double>(k.denominator())
                                : k.radians() / std::numbers::pi);
    if (rational) exact_sum.emplace_back(k.numerator(), k.denominator());
  }
  const auto links = topology::orbifold_links(triangulation, cone_angles);
  for (std::size_t t = 0; t < triangulation.tetrahedron_count(); ++t) {
    for (int v = 0; v < 4; ++v) {
      ideal.push_back(links[triangulation.vertex_class(t, v)].kind == topology::VertexKind::kIdeal);
      plain = plain && !ideal.back();
      int live = 0;
      for (int other = 0; other < 4; ++other) {
        const int edge =
            topology::kEdgeNumber[static_cast<std::size_t>(v)][static_cast<std::size_t>(other)];
        if (edge >= 0 && !parabolic[triangulation.edge_class(t, edge)]) ++live;
      }
      corners.push_back(live);
    }
  }
}

}  // namespace tripus::structure::detail
