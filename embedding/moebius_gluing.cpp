#include "embedding/moebius_gluing.hpp"

#include <cmath>

#include <fmt/format.h>

#include "base/error.hpp"
#include "embedding/detail/orientations.hpp"

namespace tripus::embedding {
namespace {

using geometry::BoundaryPoint;
using geometry::Circle;
using geometry::CirclePacking;
using geometry::Complex;
using geometry::MoebiusMap;
using topology::Gluings;
using topology::Perm4;

/// How far the point lies on the outer side of the circle; only the sign has a meaning.
double outward(const Circle& circle, const BoundaryPoint& point) {
  return 2 * (std::conj(point.x) * point.y * circle.weighted_centre).real() -
         circle.curvature * std::norm(point.x) - circle.co_curvature * std::norm(point.y);
}

/// The point where two orthogonal circles meet that lies on the outer side of a third. The product
/// of the reflections in the two is the half-turn (a w + b) / (c w - a) about their common points,
/// with a^2 + b c = -1: they are (a +- i) : c = -b : (a -+ i).
BoundaryPoint common_point(const Circle& first, const Circle& second, const Circle& side) {
  const Complex &u = first.weighted_centre, &v = second.weighted_centre;
  const Complex a = (u * std::conj(v) - first.co_curvature * second.curvature +
                     first.curvature * second.co_curvature - std::conj(u) * v) /
                    2.0;
  const Complex b = first.co_curvature * v - u * second.co_curvature;
  const Complex c = first.curvature * std::conj(v) - std::conj(u) * second.curvature;
  const auto root = [&](const Complex& i) -> BoundaryPoint {
    if (std::norm(a + i) >= std::norm(a - i)) return {a + i, c};
    return {-b, a - i};
  };
  const BoundaryPoint plus = root({0, 1}), minus = root({0, -1});
  return outward(side, plus) > outward(side, minus) ? plus : minus;
}

}  // namespace

std::array<BoundaryPoint, 3> face_circle_points(const CirclePacking& packing,
                                                const std::array<int, 3>& vertices) {
  const auto at = [](const std::array<Circle, 4>& circles, int i) -> const Circle& {
    return circles[static_cast<std::size_t>(i)];
  };
  const int face = 6 - vertices[0] - vertices[1] - vertices[2];
  std::array<BoundaryPoint, 3> points;
  for (std::size_t n = 0; n < 3; ++n) {
    // Beyond the edge ab is the outer side of the other face at that edge, the one opposite c.
    points[n] = common_point(at(packing.faces, face), at(packing.vertices, vertices[n]),
                             at(packing.faces, vertices[(n + 2) % 3]));
  }
  return points;
}

MoebiusMap moebius_face_pairing(const CirclePacking& here, const CirclePacking& there, Perm4 p,
                                int f, bool reverses) {
  std::array<int, 3> vertices{}, images{};
  std::size_t n = 0;
  for (int v = 0; v < 4; ++v) {
    if (v == f) continue;
    vertices[n] = v;
    images[n++] = p(v);
  }
  return geometry::map_of_triples(face_circle_points(there, images),
                                  face_circle_points(here, vertices), reverses);
}

CircleEmbedding embed_by_circles(const topology::Triangulation& triangulation,
                                 std::span<const std::array<double, 6>> dihedral_angles) {
  const std::size_t count = triangulation.tetrahedron_count();
  if (dihedral_angles.size() != count) {
    throw InvalidInput(fmt::format("dihedral angles of {} tetrahedra were given for {}",
                                   dihedral_angles.size(), count));
  }
  const Gluings& gluings = triangulation.gluings();
  const std::vector<int> orientation = detail::orientations(gluings);
  CircleEmbedding embedding;
  for (std::size_t t = 0; t < count; ++t) {
    try {
      const CirclePacking packing = geometry::circle_packing(dihedral_angles[t]);
      embedding.tetrahedra.push_back(orientation[t] > 0 ? packing : geometry::mirrored(packing));
    } catch (const InvalidInput& error) {
      throw InvalidInput(fmt::format("tetrahedron {}: {}", t, error.what()));
    }
  }
  embedding.face_pairings.resize(count);
  for (std::size_t t = 0; t < count; ++t) {
    for (int f = 0; f < 4; ++f) {
      const std::size_t other = gluings.neighbour(t, f);
      const Perm4 p = gluings.gluing(t, f);
      embedding.face_pairings[t][static_cast<std::size_t>(f)] =
          moebius_face_pairing(embedding.tetrahedra[t], embedding.tetrahedra[other], p, f,
                               detail::pairing_reverses(orientation, gluings, t, f));
    }
  }
  return embedding;
}

}  // namespace tripus::embedding
