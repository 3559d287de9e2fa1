#include "embedding/embedding.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Dense>
#include <fmt/format.h>

#include "base/error.hpp"
#include "base/tolerances.hpp"
#include "embedding/detail/orientations.hpp"
#include "geometry/mixed_tetrahedron.hpp"
#include "geometry/moebius.hpp"
#include "geometry/truncated_tetrahedron.hpp"
#include "structure/horospheres.hpp"
#include "topology/covers/presentation.hpp"
#include "topology/requirements.hpp"
#include "topology/vertex_kinds.hpp"

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

// Horospheres with a smaller area would meet the limits of doubles.
constexpr double kLeastHorosphereArea = 1e-100;

std::array<double, 6> lengths_of(const Triangulation& triangulation, std::size_t t,
                                 std::span<const double> edge_lengths) {
  std::array<double, 6> l{};
  for (int e = 0; e < 6; ++e)
    l[static_cast<std::size_t>(e)] = edge_lengths[triangulation.edge_class(t, e)];
  return l;
}

using topology::ConeAngle;
using topology::VertexKind;

/// What one tetrahedron has at its vertices: the diagonal of its Gram matrix.
using Diagonal = std::array<double, 4>;

Diagonal diagonal_of(const Triangulation& triangulation, std::size_t t,
                     std::span<const topology::OrbifoldLink> links) {
  Diagonal diagonal{};
  for (int v = 0; v < 4; ++v) {
    const VertexKind kind = links[triangulation.vertex_class(t, v)].kind;
    diagonal[static_cast<std::size_t>(v)] = kind == VertexKind::kHyperideal ? 1
                                            : kind == VertexKind::kIdeal    ? 0
                                                                            : -1;
  }
  return diagonal;
}

void require_lengths(const Triangulation& triangulation, std::span<const double> edge_lengths,
                     std::span<const topology::OrbifoldLink> links,
                     std::span<const ConeAngle> cone_angles) {
  if (edge_lengths.size() != triangulation.edge_count()) {
    throw InvalidInput(fmt::format("{} edge lengths were given for {} edge classes",
                                   edge_lengths.size(), triangulation.edge_count()));
  }
  for (std::size_t e = 0; e < edge_lengths.size(); ++e) {
    const topology::EdgeCorner corner = triangulation.corners(e)[0];
    bool positive = true;
    for (const int end : topology::kEdgeEnds[static_cast<std::size_t>(corner.edge())])
      positive &= links[triangulation.vertex_class(corner.tetrahedron(), end)].kind ==
                  VertexKind::kHyperideal;
    const bool parabolic = cone_angles[e].is_parabolic();
    if (std::isfinite(edge_lengths[e]) &&
        (parabolic ? edge_lengths[e] == 0 : !positive || edge_lengths[e] > 0))
      continue;
    throw InvalidInput(fmt::format("the length of edge class {} is {}; {}", e, edge_lengths[e],
                                   parabolic  ? "that of a parabolic edge is 0"
                                   : positive ? "lengths are finite and greater than 0"
                                              : "lengths are finite"));
  }
}

void require_metric(const Triangulation& triangulation, std::span<const double> edge_lengths,
                    const Embedding& embedding) {
  std::vector<double> sums(edge_lengths.size(), 0.0);
  for (std::size_t t = 0; t < triangulation.tetrahedron_count(); ++t) {
    std::array<double, 6> theta{};
    const Diagonal& diagonal = embedding.tetrahedra[t].diagonal;
    const auto l = lengths_of(triangulation, t, edge_lengths);
    if (diagonal == HyperboloidTetrahedron{}.diagonal &&
        embedding.tetrahedra[t].parabolic_edges == 0)
      geometry::dihedral_angles(l, theta);
    else
      geometry::general_dihedral_angles(l, diagonal, theta);
    for (int e = 0; e < 6; ++e)
      sums[triangulation.edge_class(t, e)] += theta[static_cast<std::size_t>(e)];
  }
  for (std::size_t e = 0; e < sums.size(); ++e) {
    const ConeAngle& wanted = embedding.cone_angles[e];
    const double curvature = wanted.radians() - sums[e];
    if (!(std::abs(curvature) <= tolerance::kEmbeddedCurvature)) {
      throw InvalidInput(fmt::format(
          "the angles around edge class {} miss {} by {:.3g}: these lengths are no metric, and "
          "the tetrahedra do not fit together in hyperbolic space; solve to a smaller tolerance",
          e, wanted.is_full() ? "2 pi" : "their cone angle", curvature));
    }
  }
}

