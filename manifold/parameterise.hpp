#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "base/context.hpp"
#include "parameterise/harmonic_map.hpp"
#include "parameterise/quality.hpp"

namespace tripus {

struct ParameteriseOptions {
  parameterise::MarkOptions marking = {};
  parameterise::Weights weights = parameterise::Weights::kFiniteElements;
  parameterise::MapOptions map = {};
  /// Refine the mesh where the map stretches it, until it has so many tetrahedra; 0: leave it. A
  /// surface is filled with a quarter of them first, unless marking.tetrahedralize says otherwise.
  std::size_t refine = 0;
};

/// The harmonic map of a solid in space onto its hyperbolic manifold, with what is known about it.
class Parameterisation {
 public:
  /// Throws InvalidInput for a solid whose boundary has only spheres; Unsupported for a torus in
  /// the boundary and where no metric is found; Stopped before there is a marking; and what reading
  /// and filling a mesh throws. A stop later leaves the map so far.
  Parameterisation(meshing::MeshFile file, std::string label, const ParameteriseOptions& options,
                   const Context& context = {});

  const parameterise::MarkedSolid& solid() const { return *solid_; }
  const parameterise::HarmonicMap& map() const { return map_; }
  const parameterise::Quality& quality() const { return quality_; }
  std::size_t edge_count() const { return edge_count_; }
  std::size_t clipped_weights() const { return clipped_; }
  double relator_defect() const { return relator_defect_; }
  double equivariance_defect() const { return equivariance_defect_; }
  bool converged() const { return map_.termination == solver::Termination::kConverged; }

  /// What to do where no minimum was found, nor a limit or a stop is to blame; else empty.
  std::string advice() const;

  std::string to_vtu() const;
  /// A page for a browser.
  std::string to_page() const;
  /// The solid cut open, as SVG.
  std::string to_svg(double cut_away = 0.5) const;
  /// One object, without the map.
  std::string to_json() const;

 private:
  std::string label_;
  parameterise::Weights weights_;
  std::unique_ptr<parameterise::MarkedSolid> solid_;
  parameterise::HarmonicMap map_;
  parameterise::Quality quality_;
  std::size_t edge_count_ = 0, clipped_ = 0;
  double relator_defect_ = 0, equivariance_defect_ = 0;
};

/// Of a surface or a tetrahedral mesh in a file, or in standard input for "-". Errors name it.
Parameterisation parameterise_solid(const std::string& input,
                                    const ParameteriseOptions& options = {},
                                    const Context& context = {});

}  // namespace tripus
