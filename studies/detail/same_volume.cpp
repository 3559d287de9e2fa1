// How many manifolds, and which of them have the same volume: the paper's "verifying whether two
// 3-manifolds are homeomorphic", decided by the canonical decomposition.
#include <algorithm>
#include <map>

#include "base/tolerances.hpp"
#include "studies/detail/tables.hpp"

namespace tripus::studies::detail {
namespace {

std::vector<std::string> manifold_cells(const StudiedManifold& m) {
  return cells(m.volume, m.boundary, m.homology, m.cells, m.isometries, m.triangulations,
               m.geometric, m.input, m.signature);
}

std::vector<Column> manifold_columns() {
  return {{"volume", "", "of the metric"},
          {"boundary", "", "genera of the boundary components"},
          {"homology", "", "H1"},
          {"cells", "", "of the canonical decomposition"},
          {"isometries", "", "that keep + that reverse the orientation"},
          {"triangulations", "", "inputs that belong to it"},
          {"geometric", "", "of them carry the metric themselves"},
          {"input", "", "the first of them"},
          {"manifold", "", "isometry signature: equal exactly for the same manifold"}};
}

}  // namespace

std::size_t of_same_kind(const VolumeGroup& group, const StudiedManifold& m) {
  return std::size_t(std::ranges::count_if(group, [&](const StudiedManifold& other) {
    return other.boundary == m.boundary && other.homology == m.homology;
  }));
}

std::vector<StudiedManifold> manifolds_of(const Table& table) {
  std::map<std::string, StudiedManifold> by_signature;
  for (std::size_t r = 0; r < table.size(); ++r) {
    const std::string& signature = table.text(r, "manifold");
    if (signature.empty()) continue;
    StudiedManifold& m = by_signature[signature];
    if (m.triangulations++ == 0) {
      m.signature = signature;
      m.input = table.text(r, "input");
      m.volume = table.number(r, "volume");
      m.boundary = table.text(r, "boundary");
      m.homology = table.text(r, "homology");
      m.cells = table.text(r, "cells");
      m.isometries = table.text(r, "isometries");
    }
    m.geometric += table.is(r, "outcome", "geometric");
  }
  std::vector<StudiedManifold> manifolds;
  for (auto& [signature, m] : by_signature) manifolds.push_back(std::move(m));
  std::ranges::stable_sort(manifolds, {}, &StudiedManifold::volume);
  return manifolds;
}

std::vector<VolumeGroup> volume_groups(const std::vector<StudiedManifold>& manifolds) {
  std::vector<VolumeGroup> groups;
  double previous = -1;
  for (const StudiedManifold& m : manifolds) {
    if (!(m.volume - previous <= tolerance::kVolumeAgreement * m.volume)) groups.emplace_back();
    previous = m.volume;
    groups.back().push_back(m);
  }
  for (VolumeGroup& group : groups) std::ranges::sort(group, {}, &StudiedManifold::signature);
  return groups;
}

std::vector<Table> manifold_tables(const std::vector<StudiedManifold>& manifolds,
                                   const std::vector<VolumeGroup>& groups) {
  Table all({"manifolds", "One manifold, with the inputs that are triangulations of it.",
             manifold_columns()});
  for (const StudiedManifold& m : manifolds) all.add(manifold_cells(m));
  std::vector<Column> columns = {
      {"group", "", "number of the volume among those that several manifolds share"},
      {"manifolds", "", "of this volume"},
      {"told_apart_by", "",
       "boundary and homology, if no other manifold of this volume has the same; or the canonical "
       "decomposition"}};
  const std::vector<Column> rest = manifold_columns();
  columns.insert(columns.end(), rest.begin(), rest.end());
  Table shared({"same_volume",
                "One manifold whose volume is that of another one, within 1e-9 relatively: not "
                "homeomorphic to it, since the isometry signatures differ.",
                columns});
  std::size_t number = 0;
  for (const VolumeGroup& group : groups) {
    if (group.size() < 2) continue;
    ++number;
    for (const StudiedManifold& m : group) {
      std::vector<std::string> row =
          cells(number, group.size(),
                of_same_kind(group, m) == 1 ? "boundary and homology" : "canonical decomposition");
      const std::vector<std::string> more = manifold_cells(m);
      row.insert(row.end(), more.begin(), more.end());
      shared.add(std::move(row));
    }
  }
  return {std::move(all), std::move(shared)};
}

}  // namespace tripus::studies::detail
