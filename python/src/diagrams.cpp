#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>
#include <tripus/tripus.hpp>

#include "base/stop.hpp"
#include "drawing/drawing.hpp"
#include "manifold/load_diagram.hpp"
#include "python/src/bindings.hpp"
#include "topology/diagrams/small_exterior.hpp"
#include "topology/diagrams/tables.hpp"
#include "topology/diagrams/wirtinger.hpp"

namespace tripus::python {
namespace {

using topology::NamedDiagram;

/// (name, nodes as (kind, arcs), labels by arc as cone orders, whether the mirror image is known)
nb::tuple parts_of(const NamedDiagram& diagram) {
  nb::list nodes;
  for (const topology::DiagramNode& node : diagram.diagram.nodes())
    nodes.append(nb::make_tuple(node.kind == topology::NodeKind::kCrossing ? "X" : "V", node.arcs));
  nb::dict labels;
  for (const topology::DiagramLabel& label : diagram.labels)
    labels[nb::int_(label.arc)] = label.angle.order_text();
  return nb::make_tuple(as_bytes(diagram.name), nodes, labels, diagram.orientation_known);
}

NamedDiagram mirrored(const NamedDiagram& diagram) {
  NamedDiagram result = diagram;
  result.diagram = diagram.diagram.mirror_image();
  return result;
}

Manifold exterior_of(const NamedDiagram& diagram, const Limits& limits) {
  return run(limits, [&](const Context& context) {
    topology::SimplifyOptions options;
    options.stop = context.stop;
    options.progress = context.progress;
    topology::NamedGluings made = topology::small_exterior(diagram, options);
    for (const std::string& note : diagram.notes) context.note(note);
    throw_if_stopped(context.stop);
    return Manifold(std::move(made), topology::pd_text(diagram));
  });
}

std::string svg_of(const NamedDiagram& diagram, double size, bool colours, bool arcs) {
  drawing::SvgOptions options;
  options.size = size;
  options.title = diagram.name;
  options.colours = colours;
  options.arcs = arcs;
  return run({}, [&](const Context&) { return drawing::to_svg(diagram.diagram, options); });
}

/// Generators and relators; then for each strand whether it is closed, its meridian and longitude.
nb::tuple wirtinger_of(const NamedDiagram& diagram) {
  const auto group = quickly([&] { return topology::wirtinger_group(diagram.diagram); });
  nb::list strands;
  for (std::size_t s = 0; s < group.meridians.size(); ++s)
    strands.append(
        nb::make_tuple(group.strands.all[s].closed, group.meridians[s], group.longitudes[s]));
  return nb::make_tuple(group.presentation.generator_count, group.presentation.relators, strands);
}

std::vector<NamedDiagram> table(const std::string& name) {
  const auto found = topology::find_table(name);
  if (!found) throw InvalidInput("there is no table " + quoted(name));
  std::vector<NamedDiagram> diagrams;
  for (const topology::TabledDiagram& entry : topology::table_of(*found))
    diagrams.push_back({.name = entry.name, .diagram = entry.diagram});
  return diagrams;
}

}  // namespace

void bind_diagrams(nb::module_& module) {
  nb::class_<NamedDiagram>(module, "Diagram", "topology::NamedDiagram")
      .def("parts", parts_of)
      .def("text", [](const NamedDiagram& diagram) { return as_bytes(topology::pd_text(diagram)); })
      .def("crossing_count", [](const NamedDiagram& d) { return d.diagram.crossing_count(); })
      .def("mirrored", mirrored)
      .def("exterior", exterior_of)
      .def("svg", svg_of)
      .def("polylines",
           [](const NamedDiagram& d) {
             return run({}, [&](const Context&) { return drawing::to_polylines(d.diagram); });
           })
      .def("wirtinger", wirtinger_of)
      .def("renamed",
           [](const NamedDiagram& diagram, const nb::bytes& name) {
             NamedDiagram result = diagram;
             result.name = as_string(name);
             return result;
           })
      .def("with_name", [](const NamedDiagram& diagram, const nb::bytes& name, bool known) {
        NamedDiagram result = diagram;
        result.name = as_string(name);
        result.orientation_known = known;
        return result;
      });
  module.def("load_diagram", [](const nb::bytes& input) {
    const std::string text = as_string(input);
    return run({}, [&](const Context& context) {
      NamedDiagram loaded = load_diagram(text);
      for (const std::string& note : loaded.notes) context.note(note);
      return loaded;
    });
  });
  module.def("is_diagram", [](const nb::bytes& input) {
    const std::string text = as_string(input);
    return topology::looks_like_diagram(text) || topology::find_diagram_or_mirror(text);
  });
  module.def("diagram_tables", [] {
    std::vector<std::string> names;
    for (const topology::DiagramTable each : topology::kDiagramTables)
      names.emplace_back(topology::table_name(each));
    return names;
  });
  module.def("diagram_table", table);
}

}  // namespace tripus::python
