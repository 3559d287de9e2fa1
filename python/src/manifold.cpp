#include <nanobind/nanobind.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/function.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>
#include <tripus/tripus.hpp>

#include "python/src/arrays.hpp"
#include "python/src/bindings.hpp"
#include "structure/method.hpp"
#include "topology/vertex_kinds.hpp"

namespace tripus::python {
namespace {

/// The options that Python has in a dict, each checked by solve itself.
structure::SolveOptions solve_options(const nb::dict& given,
                                      std::vector<structure::HistoryRow>* history) {
  structure::SolveOptions options;
  const auto take = [&](const char* key, auto& value) {
    using Value = std::remove_reference_t<decltype(value)>;
    if (given.contains(key)) value = nb::cast<Value>(given[key]);
  };
  take("method", options.method);
  take("initial_lengths", options.initial_lengths);
  take("initial_length", options.initial_length);
  take("tolerance", options.tolerance);
  take("max_iterations", options.max_iterations);
  take("evidence", options.evidence);
  take("angle_structure", options.angle_structure);
  if (given.contains("cone_angles"))
    options.cone_angles = read_cone_angles(nb::cast<nb::list>(given["cone_angles"]));
  if (given.contains("history"))
    options.history = [history](const structure::HistoryRow& row) { history->push_back(row); };
  return options;
}

Array<double> history_array(const std::vector<structure::HistoryRow>& history) {
  std::vector<double> rows;
  for (const auto& row : history)
    rows.insert(rows.end(),
                {double(row.iteration), double(row.evaluations), row.seconds, row.max_curvature,
                 row.energy, row.volume, row.shortest_edge, row.longest_edge});
  return owned(std::move(rows), {history.size(), 8});
}

nb::tuple solve(const Manifold& manifold, const nb::dict& given, const Limits& limits) {
  std::vector<structure::HistoryRow> history;
  const structure::SolveOptions options = solve_options(given, &history);
  structure::Report report = run(limits, [&](const Context& context) {
    history.clear();
    return manifold.solve(options, context);
  });
  return nb::make_tuple(as_dict(report), history_array(history));
}

void bind_metric_questions(nb::class_<Manifold>& type) {
  type.def("covers",
           [](const Manifold& m, std::size_t degree, const Limits& limits) {
             return run(limits, [&](const Context& c) { return m.covers(degree, c); });
           })
      .def("cyclic_covers",
           [](const Manifold& m, std::size_t degree, const Limits& limits) {
             return run(limits, [&](const Context& c) { return m.cyclic_covers(degree, c); });
           })
      .def("verdict",
           [](const Manifold& m, const Limits& limits) {
             return as_dict(*run(limits, [&](const Context& c) { return &m.verdict(c); }));
           })
      .def("volume",
           [](const Manifold& m) -> std::optional<double> {
             const Metric* metric = run({}, [&](const Context& c) { return m.metric(c); });
             if (metric == nullptr) return std::nullopt;
             return metric->volume();
           })
      .def("outcome",
           [](const Manifold& m) {
             return std::string(structure::to_string(
                 run({}, [&](const Context& c) { return m.verdict(c).outcome; })));
           })
      .def("solve", solve)
      .def("retriangulated",
           [](const Manifold& m, std::uint64_t seed, std::size_t budget, std::size_t extra,
              const Limits& limits) {
             return run(limits, [&](const Context& c) {
               return m.retriangulated({seed, budget, extra}, c);
             });
           })
      .def("to_json",
           [](const Manifold& m, const Limits& limits) {
             return run(limits, [&](const Context& c) { return m.to_json(c); });
           })
      .def("write", [](const Manifold& m, const nb::bytes& path, const Limits& limits) {
        run(limits, [&](const Context& c) { return m.write(as_string(path), c), true; });
      });
}

}  // namespace

nb::dict as_dict(const structure::ClosedBigon& bigon) {
  nb::dict found;
  found["decides"] = bigon.decides();
  found["surface"] = std::string(structure::surface_name(bigon));
  found["consequence"] = std::string(structure::to_string(bigon.consequence));
  found["edge"] = bigon.edge;
  found["opposite"] = bigon.opposite;
  found["message"] = structure::message(bigon);
  return found;
}

nb::dict as_dict(const structure::Report& report) {
  nb::dict d;
  d["outcome"] = std::string(structure::to_string(report.outcome));
  d["message"] = report.message;
  d["advice"] = std::string(structure::to_string(report.advice));
  d["termination"] = std::string(solver::to_string(report.termination));
  d["method"] = report.method;
  d["iterations"] = report.iterations;
  d["evaluations"] = report.evaluations;
  d["seconds"] = report.seconds;
  d["max_curvature"] = report.max_curvature;
  d["volume"] = report.volume;
  d["edge_lengths"] = owned(std::vector<double>(report.edge_lengths));
  std::vector<double> angles;
  for (const auto& six : report.dihedral_angles)
    angles.insert(angles.end(), six.begin(), six.end());
  d["dihedral_angles"] = owned(std::move(angles), {report.dihedral_angles.size(), 6});
  nb::list vertices;
  for (const auto& v : report.vertices) {
    nb::dict vertex;
    vertex["kind"] = std::string(topology::to_string(v.kind));
    vertex["euler_characteristic"] = v.link_euler_characteristic;
    vertex["orientable"] = v.orientable;
    vertex["cone_points"] = v.cone_points;
    vertex["orbifold_euler_characteristic"] = v.orbifold_euler_characteristic;
    vertex["area"] = v.area;
    vertices.append(vertex);
  }
  d["vertices"] = vertices;
  d["flat_tetrahedra"] = report.flat_tetrahedra;
  if (report.certificate) d["certificate"] = structure::to_json(*report.certificate);
  if (report.strict_angles) d["angle_structure"] = structure::to_json(*report.strict_angles);
  if (report.closed_bigon) d["closed_bigon"] = as_dict(*report.closed_bigon);
  return d;
}

void bind_manifold(nb::module_& module) {
  nb::class_<Manifold> type(module, "Manifold", "tripus::Manifold");
  bind_topology(type);
  bind_metric_questions(type);
  module.def("load", [](const nb::bytes& input, const Limits& limits) {
    const std::string text = as_string(input);
    return run(limits, [&](const Context& context) { return load(text, context); });
  });
  bind_arrays(module);
  module.def("methods", structure::solve_method_names);
}

}  // namespace tripus::python
