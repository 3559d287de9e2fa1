#pragma once

#include "studies/study.hpp"

namespace tripus::studies::detail {

Plan plan_convergence(const StudyOptions& options);
Plan plan_triangulations(const StudyOptions& options);
Plan plan_stability(const StudyOptions& options);
Plan plan_paper(const StudyOptions& options);
Plan plan_valence(const StudyOptions& options);

/// Tables of the stability study, in this order.
enum StabilityTable : std::size_t { kThresholds, kAngles, kStarts, kIrregular, kFlowThresholds };

/// What the tables of a stability study say.
Findings stability_findings(const std::vector<Table>& tables);

/// What the one table of a triangulations study says.
Findings triangulations_findings(const std::vector<Table>& tables);

/// Tables of the study of the paper's experiment, in this order.
enum PaperTable : std::size_t { kTriangulations };

/// What is known of a manifold, from the triangulations that belong to it.
struct StudiedManifold {
  std::string signature;  ///< isometry signature: equal exactly for the same manifold
  std::string input;      ///< the first of its triangulations
  double volume = 0;
  std::string boundary, homology, cells, isometries;
  std::size_t triangulations = 0;
  std::size_t geometric = 0;  ///< triangulations that carry the metric themselves
};

/// By volume, then by signature.
std::vector<StudiedManifold> manifolds_of(const Table& triangulations);

/// Manifolds of one volume, as far as doubles can tell.
using VolumeGroup = std::vector<StudiedManifold>;
std::vector<VolumeGroup> volume_groups(const std::vector<StudiedManifold>& manifolds);

/// Manifolds of the group with the boundary and homology of m, m included.
std::size_t of_same_kind(const VolumeGroup& group, const StudiedManifold& m);

/// The tables manifolds.csv and same_volume.csv.
std::vector<Table> manifold_tables(const std::vector<StudiedManifold>& manifolds,
                                   const std::vector<VolumeGroup>& groups);

/// What they say.
Findings paper_findings(const std::vector<Table>& tables);

/// Tables of the convergence study, in this order.
enum ConvergenceTable : std::size_t { kRuns, kIterations, kTheory };

std::vector<TableLayout> convergence_layouts();

/// What the tables of a convergence study say.
Findings convergence_findings(const std::vector<Table>& tables);

}  // namespace tripus::studies::detail
