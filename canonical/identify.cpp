#include "canonical/identify.hpp"

#include "base/stop.hpp"
#include "topology/isosig.hpp"
#include "topology/simplify/small_triangulations.hpp"

namespace tripus::canonical {
namespace {

/// Faces visited before a signature is given up: the manifold is then no small one.
constexpr std::size_t kWorkLimit = 20'000'000;

}  // namespace

std::string_view to_string(IdentifiedBy by) {
  switch (by) {
    case IdentifiedBy::kTriangulation:
      return "triangulation";
    case IdentifiedBy::kDecomposition:
      return "decomposition";
    case IdentifiedBy::kNothing:
      break;
  }
  return {};
}

const CensusEntry* find_simplified(const topology::Triangulation& triangulation,
                                   const Census& census, const Stop& stop) {
  for (const auto& small : topology::small_triangulations(triangulation.gluings(), 1, stop))
    if (const CensusEntry* entry = census.find(topology::isosig(small))) return entry;
  return nullptr;
}

Identification identify(const topology::Triangulation& triangulation, const Census& census,
                        const CanonizeOptions& options) {
  const bool plain = topology::all_full(options.solve.cone_angles);
  if (plain) {
    const auto isosig = topology::isosig(triangulation.gluings(), kWorkLimit);
    if (const CensusEntry* entry = isosig ? census.find(*isosig) : nullptr)
      return {entry, IdentifiedBy::kTriangulation, {}};
  }
  Identification result;
  result.answer = canonize(triangulation, options);
  if (result.answer->manifold) {
    result.by = IdentifiedBy::kDecomposition;
    result.entry = census.find(result.answer->manifold->signature.unoriented);
    return result;
  }
  if (!options.retriangulate || !plain) return result;
  result.entry = find_simplified(triangulation, census, options.solve.stop);
  if (result.entry != nullptr) result.by = IdentifiedBy::kTriangulation;
  return result;
}

}  // namespace tripus::canonical
