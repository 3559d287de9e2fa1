#include "topology/covers/covers.hpp"

#include <algorithm>
#include <string>

#include "base/error.hpp"
#include "base/stop.hpp"
#include "topology/covers/cyclic_classes.hpp"
#include "topology/cyclic_cover.hpp"

namespace tripus::topology {
namespace {

void require_size(const Triangulation& base, std::size_t degree) {
  const std::size_t most = kMaxTetrahedra / base.tetrahedron_count();
  if (degree == 0 || degree > most)
    throw InvalidInput("degree " + std::to_string(degree) + "; covers of " +
                       std::to_string(base.tetrahedron_count()) +
                       " tetrahedra are made with 1 to " + std::to_string(most) + " sheets");
}

Cover make_cyclic(const Triangulation& base, const CyclicClasses& classes, std::size_t degree,
                  std::span<const std::int64_t> values) {
  return {cyclic_cover(base.gluings(), classes.shifts(values), degree),
          degree,
          degree,
          {values.begin(), values.end()},
          {}};
}

/// Which face each generator crosses, and what that does; `face_letters` are those of the group.
std::vector<SheetPermutation> permutations_of(const TransitiveAction& action,
                                              const ReducedPresentation& short_form,
                                              const std::vector<Letter>& face_letters) {
  std::vector<SheetPermutation> result;
  for (std::size_t g = 0; g < short_form.kept.size(); ++g) {
    const auto letter = static_cast<Letter>(short_form.kept[g]) + 1;
    const auto face =
        static_cast<std::size_t>(std::ranges::find(face_letters, letter) - face_letters.begin());
    result.push_back(
        {static_cast<TetrahedronIndex>(face / 4), static_cast<int>(face % 4), action.images[g]});
  }
  return result;
}

}  // namespace

Gluings cover_of_action(const Gluings& base, const FundamentalGroup& group,
                        const TransitiveAction& action) {
  const std::size_t count = base.tetrahedron_count();
  Gluings cover(count * action.degree);
  for (std::size_t k = 0; k < action.degree; ++k)
    for (std::size_t t = 0; t < count; ++t)
      for (int f = 0; f < 4; ++f) {
        const Letter letter = group.face_letters[4 * t + static_cast<std::size_t>(f)];
        if (letter < 0) continue;  // its other side makes both
        const std::size_t sheet = letter == 0 ? k : action.images[generator_of(letter)][k];
        cover.glue(k * count + t, f,
                   static_cast<TetrahedronIndex>(sheet * count + base.neighbour(t, f)),
                   base.gluing(t, f));
      }
  return cover;
}

SearchEnd for_each_cover(const Triangulation& base, std::size_t degree, const VisitCover& visit,
                         const Stop& stop) {
  require_size(base, degree);
  const FundamentalGroup group = fundamental_group(base);
  const ReducedPresentation short_form = reduced(group.presentation);
  return for_each_transitive_action(
      short_form.presentation, degree,
      [&](const TransitiveAction& action) {
        return visit({cover_of_action(base.gluings(), group, extended(action, short_form)),
                      degree,
                      action.deck_group_order,
                      {},
                      permutations_of(action, short_form, group.face_letters)});
      },
      stop);
}

SearchEnd for_each_cyclic_cover(const Triangulation& base, std::size_t degree,
                                const VisitCover& visit, const Stop& stop) {
  require_size(base, degree);
  const CyclicClasses classes(base, degree);
  return classes.for_each(
      [&](std::span<const std::int64_t> values) {
        return visit(make_cyclic(base, classes, degree, values));
      },
      stop);
}

Cover orientable_double_cover(const Triangulation& base) {
  require_size(base, 2);
  if (!base.is_connected())
    throw InvalidInput("the triangulation is not connected; take its components one by one");
  if (base.is_orientable())
    throw InvalidInput(
        "the manifold is orientable already: it has no orientable double cover that is "
        "connected");
  // A sheet for each orientation: labels of one orientation are glued by odd permutations.
  std::vector<int> shifts;
  for (std::size_t t = 0; t < base.tetrahedron_count(); ++t)
    for (int f = 0; f < 4; ++f) shifts.push_back(base.gluings().gluing(t, f).is_odd() ? 0 : 1);
  return {cyclic_cover(base.gluings(), shifts, 2), 2, 2, {}, {}};
}

Cover cyclic_cover_of_class(const Triangulation& base, std::size_t degree,
                            std::span<const std::int64_t> values) {
  require_size(base, degree);
  const CyclicClasses classes(base, degree);
  const std::int64_t divisor = classes.common_divisor(values);
  if (divisor != 1)
    throw InvalidInput("the class is not onto Z/" + std::to_string(degree) +
                       ": its values have the common divisor " + std::to_string(divisor) +
                       " with " + std::to_string(degree) +
                       ", and the cover would not be connected");
  return make_cyclic(base, classes, degree, values);
}

}  // namespace tripus::topology
