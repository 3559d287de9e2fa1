#include "topology/simplify/locality.hpp"

#include <vector>

// A million tetrahedra take some 100 MB with their labels. If they are numbered at random, every
// step to a neighbour waits for memory, and collapsing costs five times as much as for ten thousand
// of them. Numbered breadth first, the neighbours are near, and the cost per tetrahedron is the
// same at every size. Tables whose numbers are near already are left as they are: the order decides
// which edges are collapsed first, and the order of a subdivision is better than this one.

namespace tripus::topology {
namespace {

/// What fits into the second-level cache does not matter.
constexpr std::size_t kCachedTetrahedra = 20'000;
/// Mean distance of neighbours' numbers, as a part of T; T / 3 if they are random.
constexpr double kScattered = 1.0 / 32;

}  // namespace

bool is_scattered(const Gluings& gluings) {
  const std::size_t count = gluings.tetrahedron_count();
  if (count <= kCachedTetrahedra) return false;
  double distances = 0;
  for (std::size_t t = 0; t < count; ++t)
    for (int f = 0; f < 4; ++f) {
      const std::size_t other = gluings.neighbour(t, f);
      distances += static_cast<double>(other > t ? other - t : t - other);
    }
  const auto size = static_cast<double>(count);
  return distances > 4 * size * kScattered * size;
}

Gluings breadth_first(const Gluings& gluings) {
  const std::size_t count = gluings.tetrahedron_count();
  std::vector<TetrahedronIndex> number(count, kNoTetrahedron);
  std::vector<TetrahedronIndex> order;
  order.reserve(count);
  const auto visit = [&](TetrahedronIndex t) {
    if (number[t] != kNoTetrahedron) return;
    number[t] = static_cast<TetrahedronIndex>(order.size());
    order.push_back(t);
  };
  std::size_t head = 0;
  for (TetrahedronIndex first = 0; first < count; ++first)
    for (visit(first); head < order.size(); ++head)
      for (int f = 0; f < 4; ++f) visit(gluings.neighbour(order[head], f));

  Gluings result(count);
  for (std::size_t i = 0; i < count; ++i)
    for (int f = 0; f < 4; ++f)
      result.set_one_side(i, f, number[gluings.neighbour(order[i], f)],
                          gluings.gluing(order[i], f));
  return result;
}

}  // namespace tripus::topology