/// The least factor by which the null vectors of a tetrahedron must be multiplied so that every
/// horoball keeps this distance from the opposite face and from the other vertices: 0 where none is
/// ideal. Source: docs/theory.md (115).
double least_scale(const HyperboloidTetrahedron& tetrahedron, double clearance) {
  const double wanted = std::exp(clearance);
  double least = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    if (!tetrahedron.is_ideal(i)) continue;
    const Vector4& v = tetrahedron.vertices[i];
    least = std::max(least, -wanted / geometry::lorentz_product(v, tetrahedron.faces[i]));
    for (std::size_t j = 0; j < 4; ++j) {
      if (j == i) continue;
      const double product = -geometry::lorentz_product(v, tetrahedron.vertices[j]);
      least = std::max(
          least, tetrahedron.is_ideal(j) ? std::sqrt(2 * wanted / product) : wanted / product);
    }
  }
  return least;
}

/// One size for the horospheres of all parabolic edges, the largest up to 1 at which they keep
/// their distance in every tetrahedron.
void set_parabolic_horospheres(Embedding& embedding) {
  double scale = 1;
  for (const HyperboloidTetrahedron& tetrahedron : embedding.tetrahedra) {
    for (std::size_t e = 0; e < 6; ++e) {
      if (!tetrahedron.is_parabolic(e)) continue;
      const Vector4 p = tetrahedron.parabolic_point(e);
      const double wanted = std::exp(kHoroballClearance);
      const auto keep = [&](const Vector4& other, double factor) {
        scale = std::max(scale, -factor * wanted / geometry::lorentz_product(p, other));
      };
      for (const int end : topology::kEdgeEnds[e])
        keep(tetrahedron.faces[static_cast<std::size_t>(end)], 1);
      for (const int far : topology::kEdgeEnds[5 - e]) {
        const auto v = static_cast<std::size_t>(far);
        keep(tetrahedron.vertices[v], tetrahedron.is_ideal(v) ? 2 : 1);
      }
      for (std::size_t other = 0; other < e; ++other)
        if (tetrahedron.is_parabolic(other))
          scale = std::max(
              scale, std::sqrt(-2 * wanted /
                               geometry::lorentz_product(p, tetrahedron.parabolic_point(other))));
    }
  }
  for (HyperboloidTetrahedron& tetrahedron : embedding.tetrahedra)
    tetrahedron.parabolic_scale = scale;
}

/// Moves every horosphere to the area asked for.
void set_horospheres(Embedding& embedding, const Triangulation& triangulation, double area) {
  const std::vector<double> areas = horosphere_areas(embedding, triangulation);
  if (std::ranges::all_of(areas, [](double a) { return a == 0; })) return;
  // First to the standard area, which makes them comparable.
  std::vector<double> scale(areas.size(), 1.0);
  const auto apply = [&] {
    for (std::size_t t = 0; t < embedding.tetrahedra.size(); ++t)
      for (std::size_t v = 0; v < 4; ++v)
        if (embedding.tetrahedra[t].is_ideal(v))
          embedding.tetrahedra[t].vertices[v] *=
              scale[triangulation.vertex_class(t, static_cast<int>(v))];
  };
  for (std::size_t v = 0; v < areas.size(); ++v)
    if (areas[v] > 0) scale[v] = std::sqrt(areas[v] / structure::kHorosphereArea);
  apply();
  double least = 0;
  for (const HyperboloidTetrahedron& tetrahedron : embedding.tetrahedra)
    least = std::max(least, least_scale(tetrahedron, area > 0 ? 0 : kHoroballClearance));
  const double largest = structure::kHorosphereArea / (least * least);
  if (area > largest)
    throw InvalidInput(fmt::format(
        "horospheres of area {} would cut through tetrahedra; the largest possible area here is {}",
        area, largest));
  embedding.horosphere_area = area > 0 ? area : std::min(structure::kHorosphereArea, largest);
  scale.assign(areas.size(), std::sqrt(structure::kHorosphereArea / embedding.horosphere_area));
  apply();
}

