#include "embedding/embedding.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Dense>
#include <fmt/format.h>

#include "base/error.hpp"
#include "base/tolerances.hpp"
#include "embedding/detail/orientations.hpp"
#include "geometry/moebius.hpp"
#include "geometry/truncated_tetrahedron.hpp"
#include "topology/requirements.hpp"

namespace tripus::embedding {
namespace {

using topology::Gluings;
using topology::Perm4;
using topology::Triangulation;

// The pairings are computed in the widest type, as the tetrahedra are.
using Wide = long double;
using WideMatrix = Eigen::Matrix<Wide, 4, 4>;
using WideVector = Eigen::Matrix<Wide, 4, 1>;
using FaceMatrix = Eigen::Matrix<Wide, 4, 3>;

std::array<double, 6> lengths_of(const Triangulation& triangulation, std::size_t t,
                                 std::span<const double> edge_lengths) {
  std::array<double, 6> l{};
  for (int e = 0; e < 6; ++e)
    l[static_cast<std::size_t>(e)] = edge_lengths[triangulation.edge_class(t, e)];
  return l;
}

void require_lengths(const Triangulation& triangulation, std::span<const double> edge_lengths) {
  if (edge_lengths.size() != triangulation.edge_count()) {
    throw InvalidInput(fmt::format("{} edge lengths were given for {} edge classes",
                                   edge_lengths.size(), triangulation.edge_count()));
  }
  for (std::size_t e = 0; e < edge_lengths.size(); ++e) {
    if (!std::isfinite(edge_lengths[e]) || edge_lengths[e] <= 0) {
      throw InvalidInput(
          fmt::format("the length of edge class {} is {}; lengths are finite and "
                      "greater than 0",
                      e, edge_lengths[e]));
    }
  }
}

void require_metric(const Triangulation& triangulation, std::span<const double> edge_lengths) {
  std::vector<double> sums(edge_lengths.size(), 0.0);
  for (std::size_t t = 0; t < triangulation.tetrahedron_count(); ++t) {
    std::array<double, 6> theta{};
    geometry::dihedral_angles(lengths_of(triangulation, t, edge_lengths), theta);
    for (int e = 0; e < 6; ++e)
      sums[triangulation.edge_class(t, e)] += theta[static_cast<std::size_t>(e)];
  }
  for (std::size_t e = 0; e < sums.size(); ++e) {
    const double curvature = 2 * std::numbers::pi - sums[e];
    if (!(std::abs(curvature) <= tolerance::kEmbeddedCurvature)) {
      throw InvalidInput(fmt::format(
          "the angles around edge class {} miss 2 pi by {:.3g}: these lengths are no metric, and "
          "the tetrahedra do not fit together in hyperbolic space; solve to a smaller tolerance",
          e, curvature));
    }
  }
}

/// The three vertices of face f, in increasing order, and where the gluing p takes them.
std::array<int, 3> face_vertices(int f) {
  std::array<int, 3> vertices{};
  std::size_t n = 0;
  for (int v = 0; v < 4; ++v)
    if (v != f) vertices[n++] = v;
  return vertices;
}

/// A = (sum_ab v_a (G^-1)_ab v'_b^T - n n'^T) J, docs/theory.md (63): takes v'_b to v_b for the
/// three vertices of the face, and the outward normal n' to -n.
Matrix4 face_pairing(const HyperboloidTetrahedron& here, const HyperboloidTetrahedron& there,
                     Perm4 p, int f, bool reverses) {
  const std::array<int, 3> vertices = face_vertices(f);
  FaceMatrix v, w;
  for (int n = 0; n < 3; ++n) {
    const int vertex = vertices[static_cast<std::size_t>(n)];
    v.col(n) = here.vertices[static_cast<std::size_t>(vertex)].cast<Wide>();
    w.col(n) = there.vertices[static_cast<std::size_t>(p(vertex))].cast<Wide>();
  }
  const WideVector signs(1, 1, 1, -1);
  // Scaled to entries of order 1, so that the inverse is harmless for long edges too.
  const Eigen::Matrix<Wide, 3, 1> size = w.colwise().norm();
  w = (w * size.cwiseInverse().asDiagonal()).eval();
  v = (v * size.cwiseInverse().asDiagonal()).eval();
  const Eigen::Matrix<Wide, 3, 3> gram = w.transpose() * signs.asDiagonal() * w;
  const WideVector n = here.faces[static_cast<std::size_t>(f)].cast<Wide>();
  const WideVector m = there.faces[static_cast<std::size_t>(p(f))].cast<Wide>();
  const WideMatrix pairing =
      (v * gram.inverse() * w.transpose() - n * m.transpose()) * signs.asDiagonal();
  return geometry::to_matrix(geometry::to_moebius(pairing.cast<double>(), reverses));
}

}  // namespace

Embedding embed(const Triangulation& triangulation, std::span<const double> edge_lengths) {
  topology::require_geodesic_boundary(triangulation);
  require_lengths(triangulation, edge_lengths);
  const std::size_t count = triangulation.tetrahedron_count();
  const std::vector<int> orientation = detail::orientations(triangulation.gluings());
  Embedding embedding;
  embedding.tetrahedra.reserve(count);
  for (std::size_t t = 0; t < count; ++t) {
    try {
      embedding.tetrahedra.push_back(geometry::hyperboloid_tetrahedron(
          lengths_of(triangulation, t, edge_lengths), orientation[t]));
    } catch (const Unsupported& error) {
      throw Unsupported(fmt::format("tetrahedron {}: {}", t, error.what()));
    } catch (const InvalidInput& error) {
      throw InvalidInput(fmt::format("tetrahedron {}: {}", t, error.what()));
    }
  }
  require_metric(triangulation, edge_lengths);
  const Gluings& gluings = triangulation.gluings();
  embedding.face_pairings.resize(count);
  for (std::size_t t = 0; t < count; ++t) {
    for (int f = 0; f < 4; ++f) {
      const std::size_t other = gluings.neighbour(t, f);
      const Perm4 p = gluings.gluing(t, f);
      const auto back = static_cast<std::size_t>(p(f)), face = static_cast<std::size_t>(f);
      // The second side of a gluing is the inverse of the first, to the last bit.
      embedding.face_pairings[t][face] =
          4 * other + back < 4 * t + face
              ? geometry::lorentz_inverse(embedding.face_pairings[other][back])
              : face_pairing(embedding.tetrahedra[t], embedding.tetrahedra[other], p, f,
                             detail::pairing_reverses(orientation, gluings, t, f));
    }
  }
  return embedding;
}

std::vector<double> edge_defects(const Embedding& embedding, const Triangulation& triangulation) {
  std::vector<double> defects(triangulation.edge_count());
  const Gluings& gluings = triangulation.gluings();
  for (std::size_t e = 0; e < defects.size(); ++e) {
    const topology::EdgeCorner first = triangulation.corners(e)[0];
    const auto& ends = topology::kEdgeEnds[static_cast<std::size_t>(first.edge())];
    std::size_t t = first.tetrahedron();
    // The face to cross next is `ahead`; the one just crossed is `behind`.
    int ahead = 0, behind = 3;
    while (ahead == ends[0] || ahead == ends[1]) ++ahead;
    while (behind == ends[0] || behind == ends[1]) --behind;
    Matrix4 product = Matrix4::Identity();
    for (std::size_t n = 0; n < triangulation.valence(e); ++n) {
      product *= embedding.face_pairings[t][static_cast<std::size_t>(ahead)];
      const Perm4 p = gluings.gluing(t, ahead);
      t = gluings.neighbour(t, ahead);
      const int entered = p(ahead);
      ahead = p(behind);
      behind = entered;
    }
    defects[e] = (product - Matrix4::Identity()).cwiseAbs().maxCoeff();
  }
  return defects;
}

}  // namespace tripus::embedding
