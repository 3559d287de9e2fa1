#include <algorithm>
#include <string>

#include "base/error.hpp"
#include "base/stop.hpp"
#include "topology/covers/covers.hpp"

namespace tripus::topology {
namespace {

using Permutations = std::vector<std::vector<std::uint32_t>>;

constexpr std::uint32_t kNowhere = 0xffffffffu;

/// The inverse of a permutation of 0..degree-1. Throws InvalidInput, naming the generator, for what
/// is none.
std::vector<std::uint32_t> inverse_of(const std::vector<std::uint32_t>& images, std::size_t degree,
                                      std::size_t generator) {
  std::vector<std::uint32_t> inverse(degree, kNowhere);
  for (std::size_t sheet = 0; sheet < images.size(); ++sheet)
    if (images[sheet] < degree && sheet < degree) inverse[images[sheet]] = std::uint32_t(sheet);
  if (images.size() != degree || std::ranges::find(inverse, kNowhere) != inverse.end())
    throw InvalidInput("generator " + std::to_string(generator) +
                       " is given no permutation of 0 to " + std::to_string(degree - 1));
  return inverse;
}

/// Throws InvalidInput unless every relator leaves every sheet where it is.
void require_action(const Presentation& presentation, const Permutations& images,
                    const Stop& stop) {
  const std::size_t degree = images.front().size();
  Permutations inverses;
  for (std::size_t g = 0; g < images.size(); ++g)
    inverses.push_back(inverse_of(images[g], degree, g));
  for (std::size_t r = 0; r < presentation.relators.size(); ++r) {
    throw_if_stopped(stop);
    for (std::uint32_t start = 0; start < degree; ++start) {
      std::uint32_t sheet = start;
      for (const Letter letter : presentation.relators[r])
        sheet = (letter > 0 ? images : inverses)[generator_of(letter)][sheet];
      if (sheet != start)
        throw InvalidInput("the permutations are no action: relator " + std::to_string(r) +
                           " moves sheet " + std::to_string(start));
    }
  }
}

}  // namespace

Gluings cover_of_permutations(const Triangulation& base, const Permutations& images,
                              const Stop& stop) {
  const FundamentalGroup group = fundamental_group(base);
  const std::size_t count = group.presentation.generator_count;
  if (images.size() != count)
    throw InvalidInput("a cover is given by a permutation for each of the " +
                       std::to_string(count) + " generators, not by " +
                       std::to_string(images.size()));
  const std::size_t degree = images.empty() ? 1 : images.front().size();
  if (degree == 0) throw InvalidInput("a cover has one sheet or more, not none");
  if (degree > kMaxTetrahedra / base.tetrahedron_count())
    throw InvalidInput(std::to_string(degree) + " sheets are too many: the cover would have " +
                       "more than " + std::to_string(kMaxTetrahedra) + " tetrahedra");
  if (!images.empty()) require_action(group.presentation, images, stop);
  throw_if_stopped(stop);
  Gluings cover = cover_of_action(base.gluings(), group, {degree, images, 0});
  throw_if_stopped(stop);
  if (!Triangulation(cover).is_connected())
    throw InvalidInput("the permutations do not join all sheets: the cover is not connected");
  return cover;
}

}  // namespace tripus::topology
