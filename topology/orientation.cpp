#include "topology/orientation.hpp"

#include <optional>
#include <vector>

#include "topology/isomorphism.hpp"

namespace tripus::topology {
namespace {

constexpr Perm4 kSwap = Perm4::from_images(0, 1, 3, 2);

Isomorphism in_place(std::size_t count) {
  Isomorphism result;
  result.perms.resize(count);
  result.tetrahedron_images.reserve(count);
  for (std::size_t t = 0; t < count; ++t)
    result.tetrahedron_images.push_back(static_cast<TetrahedronIndex>(t));
  return result;
}

}  // namespace

std::optional<std::vector<char>> disagreeing_labels(const Gluings& gluings) {
  const std::size_t count = gluings.tetrahedron_count();
  std::vector<char> seen(count), disagrees(count);
  std::vector<std::size_t> todo;
  for (std::size_t start = 0; start < count; ++start) {
    if (seen[start]) continue;
    seen[start] = 1;
    todo.push_back(start);
    while (!todo.empty()) {
      const std::size_t t = todo.back();
      todo.pop_back();
      for (int f = 0; f < 4; ++f) {
        if (gluings.is_open(t, f)) continue;
        const std::size_t other = gluings.neighbour(t, f);
        const char wanted = gluings.gluing(t, f).is_odd() ? disagrees[t] : !disagrees[t];
        if (seen[other] && disagrees[other] != wanted) return std::nullopt;
        if (!seen[other]) todo.push_back(other);
        seen[other] = 1;
        disagrees[other] = wanted;
      }
    }
  }
  return disagrees;
}

Gluings oriented(const Gluings& gluings) {
  const auto disagrees = disagreeing_labels(gluings);
  if (!disagrees) return gluings;
  Isomorphism relabelling = in_place(gluings.tetrahedron_count());
  for (std::size_t t = 0; t < disagrees->size(); ++t)
    if ((*disagrees)[t]) relabelling.perms[t] = kSwap;
  return relabelled(gluings, relabelling);
}

bool is_orientable(const Gluings& gluings) { return disagreeing_labels(gluings).has_value(); }

Gluings mirrored(const Gluings& gluings) {
  Isomorphism relabelling = in_place(gluings.tetrahedron_count());
  for (Perm4& perm : relabelling.perms) perm = kSwap;
  return relabelled(gluings, relabelling);
}

}  // namespace tripus::topology
