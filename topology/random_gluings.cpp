#include "topology/random_gluings.hpp"

#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "topology/edge_walk.hpp"
#include "topology/triangulation.hpp"

namespace tripus::topology {
namespace {

constexpr std::size_t kMostDraws = 100'000'000;

/// The standard distributions differ between libraries; the engine does not.
std::size_t below(std::size_t count, std::mt19937_64& random) {
  return static_cast<std::size_t>(random() % count);
}

Gluings draw(std::size_t tetrahedra, bool oriented, std::mt19937_64& random) {
  std::vector<std::size_t> faces(4 * tetrahedra);
  for (std::size_t k = 0; k < faces.size(); ++k) faces[k] = k;
  for (std::size_t k = faces.size(); k > 1; --k) std::swap(faces[k - 1], faces[below(k, random)]);
  Gluings gluings(tetrahedra);
  for (std::size_t k = 0; k < faces.size(); k += 2) {
    const auto from = static_cast<int>(faces[k] % 4), to = static_cast<int>(faces[k + 1] % 4);
    // All labels have one sign, so gluings that keep an orientation are odd.
    std::vector<Perm4> choices;
    for (int rank = 0; rank < 24; ++rank)
      if (const Perm4 p = Perm4::from_rank(rank); (p.is_odd() || !oriented) && p(from) == to)
        choices.push_back(p);
    gluings.glue(faces[k] / 4, from, static_cast<TetrahedronIndex>(faces[k + 1] / 4),
                 choices[below(choices.size(), random)]);
  }
  return gluings;
}

/// Whether an edge is glued to itself the other way round.
bool has_reversed_edge(const Gluings& gluings) {
  for (std::size_t t = 0; t < gluings.tetrahedron_count(); ++t)
    for (int e = 0; e < 6; ++e) {
      auto walk = EdgeWalk::start(t, e);
      do walk.step(gluings);
      while (walk.t != t || walk.edge() != e);
      if (walk.reversed()) return true;
    }
  return false;
}

}  // namespace

Gluings random_gluings(std::size_t tetrahedra, const EnumerationChoice& choice,
                       std::mt19937_64& random, std::size_t* draws) {
  // Fewer tetrahedra have none, as `enumerate` finds.
  const bool oriented = choice.orientability == Orientability::kOrientable;
  const std::size_t least = choice.links == LinkChoice::kMixed                 ? 3
                            : choice.links == LinkChoice::kCusped && !oriented ? 1
                                                                               : 2;
  if (tetrahedra < least)
    throw InvalidInput("the least number of tetrahedra of a triangulation with such links (" +
                       std::string(to_string(choice.links)) + ") is " + std::to_string(least));
  for (std::size_t count = 0; count < kMostDraws; ++count) {
    Gluings gluings = draw(tetrahedra, oriented, random);
    if (draws != nullptr) ++*draws;
    if (has_reversed_edge(gluings)) continue;
    const Triangulation triangulation(std::move(gluings));
    if (triangulation.is_connected() && is_chosen(triangulation, choice))
      return triangulation.gluings();
  }
  throw InvalidInput("no triangulation with " + std::to_string(tetrahedra) +
                     " tetrahedra and such links among " + std::to_string(kMostDraws) +
                     " random ones");
}

}  // namespace tripus::topology
