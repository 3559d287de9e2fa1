#include "energies/harmonic.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.hpp"
#include "geometry/boost.hpp"

// With c = -<X, gY> = cosh d, an edge has w phi(c) with phi(c) = (arcosh c)^2 / 2. X is linear in
// (u, sqrt(1 + |u|^2)) and c is bilinear in X and Y, so all derivatives are products of
//     phi' = d / sinh d,     phi'' = (1 - d coth d) / sinh^2 d
// with Lorentz products of points and tangents. Differences of points are taken first wherever that
// keeps digits: <X, X> is constant, so that -<dX, gY> = <dX, X - gY>.

namespace tripus::energies {
namespace {

using geometry::lorentz_product;
using geometry::Matrix4;
using geometry::Vector3;
using geometry::Vector4;

/// An isometry that takes the plane z = 0 to the plane with this pole, and its origin to the point
/// of the plane nearest to the origin of space: a rotation after a boost along z.
Matrix4 plane_frame(const Vector4& pole) {
  const Vector3 space = pole.head<3>();
  const double size = space.norm();  // >= 1, cosh of the distance of the plane
  const Vector3 up = space / size;
  // Householder's reflection that takes z to `up`, and one more to keep orientation.
  Matrix4 rotation = Matrix4::Identity();
  Vector3 w = Vector3::UnitZ() - up;
  if (w.squaredNorm() > 0) {
    rotation.topLeftCorner<3, 3>() -= 2 * w * w.transpose() / w.squaredNorm();
    rotation.col(0) *= -1;
  }
  Matrix4 along = Matrix4::Identity();
  along(2, 2) = along(3, 3) = size;
  along(2, 3) = along(3, 2) = pole[3];
  // Takes (0, 0, 1, 0) to (0, 0, size, time): the pole, and (0, 0, 0, 1) into the plane.
  return rotation * along;
}

[[noreturn]] void refuse_edge(std::size_t e, const std::string& what) {
  throw InvalidInput("edge " + std::to_string(e) + " of the harmonic energy " + what);
}

}  // namespace

std::array<double, 2> half_square_derivatives(double d) {
  const double half = std::sinh(d / 2);
  const double t = 2 * half * half;  // c - 1
  if (t < 1e-2) {
    // phi'(1 + t) = sum over n of t^n times the product of -k / (2 k + 1), k = 1 .. n.
    double first = 1, second = 0, term = 1;
    for (int n = 1; n <= 9; ++n) {
      const double next = -n / (2.0 * n + 1) * term;
      second += n * next;
      term = next * t;
      first += term;
    }
    return {first, second};
  }
  const double s = std::sinh(d);
  return {d / s, (1 - d / std::tanh(d)) / (s * s)};
}

HarmonicEnergy::HarmonicEnergy(std::vector<HarmonicEdge> edges, std::vector<Matrix4> isometries,
                               std::span<const Vector4> points, std::span<const Vector4> poles)
    : edges_(std::move(edges)), isometries_(std::move(isometries)) {
  if (points.size() != poles.size())
    throw InvalidInput("a harmonic energy needs a pole, or 0, for each of its " +
                       std::to_string(points.size()) + " points, and not " +
                       std::to_string(poles.size()));
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const HarmonicEdge& edge = edges_[e];
    if (edge.a >= points.size() || edge.b >= points.size())
      refuse_edge(e, "has an end that is no point");
    if (edge.isometry >= isometries_.size()) refuse_edge(e, "has no such isometry");
    if (!std::isfinite(edge.weight))
      refuse_edge(e, "has the weight " + std::to_string(edge.weight) + ", which is not finite");
    if (edge.a == edge.b) refuse_edge(e, "is a loop; subdivide the mesh");
  }
  first_.push_back(0);
  planes_.reserve(points.size());
  for (std::size_t v = 0; v < points.size(); ++v) {
    const bool is_held = !poles[v].isZero(0);
    first_.push_back(first_.back() + (is_held ? 2 : 3));
    planes_.push_back(is_held ? plane_frame(poles[v]) : Matrix4(Matrix4::Identity()));
  }
  base_.resize(points.size());
  frames_.resize(points.size());
  rebase(points);
}

bool HarmonicEnergy::evaluate(std::span<const double> x, solver::Order order,
                              std::unique_ptr<solver::Evaluation>& into) const {
  return solver::reuse<HarmonicAt>(into, *this).move_to(x, order);
}

HarmonicAt::HarmonicAt(const HarmonicEnergy& energy)
    : energy_(&energy),
      gradient_(energy.dimension()),
      places_(energy.point_count()),
      u_(energy.point_count()),
      in_(3 * energy.point_count()),
      out_(3 * energy.point_count()) {}

