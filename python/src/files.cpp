#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <tripus/tripus.hpp>

#include "base/output_file.hpp"
#include "manifold/load.hpp"
#include "manifold/prepared.hpp"
#include "meshing/formats/read_graph.hpp"
#include "meshing/manifold.hpp"
#include "meshing/tube/tube_surface.hpp"
#include "python/src/arrays.hpp"
#include "python/src/bindings.hpp"
#include "python/src/meshes.hpp"
#include "topology/formats/formats.hpp"

namespace tripus::python {
namespace {

/// The triangulation that a text holds, as `load` gives that of a file. What another program wrote
/// for us, such as peripheral curves, is left out without a note.
Manifold from_text(const nb::bytes& given, bool notes, const Limits& limits) {
  const std::string text = as_string(given);
  return run(limits, [&](const Context& context) {
    topology::NamedGluings loaded = topology::read_triangulation(text);
    if (!notes) loaded.notes.clear();
    make_ideal(loaded, topology::FiniteVertices::kKeep, context.stop);
    for (const std::string& note : loaded.notes) context.note(note);
    return Manifold(std::move(loaded));
  });
}

struct TextFormat {
  std::string_view name;
  std::string (*write)(const topology::NamedGluings&);
};
constexpr TextFormat kTextFormats[] = {{"json", topology::write_json},
                                       {"regina", topology::write_regina_xml},
                                       {"regina-table", topology::write_regina_table},
                                       {"snappea", topology::write_snappea},
                                       {"orb", topology::write_orb}};

nb::bytes to_text(const Manifold& manifold, const std::string& format) {
  for (const TextFormat& each : kTextFormats) {
    if (format != each.name) continue;
    return as_bytes(run({}, [&](const Context&) {
      const auto angles = manifold.cone_angles();
      return each.write({.name = manifold.name(),
                         .gluings = manifold.triangulation().gluings(),
                         .cone_angles = {angles.begin(), angles.end()}});
    }));
  }
  throw InvalidInput("there is no format " + quoted(format) +
                     "; json, regina, regina-table, snappea and orb there are");
}

/// The solid of a surface or of a tetrahedral mesh; also the tetrahedra at each stage.
nb::tuple from_mesh(const PointArray& points, const IndexArray& cells, const nb::bytes& name,
                    std::uint64_t seed, const Limits& limits) {
  const meshing::MeshFile file = mesh_of(points, cells);
  const std::string called = as_string(name);
  meshing::MeshedManifold solid = run(limits, [&](const Context& context) {
    meshing::ManifoldOptions options;
    options.seed = seed;
    options.progress = context.progress;
    options.stop = context.stop;
    meshing::MeshedManifold made = meshing::manifold_of(file, options);
    for (const std::string& note : made.notes) context.note(note);
    return made;
  });
  nb::dict stages;
  for (std::size_t s = 0; s < meshing::kStageCount; ++s)
    stages[nb::str(std::string(meshing::stage_name(meshing::MeshStage(s))).c_str())] =
        solid.tetrahedra[s];
  return nb::make_tuple(Manifold(topology::NamedGluings{called, std::move(solid.gluings)}), stages);
}

/// The surface of the tube around a graph in space: points and triangles.
nb::tuple tube_around(const nb::bytes& drawing, const Limits& limits) {
  const std::string text = as_string(drawing);
  const meshing::SurfaceMesh surface = run(limits, [&](const Context& context) {
    meshing::TubeOptions options;
    options.progress = [&](std::string_view activity) { context.report(activity); };
    options.stop = context.stop;
    return meshing::tube_surface(meshing::read_graph(text), options);
  });
  std::vector<double> points;
  for (const auto& p : surface.points) points.insert(points.end(), p.begin(), p.end());
  std::vector<std::uint32_t> triangles;
  for (const auto& t : surface.triangles) triangles.insert(triangles.end(), t.begin(), t.end());
  return nb::make_tuple(owned(std::move(points), {surface.points.size(), 3}),
                        owned(std::move(triangles), {surface.triangles.size(), 3}));
}

}  // namespace

void bind_files(nb::module_& module) {
  module.def("from_text", from_text);
  module.def("to_text", to_text);
  module.def("tube_around", tube_around);
  module.def("from_mesh", from_mesh);
  module.def("renamed", [](const Manifold& manifold, const nb::bytes& name) {
    const auto angles = manifold.cone_angles();
    topology::NamedGluings given{.name = as_string(name),
                                 .gluings = manifold.triangulation().gluings(),
                                 .cone_angles = {angles.begin(), angles.end()},
                                 .orientation_known = manifold.is_orientation_known()};
    return quickly([&] { return Manifold(std::move(given), manifold.input()); });
  });
  module.def("write_file", [](const nb::bytes& path, const nb::bytes& text) {
    const std::string place = as_string(path);
    quickly([&] {
      write_file(place, {text.c_str(), text.size()});
      return true;
    });
  });
  module.def("read_file", [](const nb::bytes& path) {
    const std::string place = as_string(path);
    return as_bytes(quickly([&] { return read_file(place); }));
  });
  module.def("read_batch_file", [](const nb::bytes& path) {
    nb::list lines;
    const std::string place = as_string(path);
    for (const auto& line : quickly([&] { return read_batch_file(place); }))
      lines.append(as_bytes(line.text));
    return lines;
  });
}

}  // namespace tripus::python
