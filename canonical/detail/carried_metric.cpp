#include "canonical/detail/carried_metric.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/tolerances.hpp"
#include "canonical/detail/precise.hpp"
#include "energies/co_volume.hpp"
#include "topology/moves/edge_images.hpp"

namespace tripus::canonical::detail {
namespace {

using topology::Move;
using topology::Triangulation;

/// A tetrahedron with an angle so close to pi is not made on the way: where four vertices lie in
/// one plane, rounding can make one of volume 0 look true.
constexpr double kNearlyFlat = 1e-4;
/// An angle this close to 0 or pi is taken for one of four points in a plane.
constexpr double kInPlane = 1e-6;

/// The length of an edge of one tetrahedron from the others and the dihedral angle opposite it;
/// nothing if there is none. That angle's cosine is a linear function of the Gram entry:
/// docs/theory.md (10).
std::optional<double> length_across(const std::array<double, 6>& l, const detail::Diagonal& d,
                                    int edge, double angle) {
  const auto [a, b] = topology::kEdgeEnds[static_cast<std::size_t>(edge)];
  const auto& ends = topology::kEdgeEnds[static_cast<std::size_t>(5 - edge)];
  const int i = ends[0], j = ends[1];
  const auto kind = [&](int v) { return d[static_cast<std::size_t>(v)]; };
  const auto gram = [&](int v, int w) {
    const int e = topology::kEdgeNumber[static_cast<std::size_t>(v)][static_cast<std::size_t>(w)];
    return detail::minus_gram(l[static_cast<std::size_t>(e)], kind(v), kind(w));
  };
  const double slope2 = detail::squared_slope(gram(i, j), kind(i), kind(j));
  // Of the face ij and one more vertex, p of docs/theory.md (7).
  const auto face = [&](int v) {
    return kind(v) * slope2 + kind(j) * gram(i, v) * gram(i, v) +
           kind(i) * gram(j, v) * gram(j, v) + 2 * gram(i, j) * gram(i, v) * gram(j, v);
  };
  const double product = kind(j) * gram(i, a) * gram(i, b) + kind(i) * gram(j, a) * gram(j, b) +
                         gram(i, j) * (gram(i, a) * gram(j, b) + gram(i, b) * gram(j, a));
  const double entry = (product - std::cos(angle) * std::sqrt(face(a) * face(b))) / slope2;
  const bool hyperideal = kind(a) != 0 && kind(b) != 0;
  if (!(entry > (hyperideal ? 1 : 0))) return std::nullopt;
  if (hyperideal) return std::acosh(entry);
  return std::log(kind(a) == kind(b) ? entry / 2 : entry);
}

/// Sets the length of the new edge; false if it has none, as its ends are on the wrong sides.
bool measure(const MetricState& from, const topology::NewDiagonal& diagonal, CarriedMetric& next) {
  const MetricState& state = next.state;
  const std::size_t t = diagonal.tetrahedron;
  double angle = 0;
  for (const auto& [tetrahedron, edge] : diagonal.corners)
    angle += from.report.dihedral_angles[tetrahedron][static_cast<std::size_t>(edge)];
  std::array<double, 6> l;
  for (int e = 0; e < 6; ++e)
    l[static_cast<std::size_t>(e)] = next.lengths[state.triangulation.edge_class(t, e)];
  const auto of_vertices = diagonals(state.triangulation, state.cone_angles);
  const auto length = length_across(l, of_vertices[t], diagonal.edge, angle);
  if (!length) return false;
  next.lengths[state.triangulation.edge_class(t, diagonal.edge)] = *length;
  return true;
}

bool fits(std::span<const double> curvature) {
  return std::ranges::all_of(curvature,
                             [](double K) { return std::fabs(K) < tolerance::kFlatAngleMargin; });
}

}  // namespace

std::optional<CarriedMetric> carried_metric(const MetricState& from, const Move& move) {
  topology::Gluings gluings = from.triangulation.gluings();
  if (!topology::can_apply(gluings, move)) return std::nullopt;
  const topology::MoveChange change = topology::apply(gluings, move);
  CarriedMetric next{{Triangulation(std::move(gluings)), {}, from.path, {}, false}, {}};
  MetricState& state = next.state;
  state.path.push_back(move);
  const std::vector<std::uint32_t> images =
      topology::edge_images(from.triangulation, move, change, state.triangulation);
  auto labels =
      topology::carried_labels(from.cone_angles, images, state.triangulation.edge_count());
  if (!labels) return std::nullopt;
  state.cone_angles = std::move(*labels);
  if (from.has_metric) {
    next.lengths.resize(state.triangulation.edge_count());
    for (std::size_t e = 0; e < images.size(); ++e)
      if (images[e] != topology::kNoEdge) next.lengths[images[e]] = from.report.edge_lengths[e];
    const auto diagonal = topology::new_diagonal(from.triangulation, move, change);
    if (diagonal && !measure(from, *diagonal, next)) next.lengths.clear();
  }
  return next;
}

bool has_true_tetrahedra(const CarriedMetric& next) {
  if (next.lengths.empty()) return false;
  const energies::CoVolume energy(next.state.triangulation, next.state.cone_angles);
  const auto at = energy.at(next.lengths);
  if (!at.is_defined() || at.flat_count() > 0) return false;
  for (std::size_t t = 0; t < next.state.triangulation.tetrahedron_count(); ++t)
    if (std::ranges::max(at.dihedral_angles(t)) > std::numbers::pi - kNearlyFlat) return false;
  return fits(at.gradient());
}

bool lay_out_flat(CarriedMetric& next, std::size_t most) {
  if (next.lengths.empty()) return false;
  MetricState& state = next.state;
  const energies::CoVolume energy(state.triangulation, state.cone_angles);
  const auto at = energy.at(next.lengths);
  if (!at.is_defined() || !fits(at.gradient())) return false;
  state.report = {};
  for (std::size_t t = 0; t < state.triangulation.tetrahedron_count(); ++t) {
    state.report.dihedral_angles.push_back(at.dihedral_angles(t));
    const double largest = std::ranges::max(state.report.dihedral_angles.back());
    if (largest <= std::numbers::pi - kNearlyFlat) continue;
    if (largest < std::numbers::pi - kInPlane) return false;
    state.report.flat_tetrahedra.push_back(t);
    if (state.report.flat_tetrahedra.size() > most) return false;
  }
  state.report.edge_lengths = next.lengths;
  state.has_metric = true;
  return true;
}

}  // namespace tripus::canonical::detail
