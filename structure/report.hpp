#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/method.hpp"
#include "structure/certificate.hpp"
#include "structure/closed_bigon.hpp"
#include "topology/vertex_kinds.hpp"

namespace tripus::structure {

/// What was found about the triangulation. It is separate from why the iteration stopped
/// (solver::Termination).
enum class Outcome {
  kGeometric,   ///< every tetrahedron is a true truncated one and max|K| <= tolerance
  kDegenerate,  ///< the minimiser of the co-volume has flat tetrahedra (listed): the boundary case
  kInfeasible,  ///< no strict angle structure, by an exact certificate
  kUnresolved,  ///< stopped by a limit; the message says which, and what is known
};
std::string_view to_string(Outcome outcome);

/// What to do where no metric was found. The program, not the library, knows by which options.
enum class Advice {
  kNone,
  kRetriangulate,    ///< look for another triangulation of the manifold
  kMoreTime,         ///< raise the limit of time or iterations that ended the run
  kLooserTolerance,  ///< there is a metric, to the accuracy of doubles, but not to this tolerance
  kLargerSearch,     ///< a larger budget or another seed for the search of triangulations
  kMoreSearchTime,   ///< more time for the search of triangulations
  kLargerTriangulation,  ///< begin with a larger one: the search has seen all that are near
};
/// "none", "retriangulate", "more time", ...
std::string_view to_string(Advice advice);

/// One vertex class.
struct VertexReport {
  int link_euler_characteristic = 0;
  bool orientable = true;  ///< the link
  int genus = 0;           ///< of an orientable link
  topology::VertexKind kind = topology::VertexKind::kHyperideal;
  std::size_t cone_points = 0;  ///< edge ends here that are singular
  double orbifold_euler_characteristic = 0;
  /// Of the boundary component, or the solid angle at a finite vertex, from the dihedral angles; at
  /// a cusp that of the horosphere from which lengths are measured.
  double area = 0;
};

/// The answer to "which metric does this triangulation carry?". The numbers are those of the last
/// iterate, also where the outcome is not geometric; they are always finite.
struct Report {
  Outcome outcome = Outcome::kUnresolved;
  solver::Termination termination = solver::Termination::kNumericalFailure;
  std::string method;
  int iterations = 0;
  int evaluations = 0;
  long linear_iterations = 0;  ///< conjugate-gradient steps, where the method has any
  double seconds = 0;

  double max_curvature = 0;  ///< max|K_e|
  double volume = 0;
  std::vector<double> edge_lengths;                    ///< [E]
  std::vector<std::array<double, 6>> dihedral_angles;  ///< [T]
  std::vector<VertexReport> vertices;                  ///< [V]
  std::vector<std::size_t> flat_tetrahedra;
  /// Exact proof that there is no strict angle structure: always there if infeasible, of kind semi
  /// if degenerate and only semi-angle structures exist.
  std::optional<Certificate> certificate;
  /// Exact strict angle structure: where one was decided to exist, or asked for.
  std::optional<StrictAngles> strict_angles;
  /// About the manifold, where no metric was found and there are no cone angles but 2 pi: a surface
  /// that proves it not hyperbolic, or a hint of one.
  std::optional<ClosedBigon> closed_bigon;
  std::string message;            ///< one sentence for a person
  Advice advice = Advice::kNone;  ///< and what to do about it
};

}  // namespace tripus::structure
