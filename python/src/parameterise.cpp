#include "manifold/parameterise.hpp"

#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>

#include "python/src/arrays.hpp"
#include "python/src/bindings.hpp"
#include "python/src/meshes.hpp"

namespace tripus::python {
namespace {

ParameteriseOptions options_of(const std::string& weights, const std::string& method,
                               double tolerance, std::size_t tetrahedra, std::size_t refine,
                               std::uint64_t seed) {
  ParameteriseOptions options;
  options.marking.tetrahedralize.tetrahedra = tetrahedra;
  options.marking.seed = seed;
  options.refine = refine;
  options.weights = parameterise::weights_of(weights);
  options.map.tolerance = tolerance;
  options.map.minimiser = method == "ceres"     ? parameterise::Minimiser::kCeres
                          : method == "descent" ? parameterise::Minimiser::kDescent
                                                : parameterise::Minimiser::kNewton;
  return options;
}

template <class Value, class Get>
Array<Value> of_cells(const Parameterisation& self, Get&& get) {
  std::vector<Value> values;
  for (const parameterise::CellQuality& cell : self.quality().cells) values.push_back(get(cell));
  return owned(std::move(values));
}

template <class Points>
Array<double> rows_of(const Points& points, std::size_t width) {
  std::vector<double> values;
  for (const auto& point : points) values.insert(values.end(), point.data(), point.data() + width);
  return owned(std::move(values), {points.size(), width});
}

}  // namespace

void bind_parameterise(nb::module_& module) {
  nb::class_<Parameterisation>(module, "Parameterisation")
      .def("points_h3", [](const Parameterisation& self) { return rows_of(self.map().points, 4); })
      .def("points",
           [](const Parameterisation& self) { return rows_of(self.solid().mesh.points, 3); })
      .def("cells",
           [](const Parameterisation& self) {
             std::vector<std::uint32_t> values;
             for (const auto& t : self.solid().mesh.tetrahedra)
               values.insert(values.end(), t.begin(), t.end());
             return owned(std::move(values), {self.solid().mesh.tetrahedra.size(), 4});
           })
      .def("deck",
           [](const Parameterisation& self) {
             return owned(self.solid().corners, {self.solid().mesh.tetrahedra.size(), 4});
           })
      .def("deck_matrices",
           [](const Parameterisation& self) { return stacked(self.solid().group->matrices()); })
      .def("anisotropy",
           [](const Parameterisation& self) {
             return of_cells<double>(self, [](const auto& cell) { return cell.anisotropy; });
           })
      .def("volume_ratio",
           [](const Parameterisation& self) {
             return of_cells<double>(self, [](const auto& cell) { return cell.volume_ratio; });
           })
      .def("orientation",
           [](const Parameterisation& self) {
             return of_cells<std::int8_t>(
                 self, [](const auto& cell) { return static_cast<std::int8_t>(cell.orientation); });
           })
      .def("converged", &Parameterisation::converged)
      .def("to_json", [](const Parameterisation& self) { return as_bytes(self.to_json()); })
      .def("to_vtu",
           [](const Parameterisation& self) {
             return as_bytes(quickly([&] { return self.to_vtu(); }));
           })
      .def("to_page",
           [](const Parameterisation& self) {
             return as_bytes(quickly([&] { return self.to_page(); }));
           })
      .def("to_svg", [](const Parameterisation& self, double cut_away) {
        return as_bytes(quickly([&] { return self.to_svg(cut_away); }));
      });
  module.def("parameterise_file", [](const nb::bytes& path, const std::string& weights,
                                     const std::string& method, double tolerance,
                                     std::size_t tetrahedra, std::size_t refine, std::uint64_t seed,
                                     const Limits& limits) {
    const std::string place = as_string(path);
    const auto options = options_of(weights, method, tolerance, tetrahedra, refine, seed);
    return run(limits,
               [&](const Context& context) { return parameterise_solid(place, options, context); });
  });
  module.def("parameterise_mesh", [](const PointArray& points, const IndexArray& cells,
                                     const std::string& weights, const std::string& method,
                                     double tolerance, std::size_t tetrahedra, std::size_t refine,
                                     std::uint64_t seed, const Limits& limits) {
    const meshing::MeshFile file = mesh_of(points, cells);
    const auto options = options_of(weights, method, tolerance, tetrahedra, refine, seed);
    return run(limits, [&](const Context& context) {
      return Parameterisation(file, "mesh", options, context);
    });
  });
}

}  // namespace tripus::python
