#pragma once

#include <optional>
#include <vector>

#include "structure/report.hpp"
#include "topology/cone_angle.hpp"
#include "topology/moves/moves.hpp"
#include "topology/triangulation.hpp"

/// Moves under which lengths stay, so that whether a triangulation carries the metric that another
/// one carries needs no solver.
namespace tripus::canonical::detail {

/// A triangulation on the way to the canonical one, with the metric or without.
struct MetricState {
  topology::Triangulation triangulation;
  structure::Report report;
  std::vector<topology::Move> path;
  std::vector<topology::ConeAngle> cone_angles;  ///< [E]; empty if there are no labels
  /// Whether lengths and angles of the report are those of the metric: where the report is
  /// geometric, or else with flat tetrahedra, which it lists.
  bool has_metric = false;
};

/// The state after a move, and where the metric before it was known: the lengths [E] that the
/// edges have in it, the new one included. Empty if it has none.
struct CarriedMetric {
  MetricState state;
  std::vector<double> lengths;
};

/// Not solved; nothing if the move is not legal, or takes a labelled edge away.
std::optional<CarriedMetric> carried_metric(const MetricState& from, const topology::Move& move);

/// Whether the metric, which was known before the move, is one after it: true tetrahedra.
bool has_true_tetrahedra(const CarriedMetric& next);

/// The same with up to `most` flat tetrahedra, whose vertices lie in one plane: fills lengths,
/// angles and flat_tetrahedra of the report. False if there are more, or one is turned over.
bool lay_out_flat(CarriedMetric& next, std::size_t most);

}  // namespace tripus::canonical::detail
