#include "topology/subdivide.hpp"

#include <string>

#include "base/error.hpp"

namespace tripus::topology {

Gluings barycentric_subdivision(const Gluings& gluings) {
  require_consistent(gluings, OpenFaces::kAllowed);
  const std::size_t count = gluings.tetrahedron_count();
  if (count > kMaxTetrahedra / 24)
    throw InvalidInput("the barycentric subdivision of " + std::to_string(count) +
                       " tetrahedra has more than the " + std::to_string(kMaxTetrahedra) +
                       " tetrahedra that a triangulation can have");
  const Perm4 swap = Perm4::from_images(0, 1, 3, 2);
  // Corner i of the flag p has the label place(p)(i).
  const auto place = [&](Perm4 p) { return p.is_odd() ? swap : Perm4(); };
  Gluings fine(24 * count);
  for (std::size_t t = 0; t < count; ++t)
    for (int rank = 0; rank < 24; ++rank) {
      const Perm4 p = Perm4::from_rank(rank);
      for (int corner = 0; corner < 4; ++corner) {
        // The flag on the other side differs in what the corner stands for, and in that alone.
        std::size_t other = t;
        Perm4 q;
        if (corner < 3) {
          std::array<int, 4> images{p(0), p(1), p(2), p(3)};
          const auto i = static_cast<std::size_t>(corner);
          std::swap(images[i], images[i + 1]);
          q = Perm4::from_images(images[0], images[1], images[2], images[3]);
        } else {
          if (gluings.is_open(t, p(3))) continue;
          other = gluings.neighbour(t, p(3));
          q = gluings.gluing(t, p(3)) * p;
        }
        fine.set_one_side(
            24 * t + static_cast<std::size_t>(rank), place(p)(corner),
            static_cast<TetrahedronIndex>(24 * other) + static_cast<TetrahedronIndex>(q.rank()),
            place(q) * place(p).inverse());
      }
    }
  return fine;
}

}  // namespace tripus::topology
