#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "base/context.hpp"
#include "embedding/holonomy.hpp"
#include "embedding/tessellate.hpp"
#include "embedding/universal_cover.hpp"
#include "structure/proof/proof.hpp"
#include "structure/report.hpp"
#include "topology/cone_angle.hpp"
#include "topology/triangulation.hpp"

namespace tripus {

/// What a file of cells is to be like.
struct CellFileOptions {
  embedding::Model model = embedding::Model::kPoincareBall;
  double error = 1e-2;  ///< see embedding::TessellationOptions
};

/// Cells of the universal cover, nearest to the first tetrahedron first.
class CellComplex {
 public:
  CellComplex(std::shared_ptr<const embedding::Embedding> embedding,
              embedding::UniversalCover cover)
      : embedding_(std::move(embedding)), cover_(std::move(cover)) {}

  std::span<const embedding::Cell> cells() const { return cover_.cells; }
  embedding::CoverEnd end() const { return cover_.end; }
  const embedding::Embedding& embedding() const { return *embedding_; }

  /// Writes the cells as closed surfaces; the ending of the name says how: .obj, .ply, .vtk and
  /// what else embedding::mesh_formats lists. The file is whole or, after an error, not touched.
  /// Returns how many cells were written: fewer than there are after a stop.
  /// Throws InvalidInput for another ending, an error that is not positive, and a place that cannot
  /// be written to; IoError if writing fails.
  std::size_t write(const std::string& path, const CellFileOptions& options = {},
                    const Context& context = {}) const;

 private:
  std::shared_ptr<const embedding::Embedding> embedding_;
  embedding::UniversalCover cover_;
};

/// The hyperbolic metric with geodesic boundary that a triangulation carries.
/// Made by Manifold::metric; safe to share between threads; lives as long as that Manifold or a
/// copy of it. Source of all numbers: docs/theory.md.
class Metric {
 public:
  /// All must outlive the metric; the report is geometric, of this triangulation with these cone
  /// angles (empty: 2 pi everywhere).
  Metric(const topology::Triangulation& triangulation, const structure::Report& report,
         std::span<const topology::ConeAngle> cone_angles = {})
      : triangulation_(triangulation), report_(report), cone_angles_(cone_angles) {}

  /// Hyperbolic volume, curvature -1.
  double volume() const { return report_.volume; }
  /// [E] lengths of the edge classes between the truncating planes, > 0.
  std::span<const double> edge_lengths() const { return report_.edge_lengths; }
  /// [T x 6] radians, in (0, pi), at the edges 01 02 03 12 13 23.
  std::span<const std::array<double, 6>> dihedral_angles() const { return report_.dihedral_angles; }
  /// [V] the boundary components: genus and area.
  std::span<const structure::VertexReport> boundary() const { return report_.vertices; }
  /// max|K|: how far the angles around an edge are from its cone angle at most.
  double max_curvature() const { return report_.max_curvature; }
  /// How it was found.
  const structure::Report& report() const { return report_; }

  /// A proof that this is the metric, every rounding accounted for, anew at each call: intervals of
  /// the lengths and the volume, or the reason why not: also where a vertex is finite.
  /// docs/proof.md.
  structure::Proof prove(const Context& context = {}) const;

  // Places in hyperbolic space. There is a universal cover where every cone angle is 2 pi / n or 0;
  // Unsupported elsewhere.

  /// The tetrahedra in the hyperboloid model and the isometries that glue them; made once.
  const embedding::Embedding& embedding() const { return *shared_embedding(); }
  /// Generators of the fundamental group as isometries.
  embedding::Holonomy holonomy() const;
  /// The first `cells` cells of the universal cover (1 to embedding::kMostCells).
  /// Throws InvalidInput for other numbers. A stop leaves the cells so far.
  CellComplex universal_cover(std::size_t cells, const Context& context = {}) const;
  /// The same with a bound on depth or radius.
  CellComplex universal_cover(embedding::UniversalCoverOptions options,
                              const Context& context = {}) const;
  /// Each tetrahedron once.
  CellComplex fundamental_domain() const;

 private:
  std::shared_ptr<const embedding::Embedding> shared_embedding() const;

  const topology::Triangulation& triangulation_;
  const structure::Report& report_;
  const std::span<const topology::ConeAngle> cone_angles_;
  mutable std::once_flag placed_;
  mutable std::shared_ptr<const embedding::Embedding> embedding_;
};

}  // namespace tripus
