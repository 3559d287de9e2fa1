#include "topology/simplify/small_triangulations.hpp"

#include <algorithm>
#include <string>

#include "base/stop.hpp"
#include "topology/isosig.hpp"
#include "topology/orientation.hpp"
#include "topology/simplify/simplify.hpp"

namespace tripus::topology {

std::vector<Gluings> small_triangulations(const Gluings& closed, std::size_t seeds,
                                          const Stop& stop, double effort) {
  const Gluings start = oriented(closed);
  std::vector<std::string> found;
  for (std::size_t seed = 0; seed < seeds; ++seed) {
    SimplifyOptions options;
    options.seed = seed;
    options.effort = effort;
    options.stop = stop;
    const Simplified simplified = simplify(start, options);
    if (simplified.stopped) return {};
    found.push_back(full_isosig(simplified.gluings).oriented());
  }
  // Signatures of fewer tetrahedra are shorter. The mirror image of one that was found is no other
  // triangulation, but not the same either: a chiral manifold may have both.
  std::ranges::sort(found, [](const std::string& a, const std::string& b) {
    return a.size() != b.size() ? a.size() < b.size() : a < b;
  });
  found.erase(std::unique(found.begin(), found.end()), found.end());
  std::vector<Gluings> result;
  result.reserve(found.size());
  for (const std::string& signature : found) result.push_back(decode_isosig(signature));
  return result;
}

}  // namespace tripus::topology
