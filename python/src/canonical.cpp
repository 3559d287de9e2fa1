#include <nanobind/nanobind.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>
#include <tripus/tripus.hpp>

#include "canonical/identify.hpp"
#include "python/src/arrays.hpp"
#include "python/src/bindings.hpp"
#include "topology/moves/moves.hpp"

namespace tripus::python {
namespace {

nb::dict group_dict(const canonical::IsometryGroup& group) {
  nb::dict d;
  d["order"] = group.order;
  d["orientation_preserving"] = group.orientation_preserving;
  d["is_amphicheiral"] = group.is_amphicheiral;
  d["name"] = group.name;
  d["element_orders"] = group.element_orders;
  d["generators_on_boundary"] = group.generators_on_boundary;
  return d;
}

nb::dict canonical_dict(const canonical::CanonizeAnswer& answer) {
  nb::dict d;
  d["found"] = answer.manifold.has_value();
  d["message"] = answer.message;
  d["advice"] = std::string(structure::to_string(answer.advice));
  if (!answer.manifold) {
    d["verdict"] = as_dict(answer.report);
    return d;
  }
  const canonical::CanonicalManifold& found = *answer.manifold;
  d["verdict"] = as_dict(found.report);
  d["triangulation"] = Manifold(found.triangulation);
  d["volume"] = found.report.volume;
  d["volume_error"] = found.volume_error;
  d["cells"] = found.cells;
  std::vector<std::string> types;
  for (std::size_t c = 0; c < found.decomposition.cell_count(); ++c)
    types.push_back(canonical::cell_type(found.decomposition, c).name);
  d["cell_types"] = types;
  d["edge_lengths"] = owned(canonical::cell_edge_lengths(found));
  d["margin"] = found.faces.margin;
  d["largest_zero"] = found.faces.largest_zero;
  d["signature"] = found.signature.unoriented;
  d["oriented_signature"] = found.signature.oriented;
  d["isometries"] = group_dict(found.isometries);
  d["simplified"] = found.simplified;
  std::vector<std::string> path;
  for (const topology::Move& move : found.path) path.push_back(topology::to_string(move));
  d["path"] = path;
  return d;
}

/// (cell images, vertex images, boundary images, whether it keeps the orientation; None if not
/// known) of every isometry, where the canonical decompositions were found.
nb::object isometries_of(const canonical::Comparison& found) {
  if (!found.first || !found.second) return nb::none();
  nb::list result;
  const bool oriented = found.orientations_known && found.first->decomposition.is_orientable();
  for (const auto& each : canonical::isometries(*found.first, *found.second))
    result.append(nb::make_tuple(
        each.cells.cell_images, each.cells.vertex_images, each.boundary_images,
        oriented ? nb::object(nb::bool_(each.keeps_orientation)) : nb::object(nb::none())));
  return result;
}

nb::dict comparison_dict(const canonical::Comparison& found) {
  nb::dict d;
  d["verdict"] = std::string(canonical::to_string(found.verdict));
  d["decided_by"] = found.decided_by;
  d["message"] = found.message;
  d["advice"] = std::string(structure::to_string(found.advice));
  d["keeps_orientation"] = found.keeps_orientation;
  d["reverses_orientation"] = found.reverses_orientation;
  d["orientations_known"] = found.orientations_known;
  if (found.isometry)
    d["isometry"] = nb::make_tuple(found.isometry->cell_images, found.isometry->vertex_images);
  return d;
}

nb::dict entry_dict(const canonical::CensusEntry& entry) {
  nb::dict d;
  d["name"] = entry.name;
  d["tetrahedra"] = entry.tetrahedra;
  d["boundary"] = entry.boundary;
  d["volume"] = entry.volume;
  d["homology"] = entry.homology;
  d["cells"] = entry.cells;
  d["orientation_preserving"] = entry.keeping;
  d["orientation_reversing"] = entry.reversing;
  d["signature"] = entry.signature;
  d["triangulations"] = entry.triangulations;
  return d;
}

nb::list census_of(const nb::dict& given) {
  canonical::CensusQuery query;
  const auto take = [&](const char* key, auto& value) {
    using Value = std::remove_reference_t<decltype(value)>;
    if (given.contains(key)) value = nb::cast<Value>(given[key]);
  };
  take("least_volume", query.least_volume);
  take("greatest_volume", query.greatest_volume);
  take("boundary", query.boundary);
  take("homology", query.homology);
  take("cells", query.cells);
  if (given.contains("tetrahedra")) query.tetrahedra = nb::cast<std::size_t>(given["tetrahedra"]);
  nb::list result;
  for (const auto* entry : canonical::select(canonical::shipped_census(), query))
    result.append(entry_dict(*entry));
  return result;
}

}  // namespace

void bind_canonical(nb::module_& module) {
  module.def("canonical", [](const Manifold& manifold, const Limits& limits) {
    return canonical_dict(*run(limits, [&](const Context& c) { return &manifold.canonical(c); }));
  });
  module.def("isometry_signature", [](const Manifold& manifold, const Limits& limits) {
    return run(limits, [&](const Context& c) { return manifold.isometry_signature(c); });
  });
  module.def("isometry_group", [](const Manifold& manifold, const Limits& limits) -> nb::object {
    const auto group = run(limits, [&](const Context& c) { return manifold.isometry_group(c); });
    if (!group) return nb::none();
    return group_dict(*group);
  });
  module.def("compare", [](const Manifold& a, const Manifold& b, const Limits& limits) {
    return comparison_dict(run(limits, [&](const Context& c) { return a.compare(b, c); }));
  });
  module.def("isometries", [](const Manifold& a, const Manifold& b, const Limits& limits) {
    const auto found = run(limits, [&](const Context& c) { return a.compare(b, c); });
    return nb::make_tuple(comparison_dict(found), isometries_of(found));
  });
  module.def("identify", [](const Manifold& manifold, const Limits& limits) -> nb::object {
    const auto* entry = run(limits, [&](const Context& c) { return manifold.identify(c); });
    if (entry == nullptr) return nb::none();
    return entry_dict(*entry);
  });
  module.def("census", census_of);
}

}  // namespace tripus::python
