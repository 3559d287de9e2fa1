#include "canonical/tilts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/tolerances.hpp"
#include "canonical/detail/precise.hpp"
#include "canonical/detail/tetrahedron_tilts.hpp"

namespace tripus::canonical {
namespace {

using topology::Triangulation;

/// [T x 4] tilts of every face of every tetrahedron.
std::vector<std::array<double, 4>> all_tilts(const Triangulation& triangulation,
                                             std::span<const double> lengths) {
  std::vector<std::array<double, 4>> result(triangulation.tetrahedron_count());
  for (std::size_t t = 0; t < result.size(); ++t) {
    std::array<double, 6> l;
    for (int e = 0; e < 6; ++e)
      l[static_cast<std::size_t>(e)] = lengths[triangulation.edge_class(t, e)];
    result[t] = tilts(l);
  }
  return result;
}

/// The faces once each, from the side with the smaller (tetrahedron, face).
std::vector<detail::FacePlace> faces_once(const topology::Gluings& gluings) {
  std::vector<detail::FacePlace> result;
  for (std::size_t t = 0; t < gluings.tetrahedron_count(); ++t) {
    for (int f = 0; f < 4; ++f) {
      const std::size_t other = gluings.neighbour(t, f);
      if (other > t || (other == t && gluings.gluing(t, f)(f) > f)) result.push_back({t, f});
    }
  }
  return result;
}

/// Sets an entry of [T x 4] on both sides of a face.
template <class Value>
void set_both(const topology::Gluings& gluings, const detail::FacePlace& place, Value value,
              std::vector<std::array<Value, 4>>& table) {
  const auto [t, f] = place;
  table[t][static_cast<std::size_t>(f)] = value;
  table[gluings.neighbour(t, f)][static_cast<std::size_t>(gluings.gluing(t, f)(f))] = value;
}

FaceKind kind_of(double sum, double zero) {
  if (std::fabs(sum) <= zero) return FaceKind::kTransparent;
  return sum < 0 ? FaceKind::kTrue : FaceKind::kConcave;
}

}  // namespace

std::array<double, 4> tilts(std::span<const double, 6> l) {
  std::array<double, 6> a;
  for (std::size_t e = 0; e < 6; ++e) a[e] = std::cosh(l[e]);
  return detail::tetrahedron_tilts(detail::cofactors(a));
}

bool FaceKinds::has_concave() const {
  return std::ranges::any_of(kind, [](const auto& faces) {
    return std::ranges::find(faces, FaceKind::kConcave) != faces.end();
  });
}

FaceKinds face_kinds(const Triangulation& triangulation, std::span<const double> lengths) {
  const topology::Gluings& gluings = triangulation.gluings();
  const auto tilt = all_tilts(triangulation, lengths);
  FaceKinds result;
  result.kind.resize(tilt.size());
  result.sum.resize(tilt.size());
  result.margin = std::numeric_limits<double>::infinity();
  std::vector<detail::FacePlace> doubtful;
  const auto settle = [&](const detail::FacePlace& place, double sum, double zero) {
    const FaceKind kind = kind_of(sum, zero);
    set_both(gluings, place, kind, result.kind);
    double& extreme = kind == FaceKind::kTransparent ? result.largest_zero : result.margin;
    extreme = kind == FaceKind::kTransparent ? std::max(extreme, std::fabs(sum))
                                             : std::min(extreme, std::fabs(sum));
  };
  for (const detail::FacePlace& place : faces_once(gluings)) {
    const auto [t, f] = place;
    const double here = tilt[t][static_cast<std::size_t>(f)];
    const double there =
        tilt[gluings.neighbour(t, f)][static_cast<std::size_t>(gluings.gluing(t, f)(f))];
    set_both(gluings, place, here + there, result.sum);
    const double doubt =
        tolerance::kTiltDoubt * std::max(1.0, std::max(std::fabs(here), std::fabs(there)));
    if (std::fabs(here + there) <= doubt) {
      doubtful.push_back(place);
      set_both(gluings, place, FaceKind::kTransparent, result.kind);
    } else {
      settle(place, here + there, doubt);
    }
  }
  if (doubtful.empty() || result.has_concave()) return result;
  result.precise = true;
  const auto sums = detail::precise_tilt_sums(triangulation, lengths, doubtful);
  for (std::size_t k = 0; k < sums.size(); ++k)
    settle(doubtful[k], sums[k], tolerance::kPreciseTiltZero);
  return result;
}

}  // namespace tripus::canonical
