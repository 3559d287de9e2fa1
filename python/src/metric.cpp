#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>
#include <tripus/tripus.hpp>

#include "geometry/hyperbolic_space.hpp"
#include "manifold/embedding_json.hpp"
#include "python/src/arrays.hpp"
#include "python/src/bindings.hpp"
#include "structure/certificate.hpp"
#include "structure/proof/proof_text.hpp"
#include "structure/proof/prove_report.hpp"
#include "topology/requirements.hpp"

namespace tripus::python {
namespace {

std::optional<HeldMetric> metric_of(const Manifold& manifold, const Limits& limits) {
  const Metric* metric = run(limits, [&](const Context& c) { return manifold.metric(c); });
  if (metric == nullptr) return std::nullopt;
  return HeldMetric{manifold, metric};
}

const HeldMetric& held(nb::handle self) { return nb::cast<const HeldMetric&>(self); }

/// Vertices and face normals [T x 4 x 4], pairings [T x 4 x 4 x 4].
nb::tuple embedding_of(const HeldMetric& self) {
  const embedding::Embedding& e =
      quickly([&]() -> decltype(auto) { return self.metric->embedding(); });
  std::vector<double> vertices, faces, pairings;
  const auto append = [](std::vector<double>& to, const auto& v) {
    for (int i = 0; i < 4; ++i) to.push_back(v[i]);
  };
  for (const auto& tetrahedron : e.tetrahedra)
    for (std::size_t i = 0; i < 4; ++i) {
      append(vertices, tetrahedron.vertices[i]);
      append(faces, tetrahedron.faces[i]);
    }
  for (const auto& four : e.face_pairings)
    for (const embedding::Matrix4& m : four)
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) pairings.push_back(m(i, j));
  const std::size_t count = e.tetrahedra.size();
  return nb::make_tuple(owned(std::move(vertices), {count, 4, 4}),
                        owned(std::move(faces), {count, 4, 4}),
                        owned(std::move(pairings), {count, 4, 4, 4}));
}

/// Isometries [g x 4 x 4], Moebius maps [g x 2 x 2] with whether they reverse, defect and bound.
nb::tuple holonomy_of(const HeldMetric& self) {
  const embedding::Holonomy h = quickly([&] { return self.metric->holonomy(); });
  std::vector<std::complex<double>> moebius;
  std::vector<bool> reverses;
  for (const auto& map : h.moebius) {
    moebius.insert(moebius.end(), {map.a, map.b, map.c, map.d});
    reverses.push_back(map.reverses);
  }
  const embedding::RelatorDefect defect = embedding::relator_defect(h);
  return nb::make_tuple(stacked(h.isometries), owned(std::move(moebius), {h.moebius.size(), 2, 2}),
                        reverses, std::vector<double>(h.rounding), defect.defect, defect.bound,
                        defect.holds());
}

/// A word in the generators, letters from 1 on, as a Lorentz matrix [4 x 4] and a Moebius map [2 x
/// 2] with whether it reverses.
nb::tuple isometry_of_word(const HeldMetric& self, const std::vector<int>& letters) {
  const embedding::Holonomy h = quickly([&] { return self.metric->holonomy(); });
  const topology::Word word(letters.begin(), letters.end());
  const geometry::MoebiusMap map = embedding::moebius_of(h, word);
  return nb::make_tuple(
      stacked(std::vector{embedding::isometry_of(h, word)}),
      owned(std::vector<std::complex<double>>{map.a, map.b, map.c, map.d}, {2, 2}), map.reverses);
}

CellComplex universal_cover(const HeldMetric& self, std::size_t cells,
                            std::optional<std::uint32_t> depth, std::optional<double> radius,
                            std::uint32_t root, const Limits& limits) {
  embedding::UniversalCoverOptions options;
  options.max_cells = cells;
  if (depth) options.max_depth = *depth;
  if (radius) options.max_radius = *radius;
  options.root = root;
  return run(limits, [&](const Context& c) { return self.metric->universal_cover(options, c); });
}

geometry::Model model_of(const std::string& name) {
  using geometry::Model;
  for (const Model model : geometry::kModels)
    if (name == geometry::to_string(model)) return model;
  throw InvalidInput("the models are upper, ball and klein, not " + quoted(name));
}

/// Tetrahedra, depths, parents (-1: none) and isometries of the cells.
nb::tuple cells_of(const CellComplex& complex) {
  std::vector<std::uint32_t> tetrahedra, depths;
  std::vector<std::int64_t> parents;
  std::vector<embedding::Matrix4> isometries;
  for (const embedding::Cell& cell : complex.cells()) {
    tetrahedra.push_back(cell.tetrahedron);
    depths.push_back(cell.depth);
    parents.push_back(cell.parent == embedding::kNoCell ? -1 : std::int64_t{cell.parent});
    isometries.push_back(cell.isometry);
  }
  return nb::make_tuple(owned(std::move(tetrahedra)), owned(std::move(depths)),
                        owned(std::move(parents)), stacked(isometries),
                        std::string(end_word(complex.end())));
}

/// Points [P x 3], triangles [F x 3], and the cell and side of each triangle.
nb::tuple cell_mesh(const CellComplex& complex, const std::string& model, double error,
                    const Limits& limits) {
  struct Mesh {
    std::vector<double> points;
    std::vector<std::uint32_t> triangles, cells;
    std::vector<std::uint8_t> sides;
  };
  const geometry::Model chosen = model_of(model);
  Mesh mesh = run(limits, [&](const Context& context) {
    const embedding::Tessellation tessellation(complex.embedding(), complex.cells(),
                                               {chosen, error, context.stop});
    Mesh made;
    for (std::size_t c = 0; c < tessellation.cells().size() && !tessellation.is_stopped(); ++c) {
      const auto first = std::uint32_t(made.points.size() / 3);
      for (const auto& p : tessellation.points(c))
        made.points.insert(made.points.end(), {p[0], p[1], p[2]});
      for (const auto& t : tessellation.triangles(c)) {
        made.triangles.insert(made.triangles.end(), {first + t[0], first + t[1], first + t[2]});
        made.cells.push_back(std::uint32_t(c));
      }
      const auto& sides = tessellation.sides(c);
      made.sides.insert(made.sides.end(), sides.begin(), sides.end());
    }
    return made;
  });
  const std::size_t points = mesh.points.size() / 3, triangles = mesh.triangles.size() / 3;
  return nb::make_tuple(owned(std::move(mesh.points), {points, 3}),
                        owned(std::move(mesh.triangles), {triangles, 3}),
                        owned(std::move(mesh.cells)), owned(std::move(mesh.sides)));
}

void bind_proofs(nb::module_& module) {
  module.def("prove", [](const Manifold& manifold, int digits, const Limits& limits) {
    const auto proof = run(limits, [&](const Context& context) {
      const auto angles = manifold.cone_angles();
      return structure::prove_report(
          manifold.triangulation(), manifold.verdict(context),
          {.digits = digits, .cone_angles = {angles.begin(), angles.end()}}, context);
    });
    return nb::make_tuple(structure::to_json(proof), structure::proof_message(proof));
  });
  // The volume with bounds that are proved; None where the proof does not go through.
  module.def("volume_bounds", [](const HeldMetric& metric) -> nb::object {
    const auto proof = run({}, [&](const Context& c) { return metric.metric->prove(c); });
    if (!proof.proved) return nb::str(proof.reason.c_str());
    return nb::make_tuple(proof.volume.lower, proof.volume.upper);
  });
  module.def(
      "check_proof", [](const Manifold& manifold, const std::string& json, const Limits& limits) {
        const auto check = run(limits, [&](const Context& context) {
          const auto proof = structure::parse_proof(json);
          if (!topology::same_angles(proof.cone_angles, manifold.cone_angles(),
                                     manifold.triangulation().edge_count()))
            return structure::ProofCheck{false, "its cone angles are not those of the manifold"};
          return structure::check_proof(manifold.triangulation(), proof, context);
        });
        return nb::make_tuple(check.valid, check.reason);
      });
  module.def("check_certificate", [](const Manifold& manifold, const std::string& json) {
    const auto check = quickly([&] {
      return structure::check(manifold.triangulation(), structure::parse_certificate(json));
    });
    return nb::make_tuple(check.valid, check.reason);
  });
}

}  // namespace

