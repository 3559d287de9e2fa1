#include "topology/homology.hpp"

#include <utility>

#include "base/stop.hpp"
#include "topology/detail/relators.hpp"
#include "topology/detail/smith_form.hpp"

namespace tripus::topology {
namespace {

detail::SparseRow<std::int64_t> relator(const Triangulation& triangulation, std::size_t e,
                                        const detail::FaceGenerators& generators) {
  detail::SparseRow<std::int64_t> row;
  detail::walk_around_edge(triangulation, e, [&](std::size_t slot) {
    const std::int32_t code = generators.code(slot);
    if (code != 0)
      row.push_back({static_cast<std::uint32_t>(code > 0 ? code : -code) - 1, code > 0 ? 1 : -1});
  });
  return detail::collected(std::move(row));
}

/// Edge classes as a breadth-first search meets them: neighbours in space become neighbours in the
/// matrix, whatever the labels, and that keeps numbers short when its last rows are reduced.
std::vector<std::size_t> edges_by_distance(const Triangulation& triangulation) {
  std::vector<std::size_t> order;
  order.reserve(triangulation.edge_count());
  std::vector<bool> met(triangulation.edge_count(), false);
  for (const TetrahedronIndex t : spanning_forest(triangulation.gluings()).order)
    for (int e = 0; e < 6; ++e) {
      const std::size_t index = triangulation.edge_class(t, e);
      if (!met[index]) order.push_back(index);
      met[index] = true;
    }
  return order;
}

}  // namespace

std::string to_string(const AbelianGroup& group) {
  std::string out;
  const auto add = [&out](std::size_t times, const std::string& factor) {
    if (times == 0) return;
    if (!out.empty()) out += " + ";
    if (times > 1) out += std::to_string(times) + " ";
    out += factor;
  };
  add(group.rank, "Z");
  const auto& factors = group.invariant_factors;
  for (std::size_t i = 0; i < factors.size();) {
    const std::size_t first = i;
    while (i < factors.size() && factors[i] == factors[first]) ++i;
    add(i - first, "Z_" + factors[first]);
  }
  return out.empty() ? "0" : out;
}

AbelianGroup first_homology(const Triangulation& triangulation, const Stop& stop) {
  const detail::FaceGenerators generators(triangulation.gluings());
  std::vector<detail::SparseRow<std::int64_t>> rows;
  rows.reserve(triangulation.edge_count());
  for (const std::size_t e : edges_by_distance(triangulation))
    rows.push_back(relator(triangulation, e, generators));
  const detail::SmithForm form = detail::smith_form(std::move(rows), generators.count(), stop);
  AbelianGroup group;
  group.rank = generators.count() - form.rank;
  for (const auto& factor : form.factors) group.invariant_factors.push_back(to_decimal(factor));
  return group;
}

}  // namespace tripus::topology
