#include "parameterise/quality.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include "base/error.hpp"
#include "meshing/predicates.hpp"

namespace tripus::parameterise {
namespace {

using geometry::lorentz_product;
using geometry::Vector3;

/// Spatial coordinates as seen from a point: the boost that takes it to the origin.
Vector4 seen_from(const Vector4& eye, const Vector4& x) {
  const Vector3 e = eye.head<3>(), y = x.head<3>();
  Vector4 seen;
  seen.head<3>() = y - e * x[3] + e * (e.dot(y) / (1 + eye[3]));
  seen[3] = std::sqrt(1 + seen.head<3>().squaredNorm());
  return seen;
}

struct Gauss {
  std::vector<double> x, w;  // on (0, 1)
};

/// Gauss-Legendre rule by Newton's method on the Legendre polynomials.
Gauss gauss_rule(int n) {
  Gauss rule;
  for (int i = 1; i <= n; ++i) {
    double z = std::cos(3.14159265358979323846 * (i - 0.25) / (n + 0.5)), slope = 1;
    for (int k = 0; k < 50; ++k) {
      double p = 1, previous = 0;
      for (int j = 1; j <= n; ++j) {
        const double next = ((2 * j - 1) * z * p - (j - 1) * previous) / j;
        previous = p;
        p = next;
      }
      slope = n * (z * p - previous) / (z * z - 1);
      const double step = p / slope;
      z -= step;
      if (std::abs(step) < 1e-16) break;
    }
    rule.x.push_back((1 - z) / 2);
    rule.w.push_back(1 / ((1 - z * z) * slope * slope));
  }
  return rule;
}

/// The rule of a cube, folded onto a tetrahedron.
struct SimplexRule {
  std::vector<std::array<double, 4>> points;  // barycentric
  std::vector<double> weights;                // they sum to 1 / 6
};

SimplexRule simplex_rule(int n) {
  const Gauss gauss = gauss_rule(n);
  SimplexRule rule;
  for (std::size_t i = 0; i < gauss.x.size(); ++i)
    for (std::size_t j = 0; j < gauss.x.size(); ++j)
      for (std::size_t k = 0; k < gauss.x.size(); ++k) {
        const double r = gauss.x[i], s = gauss.x[j], t = gauss.x[k];
        rule.points.push_back({1 - r, r * (1 - s), r * s * (1 - t), r * s * t});
        rule.weights.push_back(gauss.w[i] * gauss.w[j] * gauss.w[k] * r * r * s);
      }
  return rule;
}

/// Radius below which the rules are exact to rounding.
constexpr double kSmall = 0.05, kMedium = 0.4;

double piece_volume(const std::array<Vector4, 4>& corners, int depth) {
  static const SimplexRule kFine = simplex_rule(9), kCoarse = simplex_rule(4);
  const Vector4 eye = middle(corners);
  std::array<Vector4, 4> seen;
  double size = 0;
  for (std::size_t v = 0; v < 4; ++v) {
    seen[v] = seen_from(eye, corners[v]);
    size = std::max(size, seen[v].head<3>().norm());
  }
  if (size > kMedium && depth < 40) {
    std::size_t a = 0, b = 1;
    double longest = -1;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j) {
        const double d = -lorentz_product(seen[i], seen[j]);
        if (d > longest) {
          longest = d;
          a = i;
          b = j;
        }
      }
    Vector4 half = seen[a] + seen[b];
    half = geometry::on_hyperboloid(half / std::sqrt(-lorentz_product(half, half)));
    std::array<Vector4, 4> one = seen, two = seen;
    one[a] = half;
    two[b] = half;
    return piece_volume(one, depth + 1) + piece_volume(two, depth + 1);
  }
  std::array<Vector3, 4> k;
  for (std::size_t v = 0; v < 4; ++v) k[v] = seen[v].head<3>() / seen[v][3];
  const double det = (k[1] - k[0]).cross(k[2] - k[0]).dot(k[3] - k[0]);
  const SimplexRule& rule = size < kSmall ? kCoarse : kFine;
  double sum = 0;
  for (std::size_t q = 0; q < rule.weights.size(); ++q) {
    const auto& c = rule.points[q];
    const Vector3 x = c[0] * k[0] + c[1] * k[1] + c[2] * k[2] + c[3] * k[3];
    const double rest = 1 - x.squaredNorm();
    sum += rule.weights[q] / (rest * rest);
  }
  return det * sum;
}

meshing::Point klein(const Vector4& x) { return {x[0] / x[3], x[1] / x[3], x[2] / x[3]}; }

/// Planes of the boundary do not meet: the product of the poles of two is -+cosh of their distance.
constexpr double kSamePlane = 1e-6;

/// Whether all corners of a tetrahedron are held to one plane of the geodesic boundary.
bool is_in_boundary(const MarkedSolid& solid, std::size_t t) {
  std::array<Vector4, 4> poles;
  for (std::size_t v = 0; v < 4; ++v) {
    const Vector4& pole = solid.poles[solid.mesh.tetrahedra[t][v]];
    if (pole.isZero(0)) return false;
    poles[v] = solid.group->matrix(solid.corners[4 * t + v]) * pole;
    if (std::abs(lorentz_product(poles[v], poles[0]) - 1) > kSamePlane) return false;
  }
  return true;
}

CellQuality cell_quality(const std::array<Vector4, 4>& corners,
                         const std::array<Vector3, 4>& in_space, bool is_flat) {
  CellQuality cell;
  const Vector4 eye = middle(corners);
  std::array<Vector4, 4> seen;
  for (std::size_t v = 0; v < 4; ++v) seen[v] = seen_from(eye, corners[v]);
  cell.orientation = is_flat ? 0
                             : meshing::orientation(klein(seen[0]), klein(seen[1]), klein(seen[2]),
                                                    klein(seen[3]));
  cell.volume = is_flat ? 0 : signed_volume(corners);
  // Straight lines from the middle: asinh |x| / |x| times x.
  Eigen::Matrix3d from, to;
  std::array<Vector3, 4> flat;
  for (std::size_t v = 0; v < 4; ++v) {
    const Vector3 x = seen[v].head<3>();
    const double r = x.norm();
    flat[v] = r > 1e-8 ? Vector3(x * (std::asinh(r) / r)) : x;
  }
  for (int c = 0; c < 3; ++c) {
    from.col(c) = in_space[static_cast<std::size_t>(c + 1)] - in_space[0];
    to.col(c) = flat[static_cast<std::size_t>(c + 1)] - flat[0];
  }
  const Eigen::Vector3d stretch =
      Eigen::JacobiSVD<Eigen::Matrix3d>(to * from.inverse()).singularValues();
  constexpr double kMost = 1e300;  // of a flat image
  cell.anisotropy = !is_flat && stretch[2] > stretch[0] / kMost ? stretch[0] / stretch[2] : kMost;
  const double euclidean = from.determinant() / 6;
  cell.volume_ratio = cell.volume / euclidean;
  return cell;
}

}  // namespace