void bind_metric(nb::module_& module) {
  nb::class_<HeldMetric>(module, "Metric", "tripus::Metric")
      .def_prop_ro("manifold", [](const HeldMetric& self) { return self.manifold; })
      .def("volume", [](const HeldMetric& self) { return self.metric->volume(); })
      .def("max_curvature", [](const HeldMetric& self) { return self.metric->max_curvature(); })
      .def("edge_lengths",
           [](nb::handle_t<HeldMetric> self) {
             const auto lengths = held(self).metric->edge_lengths();
             return view(lengths.data(), {lengths.size()}, self);
           })
      .def(
          "dihedral_angles",
          [](nb::handle_t<HeldMetric> self) {
            const auto angles = held(self).metric->dihedral_angles();
            return view(angles.empty() ? nullptr : angles.front().data(), {angles.size(), 6}, self);
          })
      .def("report", [](const HeldMetric& self) { return as_dict(self.metric->report()); })
      .def("embedding", embedding_of)
      .def("holonomy", holonomy_of)
      .def("isometry_of_word", isometry_of_word)
      .def("universal_cover", universal_cover)
      .def("fundamental_domain",
           [](const HeldMetric& self) {
             return quickly([&] { return self.metric->fundamental_domain(); });
           })
      .def("orthospectrum", orthospectrum_of)
      .def("discs", discs_of)
      .def("spots_svg", spots_svg);
  nb::class_<CellComplex>(module, "CellComplex", "tripus::CellComplex")
      .def("size", [](const CellComplex& self) { return self.cells().size(); })
      .def("cells", cells_of)
      .def("mesh", cell_mesh)
      .def("write", [](const CellComplex& self, const nb::bytes& path, const std::string& model,
                       double error, const Limits& limits) {
        const CellFileOptions options{model_of(model), error};
        return run(limits,
                   [&](const Context& c) { return self.write(as_string(path), options, c); });
      });
  module.def("metric", metric_of, nb::arg("manifold"), nb::arg("limits"));
  bind_proofs(module);
}

}  // namespace tripus::python
