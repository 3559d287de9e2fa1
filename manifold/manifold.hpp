#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/context.hpp"
#include "canonical/canonize.hpp"
#include "canonical/census.hpp"
#include "canonical/compare.hpp"
#include "manifold/metric.hpp"
#include "structure/retriangulate.hpp"
#include "structure/solve.hpp"
#include "topology/covers/covers.hpp"
#include "topology/covers/presentation.hpp"
#include "topology/formats/formats.hpp"
#include "topology/homology.hpp"
#include "topology/simplify/simplify.hpp"
#include "topology/triangulation.hpp"

namespace tripus {

/// A compact 3-manifold with a triangulation: the front door of the library.
///
/// A value: cheap to copy, copies share what was computed, and any number of threads may use one at
/// once. Nothing is computed before it is first asked for, and then once; what a stop cut short is
/// not kept. Mathematical answers are returned, never thrown.
class Manifold {
 public:
  /// Throws InvalidInput as the constructor of topology::Triangulation does.
  explicit Manifold(topology::Gluings gluings, std::string name = {});
  explicit Manifold(topology::Triangulation triangulation, std::string name = {});
  /// What was read elsewhere, with what it was read from: the manifold is then as `load` gives it.
  /// Throws InvalidInput as topology::completed for its cone angles.
  explicit Manifold(topology::NamedGluings loaded, std::string input = {});
  /// The same triangulation with these cone angles [E] around its edge classes; empty for 2 pi
  /// everywhere. Its metric, its canonical decomposition and what follows from them are then those
  /// of the cone manifold; the topology is that of the space without its labels.
  /// Throws InvalidInput as topology::completed.
  Manifold with_cone_angles(std::vector<topology::ConeAngle> cone_angles) const;

  const std::string& name() const;  ///< from the file or the caller; may be empty
  /// What `load` was given, or the name, or the signature; the "input" of the JSON.
  std::string label() const;
  const std::string& input() const;  ///< what `load` was given; may be empty
  /// Whether the labels mean an orientation; a signature without a sign says nothing about it.
  bool is_orientation_known() const;
  /// [E] the cone angles around the edge classes; empty if nothing is labelled.
  std::span<const topology::ConeAngle> cone_angles() const;

  // Topology: of any triangulation.

  const topology::Triangulation& triangulation() const;
  std::size_t tetrahedron_count() const { return triangulation().tetrahedron_count(); }
  bool is_orientable() const { return triangulation().is_orientable(); }
  /// [V] the links of the vertices: the boundary components and cusps.
  std::vector<topology::VertexLink> links() const;
  /// The isomorphism signature, Regina's; nothing where it would take too long.
  const std::optional<std::string>& signature() const;
  /// The signature with its sign, which keeps the orientation; nothing where the orientation is not
  /// known, and for triangulations that are not connected or not orientable.
  std::optional<std::string> oriented_signature() const;
  /// Throws Stopped.
  const topology::AbelianGroup& homology(const Context& context = {}) const;
  topology::FundamentalGroup fundamental_group() const;
  /// The same manifold with as few tetrahedra as were found. Throws Unsupported for cone angles
  /// other than 2 pi.
  Manifold simplified(const topology::SimplifyOptions& options = {},
                      const Context& context = {}) const;
  /// What is left without neighbourhoods of these edge classes, simplified: topology/drill.hpp.
  /// Throws InvalidInput for a number that no edge class has, or that comes twice, and for a cone
  /// angle of an edge that stays.
  Manifold drilled(const std::vector<std::size_t>& edges,
                   const topology::SimplifyOptions& options = {},
                   const Context& context = {}) const;
  /// The connected covers with so many sheets, one of each isomorphism class, with the cone angles
  /// of what lies below: nothing is branched. A stop leaves those found so far. Throws InvalidInput
  /// as topology::for_each_cover does.
  std::vector<Manifold> covers(std::size_t degree, const Context& context = {}) const;
  std::vector<Manifold> cyclic_covers(std::size_t degree, const Context& context = {}) const;
  /// The connected cover on whose sheets the generators of `fundamental_group` act by these
  /// permutations. Throws InvalidInput as topology::cover_of_permutations does; Stopped.
  Manifold cover(const std::vector<std::vector<std::uint32_t>>& permutations,
                 const Context& context = {}) const;

  // The metric on this triangulation.

  /// The metric, solved for when first asked; null if this triangulation carries none or that is
  /// not known: `verdict` says which. Throws InvalidInput as structure::solve does.
  const Metric* metric(const Context& context = {}) const;
  /// What was found about this triangulation, with the evidence: certificate, flat tetrahedra.
  const structure::Report& verdict(const Context& context = {}) const;
  /// Other starts, methods, cone angles: solved anew at each call. Without cone angles in the
  /// options those of the manifold are taken.
  structure::Report solve(structure::SolveOptions options, const Context& context = {}) const;
  /// A triangulation of this manifold that carries the metric: this one or one that moves lead to.
  /// Where none is found, `verdict` of the result says what was tried.
  Manifold retriangulated(const structure::RetriangulateOptions& options = {},
                          const Context& context = {}) const;

  // The manifold, whatever its triangulation; by the canonical decomposition.

  /// The canonical decomposition with isometry group and signature, or why not.
  const canonical::CanonizeAnswer& canonical(const Context& context = {}) const;
  /// Equal exactly for homeomorphic manifolds; nothing if it was not found.
  std::optional<std::string> isometry_signature(const Context& context = {}) const;
  std::optional<canonical::IsometryGroup> isometry_group(const Context& context = {}) const;
  canonical::Comparison compare(const Manifold& other, const Context& context = {}) const;
  /// Nothing where it was not decided.
  std::optional<bool> is_isometric_to(const Manifold& other, const Context& context = {}) const;
  /// Its entry in the census that comes with the library; null if it is not in it or was not
  /// recognised.
  const canonical::CensusEntry* identify(const Context& context = {}) const;

  // Results for other programs.

  /// The JSON of `tripus solve` (docs: interface), solved for if need be.
  std::string to_json(const Context& context = {}) const;
  /// Writes to_json. Throws InvalidInput unless the name ends with .json; IoError.
  void write(const std::string& path, const Context& context = {}) const;

 private:
  struct State;
  Manifold(topology::Triangulation triangulation, std::string name, std::string input,
           bool orientation_known, std::vector<topology::ConeAngle> cone_angles = {});
  std::shared_ptr<const State> state_;
};

/// The manifold of an INPUT: an isomorphism signature, or a file with a gluing table, a Regina or
/// SnapPea triangulation, a surface or a tetrahedral mesh; `-` is standard input. Cone angles come
/// from the file, or stand behind it: "eLAkbbcddpuchf 0=7,1=2".
/// Throws InvalidInput, with the place and the remedy; Stopped if a stop is requested meanwhile.
Manifold load(const std::string& input, const Context& context = {});

}  // namespace tripus