void HarmonicAt::place(std::span<const double> x) {
  for (std::size_t v = 0; v < places_.size(); ++v) {
    Vector3& u = u_[v];
    u.setZero();
    for (std::size_t k = 0; k < energy_->width(v); ++k)
      u[static_cast<Eigen::Index>(k)] = x[energy_->first_[v] + k];
    Place& here = places_[v];
    const Matrix4& B = energy_->frames_[v];
    here.time = std::sqrt(1 + u.squaredNorm());
    here.point = B.leftCols<3>() * u + here.time * B.col(3);
    for (int k = 0; k < 3; ++k)
      here.tangent[static_cast<std::size_t>(k)] = B.col(k) + u[k] / here.time * B.col(3);
  }
}

bool HarmonicAt::move_to(std::span<const double> x, solver::Order order) {
  const bool second_derivatives = order == solver::Order::kSecond;
  const HarmonicEnergy& energy = *energy_;
  const std::vector<HarmonicEdge>& edges = energy.edges_;
  place(x);
  std::fill(gradient_.begin(), gradient_.end(), 0.0);
  double value = 0;
  if (second_derivatives) {
    diagonal_.assign(places_.size(), {});
    across_.resize(edges.size());
    bend_.assign(places_.size(), 0.0);
  }
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const HarmonicEdge& edge = edges[e];
    const Place& a = places_[edge.a];
    Place b = places_[edge.b];
    Vector4 base = energy.frames_[edge.b].col(3);
    if (edge.isometry != 0) {
      const Matrix4& g = energy.isometries_[edge.isometry];
      b.point = g * b.point;
      for (Vector4& tangent : b.tangent) tangent = g * tangent;
      base = g * base;
    }
    const Vector4 step = a.point - b.point;
    const double d = 2 * std::asinh(std::sqrt(std::max(lorentz_product(step, step), 0.0)) / 2);
    if (!std::isfinite(d)) return false;
    const auto [first, second] = half_square_derivatives(d);
    value += edge.weight * d * d / 2;
    std::array<double, 3> ca{}, cb{};
    for (std::size_t k = 0; k < 3; ++k) {
      ca[k] = lorentz_product(a.tangent[k], step);
      cb[k] = -lorentz_product(b.tangent[k], step);
    }
    const double w1 = edge.weight * first;
    for (std::size_t k = 0; k < energy.width(edge.a); ++k)
      gradient_[energy.first_variable(edge.a) + k] += w1 * ca[k];
    for (std::size_t k = 0; k < energy.width(edge.b); ++k)
      gradient_[energy.first_variable(edge.b) + k] += w1 * cb[k];
    if (!second_derivatives) continue;
    const double w2 = edge.weight * second;
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t l = 0; l < 3; ++l) {
        across_[e][3 * k + l] =
            w2 * ca[k] * cb[l] - w1 * lorentz_product(a.tangent[k], b.tangent[l]);
        diagonal_[edge.a][3 * k + l] += w2 * ca[k] * ca[l];
        diagonal_[edge.b][3 * k + l] += w2 * cb[k] * cb[l];
      }
    bend_[edge.a] -= w1 * lorentz_product(energy.frames_[edge.a].col(3), b.point);
    bend_[edge.b] -= w1 * lorentz_product(a.point, base);
  }
  value_ = value;
  if (second_derivatives)
    for (std::size_t v = 0; v < places_.size(); ++v) {
      const double time = places_[v].time;
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l)
          diagonal_[v][static_cast<std::size_t>(3 * k + l)] +=
              bend_[v] * ((k == l) - u_[v][k] * u_[v][l] / (time * time)) / time;
    }
  return std::isfinite(value);
}

/// Calls add(variable, variable, entry, slot) for all ordered pairs of variables, the diagonal
/// blocks once; slot is the element and the local pair of the pattern.
template <class Add>
void HarmonicAt::for_entries(Add&& add) const {
  for (std::size_t v = 0; v < places_.size(); ++v)
    for (std::size_t k = 0; k < energy_->width(v); ++k)
      for (std::size_t l = 0; l < energy_->width(v); ++l)
        add(energy_->first_[v] + k, energy_->first_[v] + l, diagonal_[v][3 * k + l]);
  for (std::size_t e = 0; e < energy_->edges_.size(); ++e) {
    const HarmonicEdge& edge = energy_->edges_[e];
    for (std::size_t k = 0; k < energy_->width(edge.a); ++k)
      for (std::size_t l = 0; l < energy_->width(edge.b); ++l) {
        add(energy_->first_[edge.a] + k, energy_->first_[edge.b] + l, across_[e][3 * k + l]);
        add(energy_->first_[edge.b] + l, energy_->first_[edge.a] + k, across_[e][3 * k + l]);
      }
  }
}

