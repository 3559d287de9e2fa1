#include "structure/solve_all.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "base/stop.hpp"
#include "structure/detail/lane_newton.hpp"
#include "structure/solve.hpp"

namespace tripus::structure {
namespace {

using detail::LaneNewton;
using detail::LaneResult;

class Batch {
 public:
  Batch(std::span<const topology::Triangulation> triangulations, const Stop& stop)
      : triangulations_(triangulations), stop_(stop) {
    const std::size_t n = triangulations.size();
    solutions_.outcomes.assign(n, Outcome::kUnresolved);
    solutions_.iterations.assign(n, 0);
    solutions_.volumes.assign(n, 0);
    solutions_.max_curvature.assign(n, 0);
    solutions_.edge_start.reserve(n + 1);
    solutions_.tetrahedron_start.reserve(n + 1);
    std::size_t edges = 0, tetrahedra = 0;
    for (const topology::Triangulation& each : triangulations) {
      solutions_.edge_start.push_back(edges);
      solutions_.tetrahedron_start.push_back(tetrahedra);
      edges += each.edge_count();
      tetrahedra += each.tetrahedron_count();
    }
    solutions_.edge_start.push_back(edges);
    solutions_.tetrahedron_start.push_back(tetrahedra);
    solutions_.edge_lengths.assign(edges, 0);
    solutions_.dihedral_angles.assign(tetrahedra, {});
  }

  Solutions solve() && {
    for (std::size_t k = 0; k < triangulations_.size() && !stopped(); ++k) {
      if (!LaneNewton::takes(triangulations_[k])) {
        solve_one(k);
        continue;
      }
      newton_of(triangulations_[k]).add(triangulations_[k], k);
    }
    for (auto& row : newtons_)
      for (auto& newton : row)
        if (newton && !stopped()) newton->finish();
    return std::move(solutions_);
  }

 private:
  bool stopped() const { return stop_.requested(); }

  LaneNewton& newton_of(const topology::Triangulation& triangulation) {
    auto& newton = newtons_[triangulation.tetrahedron_count()][triangulation.edge_count()];
    if (!newton)
      newton = std::make_unique<LaneNewton>(triangulation,
                                            [this](const LaneResult& result) { take(result); });
    return *newton;
  }

  void take(const LaneResult& result) {
    const std::size_t k = result.number;
    if (!result.found) {
      if (!stopped()) solve_one(k);
      return;
    }
    solutions_.outcomes[k] = Outcome::kGeometric;
    solutions_.iterations[k] = result.iterations;
    solutions_.volumes[k] = result.volume;
    solutions_.max_curvature[k] = result.max_curvature;
    double* length = &solutions_.edge_lengths[solutions_.edge_start[k]];
    for (std::size_t e = 0; e < triangulations_[k].edge_count(); ++e)
      length[e] = result.length[LaneNewton::kLanes * e];
    auto* angles = &solutions_.dihedral_angles[solutions_.tetrahedron_start[k]];
    for (std::size_t t = 0; t < triangulations_[k].tetrahedron_count(); ++t)
      for (std::size_t e = 0; e < 6; ++e)
        angles[t][e] = result.angle[LaneNewton::kLanes * (6 * t + e)];
  }

  void solve_one(std::size_t k) {
    SolveOptions options;
    options.stop = stop_;
    Report report = structure::solve(triangulations_[k], options);
    if (report.termination == solver::Termination::kInterrupted) return;
    solutions_.outcomes[k] = report.outcome;
    solutions_.iterations[k] = report.iterations;
    solutions_.volumes[k] = report.volume;
    solutions_.max_curvature[k] = report.max_curvature;
    const auto place = [](auto& all, std::size_t at) {
      return all.begin() + static_cast<std::ptrdiff_t>(at);
    };
    std::ranges::copy(report.edge_lengths,
                      place(solutions_.edge_lengths, solutions_.edge_start[k]));
    std::ranges::copy(report.dihedral_angles,
                      place(solutions_.dihedral_angles, solutions_.tetrahedron_start[k]));
    solutions_.reports.emplace(k, std::move(report));
  }

  std::span<const topology::Triangulation> triangulations_;
  Stop stop_;
  Solutions solutions_;
  std::array<std::array<std::unique_ptr<LaneNewton>, LaneNewton::kMostEdges + 1>,
             LaneNewton::kMostTetrahedra + 1>
      newtons_;  // by tetrahedra, edge classes
};

}  // namespace

Solutions solve_all(std::span<const topology::Triangulation> triangulations, const Stop& stop) {
  return Batch(triangulations, stop).solve();
}

}  // namespace tripus::structure
