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
std::vector<std::array<Tilt, 4>> all_tilts(const Triangulation& triangulation,
                                           std::span<const double> lengths,
                                           std::span<const detail::Diagonal> diagonals) {
  std::vector<std::array<Tilt, 4>> result(triangulation.tetrahedron_count());
  for (std::size_t t = 0; t < result.size(); ++t) {
    std::array<double, 6> l;
    for (int e = 0; e < 6; ++e)
      l[static_cast<std::size_t>(e)] = lengths[triangulation.edge_class(t, e)];
    result[t] = mixed_tilts(l, diagonals[t]);
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
  const std::array<int, 4> hyperideal{1, 1, 1, 1};
  std::array<double, 4> result;
  const auto terms = mixed_tilts(l, hyperideal);
  for (std::size_t f = 0; f < 4; ++f) result[f] = terms[f].geodesic;
  return result;
}

std::array<Tilt, 4> mixed_tilts(std::span<const double, 6> l, std::span<const int, 4> diagonal) {
  detail::Diagonal d;
  std::ranges::copy(diagonal, d.begin());
  std::array<double, 6> a;
  for (std::size_t e = 0; e < 6; ++e) {
    const auto ends = topology::kEdgeEnds[e];
    a[e] = detail::minus_gram(l[e], d[static_cast<std::size_t>(ends[0])],
                              d[static_cast<std::size_t>(ends[1])]);
  }
  std::array<Tilt, 4> result;
  const auto terms = detail::tetrahedron_tilts(detail::cofactors(a, d), d);
  for (std::size_t f = 0; f < 4; ++f) result[f] = {terms[f].geodesic, terms[f].cusp};
  return result;
}

bool FaceKinds::has_concave() const {
  return std::ranges::any_of(kind, [](const auto& faces) {
    return std::ranges::find(faces, FaceKind::kConcave) != faces.end();
  });
}

namespace {

/// Decides about the faces one by one.
class FaceSorter {
 public:
  FaceSorter(const Triangulation& triangulation, std::span<const double> lengths,
             std::span<const topology::ConeAngle> cone_angles)
      : triangulation_(triangulation),
        lengths_(lengths),
        cone_angles_(cone_angles),
        diagonals_(detail::diagonals(triangulation, cone_angles)),
        tilt_(all_tilts(triangulation, lengths, diagonals_)) {
    result_.kind.resize(tilt_.size());
    result_.sum.resize(tilt_.size());
    result_.margin = std::numeric_limits<double>::infinity();
  }

  FaceKinds run() {
    for (const detail::FacePlace& place : faces_once(triangulation_.gluings())) in_doubles(place);
    if (!doubtful_.empty() && !result_.has_concave()) precisely();
    return std::move(result_);
  }

 private:
  void in_doubles(const detail::FacePlace& place) {
    const auto [t, f] = place;
    const topology::Gluings& gluings = triangulation_.gluings();
    const std::size_t other = gluings.neighbour(t, f);
    const Tilt& here = tilt_[t][static_cast<std::size_t>(f)];
    const Tilt& there = tilt_[other][static_cast<std::size_t>(gluings.gluing(t, f)(f))];
    // Without hyperideal vertices on both sides the geodesic terms are 0 by definition.
    const bool cusps_only = diagonals_[t] == kIdeal && diagonals_[other] == kIdeal;
    const double x = cusps_only ? here.cusp : here.geodesic;
    const double y = cusps_only ? there.cusp : there.geodesic;
    const double sum = x + y;
    set_both(gluings, place, sum, result_.sum);
    const double doubt = tolerance::kTiltDoubt * std::max({1.0, std::fabs(x), std::fabs(y)});
    if (std::fabs(sum) <= doubt) {
      doubtful_.push_back(place);
      set_both(gluings, place, FaceKind::kTransparent, result_.kind);
    } else {
      settle(place, sum, doubt);
    }
  }

  void precisely() {
    result_.precise = true;
    const auto sums =
        detail::precise_tilt_sums(triangulation_, lengths_, cone_angles_, diagonals_, doubtful_);
    for (std::size_t k = 0; k < sums.size(); ++k) {
      if (std::fabs(sums[k].geodesic) > tolerance::kPreciseTiltZero) {
        settle(doubtful_[k], sums[k].geodesic, tolerance::kPreciseTiltZero);
        continue;
      }
      result_.largest_zero = std::max(result_.largest_zero, std::fabs(sums[k].geodesic));
      settle(doubtful_[k], sums[k].cusp, tolerance::kPreciseTiltZero);
    }
  }

  void settle(const detail::FacePlace& place, double sum, double zero) {
    const FaceKind kind = kind_of(sum, zero);
    const double size = std::fabs(sum);
    set_both(triangulation_.gluings(), place, kind, result_.kind);
    if (kind == FaceKind::kTransparent) {
      result_.largest_zero = std::max(result_.largest_zero, size);
    } else {
      result_.margin = std::min(result_.margin, size);
    }
    // The greatest concave face is changed first; what is nearly flat comes last.
    set_both(triangulation_.gluings(), place, sum, result_.sum);
  }

  static constexpr detail::Diagonal kIdeal{0, 0, 0, 0};

  const Triangulation& triangulation_;
  std::span<const double> lengths_;
  std::span<const topology::ConeAngle> cone_angles_;
  std::vector<detail::Diagonal> diagonals_;  // [T]
  std::vector<std::array<Tilt, 4>> tilt_;    // [T]
  std::vector<detail::FacePlace> doubtful_;
  FaceKinds result_;
};

}  // namespace

FaceKinds face_kinds(const Triangulation& triangulation, std::span<const double> lengths,
                     std::span<const topology::ConeAngle> cone_angles) {
  return FaceSorter(triangulation, lengths, cone_angles).run();
}

}  // namespace tripus::canonical