/// The rotation about edge ij of a tetrahedron by the angle k, in the direction in which its face
/// `ahead` is crossed from inside; `behind` is the other face at the edge.
Matrix4 rotation_about_edge(const HyperboloidTetrahedron& tetrahedron, int ahead, int behind,
                            double k) {
  if (k == 2 * std::numbers::pi) return Matrix4::Identity();
  const Vector4& n = tetrahedron.faces[static_cast<std::size_t>(ahead)];
  const Vector4& m = tetrahedron.faces[static_cast<std::size_t>(behind)];
  // h lies in the face ahead, orthogonal to the edge, and points into the face.
  const double product = geometry::lorentz_product(n, m);
  const Vector4 h = (product * n - m) / std::sqrt((1 - product) * (1 + product));
  const Vector4 signs(1, 1, 1, -1);
  const double c = std::cos(k) - 1, s = std::sin(k);
  const Matrix4 turned = (c * h + s * n) * h.transpose() + (c * n - s * h) * n.transpose();
  return Matrix4::Identity() + turned * signs.asDiagonal();
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

bool Embedding::develops() const {
  return std::ranges::all_of(cone_angles, [](const ConeAngle& k) {
    return k.is_parabolic() || topology::rotation_order(k) != 0;
  });
}

Embedding embed(const Triangulation& triangulation, std::span<const double> edge_lengths,
                const EmbedOptions& options) {
  Embedding embedding;
  embedding.cone_angles = topology::completed(options.cone_angles, triangulation.edge_count());
  topology::require_solvable(triangulation, embedding.cone_angles);
  const double area = options.horosphere_area;
  if (area != 0 && (!(area >= kLeastHorosphereArea) || !std::isfinite(area)))
    throw InvalidInput(fmt::format(
        "the area of horospheres is {}; it must be a number from {} on, or 0 for the usual one",
        area, kLeastHorosphereArea));
  const auto links = topology::orbifold_links(triangulation, embedding.cone_angles);
  require_lengths(triangulation, edge_lengths, links, embedding.cone_angles);
  const std::size_t count = triangulation.tetrahedron_count();
  const std::vector<int> orientation = detail::orientations(triangulation.gluings());
  embedding.tetrahedra.reserve(count);
  embedding.singular_edges.resize(count);
  for (std::size_t t = 0; t < count; ++t) {
    for (int e = 0; e < 6; ++e)
      if (!embedding.cone_angles[triangulation.edge_class(t, e)].is_full())
        embedding.singular_edges[t] |= static_cast<std::uint8_t>(1u << e);
    try {
      embedding.tetrahedra.push_back(
          geometry::hyperboloid_tetrahedron(lengths_of(triangulation, t, edge_lengths),
                                            diagonal_of(triangulation, t, links), orientation[t]));
    } catch (const Unsupported& error) {
      throw Unsupported(fmt::format("tetrahedron {}: {}", t, error.what()));
    } catch (const InvalidInput& error) {
      throw InvalidInput(fmt::format("tetrahedron {}: {}", t, error.what()));
    }
  }
  require_metric(triangulation, edge_lengths, embedding);
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
  set_horospheres(embedding, triangulation, options.horosphere_area);
  set_parabolic_horospheres(embedding);
  return embedding;
}

std::vector<double> horosphere_areas(const Embedding& embedding,
                                     const Triangulation& triangulation) {
  std::vector<double> areas(triangulation.vertex_count());
  for (std::size_t t = 0; t < embedding.tetrahedra.size(); ++t) {
    for (int i = 0; i < 4; ++i) {
      const HyperboloidTetrahedron& tetrahedron = embedding.tetrahedra[t];
      if (!tetrahedron.is_ideal(static_cast<std::size_t>(i))) continue;
      const auto [j, k, l] = face_vertices(i);
      // On a horosphere lengths are those of chords: two sides, and their Gram determinant.
      const Vector4 p = geometry::corner(tetrahedron, i, j) - geometry::corner(tetrahedron, i, l);
      const Vector4 q = geometry::corner(tetrahedron, i, k) - geometry::corner(tetrahedron, i, l);
      const double pp = geometry::lorentz_product(p, p), pq = geometry::lorentz_product(p, q),
                   qq = geometry::lorentz_product(q, q);
      areas[triangulation.vertex_class(t, i)] += std::sqrt(std::max(pp * qq - pq * pq, 0.0)) / 2;
    }
  }
  return areas;
}

std::vector<double> edge_defects(const Embedding& embedding, const Triangulation& triangulation) {
  std::vector<double> defects(triangulation.edge_count());
  const Gluings& gluings = triangulation.gluings();
  for (std::size_t e = 0; e < defects.size(); ++e) {
    const topology::EdgeCorner first = triangulation.corners(e)[0];
    const auto& ends = topology::kEdgeEnds[static_cast<std::size_t>(first.edge())];
    std::size_t t = first.tetrahedron();
    const HyperboloidTetrahedron& here = embedding.tetrahedra[t];
    // The face to cross next is `ahead`; the one just crossed is `behind`.
    int ahead = 0, behind = 3;
    while (ahead == ends[0] || ahead == ends[1]) ++ahead;
    while (behind == ends[0] || behind == ends[1]) --behind;
    const bool parabolic = embedding.cone_angles[e].is_parabolic();
    const Matrix4 rotation =
        parabolic ? Matrix4::Identity()
                  : rotation_about_edge(here, ahead, behind, embedding.cone_angles[e].radians());
    Matrix4 product = Matrix4::Identity();
    for (std::size_t n = 0; n < triangulation.valence(e); ++n) {
      product *= embedding.face_pairings[t][static_cast<std::size_t>(ahead)];
      const Perm4 p = gluings.gluing(t, ahead);
      t = gluings.neighbour(t, ahead);
      const int entered = p(ahead);
      ahead = p(behind);
      behind = entered;
    }
    if (parabolic) {
      for (const int end : ends) {
        const Vector4& v = here.vertices[static_cast<std::size_t>(end)];
        defects[e] = std::max(defects[e], (product * v - v).cwiseAbs().maxCoeff());
      }
      continue;
    }
    defects[e] = (product - rotation).cwiseAbs().maxCoeff();
  }
  return defects;
}

}  // namespace tripus::embedding
