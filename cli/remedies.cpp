#include "cli/remedies.hpp"

#include "base/error.hpp"
#include "canonical/canonize.hpp"
#include "topology/requirements.hpp"

namespace tripus::cli {
namespace {

bool is_closed(const topology::Triangulation& triangulation) {
  for (std::size_t v = 0; v < triangulation.vertex_count(); ++v)
    if (triangulation.link(v).euler_characteristic != 2) return false;
  return true;
}

const char* remedy(const topology::Triangulation& triangulation) {
  if (!triangulation.is_connected()) return " (tripus solve --components)";
  for (std::size_t v = 0; v < triangulation.vertex_count(); ++v)
    if (!triangulation.link(v).orientable) return " (tripus cover INPUT --orientable)";
  for (std::size_t v = 0; v < triangulation.vertex_count(); ++v)
    if (triangulation.link(v).euler_characteristic == 2 && !is_closed(triangulation))
      return " (tripus simplify; the verbs that need a metric do it by themselves)";
  return "";
}

template <class Require>
void with_remedy(const topology::Triangulation& triangulation, Require&& require) {
  try {
    require();
  } catch (const Unsupported& error) {
    throw Unsupported(std::string(error.what()) + remedy(triangulation));
  } catch (const InvalidInput& error) {
    throw InvalidInput(std::string(error.what()) + remedy(triangulation));
  }
}

}  // namespace

void require_boundary_with_remedy(const topology::Triangulation& triangulation) {
  with_remedy(triangulation, [&] { topology::require_geodesic_boundary(triangulation); });
}

void require_canonizable_with_remedy(const topology::Triangulation& triangulation,
                                     std::span<const topology::ConeAngle> cone_angles) {
  with_remedy(triangulation, [&] { canonical::require_canonizable(triangulation, cone_angles); });
}

void require_boundary_beside_cusps_with_remedy(const topology::Triangulation& triangulation) {
  with_remedy(triangulation, [&] { topology::require_boundary_beside_cusps(triangulation); });
}

void require_with_remedy(const topology::Triangulation& triangulation,
                         std::span<const topology::ConeAngle> cone_angles) {
  with_remedy(triangulation, [&] { topology::require_solvable(triangulation, cone_angles); });
}

std::string advice_text(structure::Advice advice) {
  using structure::Advice;
  switch (advice) {
    case Advice::kNone:
      return {};
    case Advice::kRetriangulate:
      return "Try another triangulation of the manifold: --retriangulate looks for one by moves.";
    case Advice::kMoreTime:
      return "Give it more time or iterations: --time-limit, --max-iterations.";
    case Advice::kLooserTolerance:
      return "Ask for a tolerance that doubles can reach: --tolerance 1e-12.";
    case Advice::kLargerSearch:
      return "If the manifold should be hyperbolic, try a larger --budget or another --seed.";
    case Advice::kMoreSearchTime:
      return "If the manifold should be hyperbolic, give the search more time: --time-limit.";
    case Advice::kLargerTriangulation:
      return "If the manifold should be hyperbolic, begin with a larger triangulation of it.";
  }
  return {};
}

}  // namespace tripus::cli
