#pragma once

#include <span>
#include <string>
#include <vector>

#include "energies/co_volume.hpp"
#include "solver/method.hpp"
#include "structure/report.hpp"
#include "studies/study.hpp"
#include "topology/triangulation.hpp"

namespace tripus::studies::detail {

/// A point that a method passed through.
struct TracePoint {
  int iteration = 0;
  int evaluations = 0;
  double seconds = 0;
  double max_gradient = 0;
  double time = 0;              ///< flow time
  std::vector<double> lengths;  ///< [E]
};

/// One run of one method by itself, from lengths that are given: no second method settles what the
/// first did not find.
struct MethodRun {
  structure::Report report;
  std::vector<TracePoint> trace;  ///< empty unless asked for
};

struct MethodRunOptions {
  double tolerance = 1e-12;
  int max_iterations = 0;
  /// Keep every iterate up to the 100th, then those 2 % apart.
  bool trace = false;
  Stop stop{};  ///< polled at every iteration
};

/// The name is one of structure::solve_method_names.
MethodRun run_method(const topology::Triangulation& triangulation, const std::string& method,
                     std::span<const double> start, const MethodRunOptions& options);

/// max|K| and sum K^2 and H and the volume at lengths [E].
struct Measures {
  double max_curvature = 0;
  double sum_squared_curvature = 0;
  double energy = 0;
  double volume = 0;
};
Measures measure(const energies::CoVolume& energy, std::span<const double> lengths);

/// The metric's lengths by Newton's method from the default start.
/// Throws InvalidInput, naming the input, if the triangulation cannot be solved or carries none.
structure::Report require_metric(const topology::Triangulation& triangulation,
                                 const std::string& name);

}  // namespace tripus::studies::detail