double signed_volume(const std::array<Vector4, 4>& corners) { return piece_volume(corners, 0); }

Vector4 middle(const std::array<Vector4, 4>& corners) {
  const Vector4 sum = corners[0] + corners[1] + corners[2] + corners[3];
  return geometry::on_hyperboloid(sum / std::sqrt(std::max(-lorentz_product(sum, sum), 1.0)));
}

std::array<Vector4, 4> image(const MarkedSolid& solid, std::span<const Vector4> points,
                             std::size_t t) {
  std::array<Vector4, 4> corners;
  for (std::size_t v = 0; v < 4; ++v) {
    const Vector4& point = points[solid.mesh.tetrahedra[t][v]];
    const std::uint32_t element = solid.corners[4 * t + v];
    corners[v] = element == 0 ? point : Vector4(solid.group->matrix(element) * point);
  }
  return corners;
}

namespace {

/// Signed volume of what the images of boundary spheres bound on the side away from the solid:
/// cones from one point of each. A sphere lifts to hyperbolic space; points are carried along its
/// edges.
double volume_of_filled_balls(MarkedSolid& solid, std::span<const Vector4> points) {
  constexpr std::uint32_t kNone = 0xffffffffu;
  struct Face {
    std::size_t t;
    std::array<std::size_t, 3> corners;  // outward
  };
  std::vector<Face> faces;
  std::vector<std::vector<std::uint32_t>> at(points.size());
  constexpr std::array<std::array<std::size_t, 3>, 4> kOutwards{
      {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
  for (std::size_t t = 0; t < solid.mesh.tetrahedra.size(); ++t)
    for (std::size_t f = 0; f < 4; ++f) {
      if (!solid.gluings.is_open(t, static_cast<int>(f))) continue;
      const Face face{t, kOutwards[f]};
      if (!solid.poles[solid.mesh.tetrahedra[t][face.corners[0]]].isZero(0)) continue;
      for (const std::size_t v : face.corners)
        at[solid.mesh.tetrahedra[t][v]].push_back(static_cast<std::uint32_t>(faces.size()));
      faces.push_back(face);
    }
  std::vector<std::uint32_t> element(points.size(), kNone);
  double volume = 0;
  for (std::uint32_t first = 0; first < points.size(); ++first) {
    if (at[first].empty() || element[first] != kNone) continue;
    element[first] = 0;
    std::vector<std::uint32_t> queue{first};
    for (std::size_t i = 0; i < queue.size(); ++i)
      for (const std::uint32_t n : at[queue[i]]) {
        const Face& face = faces[n];
        const auto& corners = solid.mesh.tetrahedra[face.t];
        std::array<Vector4, 4> cone;
        std::uint32_t frame = kNone;  // of the tetrahedron, in that of the first point
        for (const std::size_t v : face.corners)
          if (corners[v] == queue[i])
            frame = solid.group->product(element[queue[i]],
                                         solid.group->inverse(solid.corners[4 * face.t + v]));
        for (std::size_t k = 0; k < 3; ++k) {
          const std::size_t v = face.corners[k];
          const std::uint32_t here = solid.group->product(frame, solid.corners[4 * face.t + v]);
          if (element[corners[v]] == kNone) {
            element[corners[v]] = here;
            queue.push_back(corners[v]);
          }
          cone[k] = solid.group->matrix(here) * points[corners[v]];
        }
        // Each face is met from its three corners; outward of the solid is inward of the ball.
        cone[3] = points[first];
        volume += signed_volume(cone) / 3;
      }
  }
  return volume;
}

}  // namespace

Quality quality(MarkedSolid& solid, std::span<const Vector4> points) {
  Quality result;
  result.manifold_volume = solid.report.volume;
  double space = 0;
  std::vector<double> anisotropies;
  for (std::size_t t = 0; t < solid.mesh.tetrahedra.size(); ++t) {
    std::array<Vector3, 4> x;
    for (std::size_t v = 0; v < 4; ++v)
      x[v] = Eigen::Map<const Vector3>(solid.mesh.points[solid.mesh.tetrahedra[t][v]].data());
    result.cells.push_back(cell_quality(image(solid, points, t), x, is_in_boundary(solid, t)));
    const CellQuality& cell = result.cells.back();
    result.inverted += cell.orientation < 0;
    result.flat += cell.orientation == 0;
    result.image_volume += cell.volume;
    space += (x[1] - x[0]).cross(x[2] - x[0]).dot(x[3] - x[0]) / 6;
    if (cell.orientation > 0) anisotropies.push_back(cell.anisotropy);
  }
  result.filled_volume = volume_of_filled_balls(solid, points);
  result.image_volume += result.filled_volume;
  for (CellQuality& cell : result.cells) cell.volume_ratio *= space / result.manifold_volume;
  if (!anisotropies.empty()) {
    std::ranges::sort(anisotropies);
    result.median_anisotropy = anisotropies[anisotropies.size() / 2];
    result.worst_anisotropy = anisotropies.back();
  }
  for (std::size_t v = 0; v < points.size(); ++v)
    if (!solid.poles[v].isZero(0))
      result.off_boundary =
          std::max(result.off_boundary, std::abs(lorentz_product(points[v], solid.poles[v])));
  return result;
}

Located located(const MarkedSolid& solid, const Vector4& point) {
  constexpr double kInside = 1e-12;
  constexpr int kMostCells = 100'000;
  Vector4 y = geometry::on_hyperboloid(geometry::lorentz_inverse(solid.places[0]) * point);
  std::size_t t = 0;
  for (int n = 0; n < kMostCells; ++n) {
    std::size_t face = 4;
    double most = kInside * y[3];
    for (std::size_t f = 0; f < 4; ++f) {
      const double beyond = lorentz_product(y, solid.embedding.tetrahedra[t].faces[f]);
      if (beyond > most) {
        most = beyond;
        face = f;
      }
    }
    if (face == 4) break;
    y = geometry::on_hyperboloid(geometry::lorentz_inverse(solid.embedding.face_pairings[t][face]) *
                                 y);
    t = solid.manifold->gluings().neighbour(t, static_cast<int>(face));
  }
  Located result;
  result.tetrahedron = static_cast<std::uint32_t>(t);
  const meshing::Point place = klein(y);
  result.position = place;
  double nearest = 1e300;
  for (const Vector4& pole : solid.embedding.tetrahedra[t].vertices)
    nearest = std::min(nearest, std::asinh(std::max(-lorentz_product(y, pole), 0.0)));
  result.to_boundary = nearest;
  return result;
}

}  // namespace tripus::parameterise