const solver::SparsityPattern& HarmonicEnergy::hessian_pattern() const {
  const auto make = [&] {
    std::vector<std::uint32_t> variables(6 * edges_.size(), kNoVariable);
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      for (std::size_t k = 0; k < width(edges_[e].a); ++k)
        variables[6 * e + k] = static_cast<std::uint32_t>(first_[edges_[e].a] + k);
      for (std::size_t k = 0; k < width(edges_[e].b); ++k)
        variables[6 * e + 3 + k] = static_cast<std::uint32_t>(first_[edges_[e].b] + k);
    }
    return ElementPattern(dimension(), 6, variables);
  };
  return pattern_.get(make).pattern();
}

void HarmonicAt::hessian_values(std::span<double> values) const {
  std::fill(values.begin(), values.end(), 0.0);
  const solver::SparsityPattern& pattern = energy_->hessian_pattern();
  for_entries([&](std::size_t row, std::size_t column, double entry) {
    if (row < column) return;
    const auto begin = pattern.row.begin() + pattern.column_start[column];
    const auto end = pattern.row.begin() + pattern.column_start[column + 1];
    const auto at = std::lower_bound(begin, end, static_cast<std::int32_t>(row));
    values[static_cast<std::size_t>(at - pattern.row.begin())] += entry;
  });
}

void HarmonicAt::hessian_times(std::span<const double> v, std::span<double> Hv) const {
  const auto at = [](std::vector<double>& padded, std::size_t p) { return &padded[3 * p]; };
  for (std::size_t p = 0; p < places_.size(); ++p) {
    double* in = at(in_, p);
    in[2] = 0;
    std::copy_n(v.data() + energy_->first_[p], energy_->width(p), in);
    double* out = at(out_, p);
    const std::array<double, 9>& m = diagonal_[p];
    for (std::size_t k = 0; k < 3; ++k)
      out[k] = m[3 * k] * in[0] + m[3 * k + 1] * in[1] + m[3 * k + 2] * in[2];
  }
  for (std::size_t e = 0; e < energy_->edges_.size(); ++e) {
    const std::array<double, 9>& m = across_[e];
    const double* a = at(in_, energy_->edges_[e].a);
    const double* b = at(in_, energy_->edges_[e].b);
    double* to_a = at(out_, energy_->edges_[e].a);
    double* to_b = at(out_, energy_->edges_[e].b);
    for (std::size_t k = 0; k < 3; ++k) {
      to_a[k] += m[3 * k] * b[0] + m[3 * k + 1] * b[1] + m[3 * k + 2] * b[2];
      to_b[k] += m[k] * a[0] + m[3 + k] * a[1] + m[6 + k] * a[2];
    }
  }
  for (std::size_t p = 0; p < places_.size(); ++p)
    std::copy_n(at(out_, p), energy_->width(p), Hv.data() + energy_->first_[p]);
}

void HarmonicAt::hessian_diagonal_blocks(std::size_t block_size, std::span<double> blocks) const {
  std::fill(blocks.begin(), blocks.end(), 0.0);
  const std::size_t b = block_size;
  for_entries([&](std::size_t row, std::size_t column, double entry) {
    if (row / b == column / b) blocks[(row / b * b + row % b) * b + column % b] += entry;
  });
}

std::vector<Vector4> HarmonicEnergy::points(std::span<const double> x) const {
  std::vector<Vector4> points;
  points.reserve(point_count());
  for (std::size_t v = 0; v < point_count(); ++v) {
    Vector3 u = Vector3::Zero();
    for (std::size_t k = 0; k < width(v); ++k) u[static_cast<Eigen::Index>(k)] = x[first_[v] + k];
    points.push_back(frames_[v].leftCols<3>() * u +
                     std::sqrt(1 + u.squaredNorm()) * frames_[v].col(3));
  }
  return points;
}

void HarmonicEnergy::rebase(std::span<const Vector4> points) {
  for (std::size_t v = 0; v < point_count(); ++v) {
    Vector4 place = geometry::lorentz_inverse(planes_[v]) * points[v];
    if (!is_free(v)) {
      // Along the perpendicular: what is left has the norm cosh^2 of the distance.
      place[2] = 0;
      place /= std::sqrt(-lorentz_product(place, place));
    }
    base_[v] = place.head<3>();
    frames_[v] = planes_[v] * geometry::boost(base_[v]);
  }
}

void HarmonicEnergy::recentre(std::span<const double> x) {
  for (std::size_t v = 0; v < point_count(); ++v) {
    Vector4 u = Vector4::Zero();
    for (std::size_t k = 0; k < width(v); ++k) u[static_cast<Eigen::Index>(k)] = x[first_[v] + k];
    u[3] = std::sqrt(1 + u.squaredNorm());
    base_[v] = (geometry::boost(base_[v]) * u).head<3>();
    if (!is_free(v)) base_[v][2] = 0;
    frames_[v] = planes_[v] * geometry::boost(base_[v]);
  }
}

}  // namespace tripus::energies
