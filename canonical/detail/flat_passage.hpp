#pragma once

#include <cstddef>
#include <functional>

#include "base/stop.hpp"
#include "canonical/detail/carried_metric.hpp"
#include "canonical/tilts.hpp"

namespace tripus::canonical::detail {

/// From where moves at concave faces get stuck because vertices of several tetrahedra lie in one
/// plane: breadth first through triangulations with up to three flat tetrahedra in that plane, of
/// volume 0, by moves at these. Lengths are carried, nothing is solved.
///   stuck    geometric
///   faces    of it
///   attempt  is given triangulations with true tetrahedra only, lengths filled in; returns whether
///            the search is over
///   budget   triangulations that may be looked at; lowered by those that were
/// Returns whether it was; false if there is nothing left to go through, or not within the budget
/// or before a stop.
bool pass_through_planes(const MetricState& stuck, const FaceKinds& faces,
                         const std::function<bool(CarriedMetric&)>& attempt, const Stop& stop,
                         std::size_t& budget);

}  // namespace tripus::canonical::detail
