#pragma once

#include <string>

#include <nanobind/nanobind.h>

#include "manifold/manifold.hpp"
#include "python/src/running.hpp"
#include "structure/report.hpp"
#include "structure/solve.hpp"

/// The extension tripus._core: plain functions and two classes. What users see, with names,
/// documentation and types, is Python (python/tripus); nothing is computed in either.
namespace tripus::python {

void bind_errors(nb::module_& module);
void bind_manifold(nb::module_& module);
void bind_arrays(nb::module_& module);
/// What is asked of any triangulation.
void bind_topology(nb::class_<Manifold>& type);
void bind_metric(nb::module_& module);
void bind_canonical(nb::module_& module);
void bind_diagrams(nb::module_& module);
void bind_files(nb::module_& module);
void bind_program(nb::module_& module);
void bind_solve_many(nb::module_& module);
void bind_studies(nb::module_& module);
void bind_views(nb::module_& module);

/// Names and paths may be any bytes; Python decodes them as it does file names.
inline std::string as_string(const nb::bytes& bytes) { return {bytes.c_str(), bytes.size()}; }
inline nb::bytes as_bytes(const std::string& text) { return nb::bytes(text.data(), text.size()); }

/// A metric with the manifold that it belongs to, which keeps it alive.
struct HeldMetric {
  Manifold manifold;
  const Metric* metric;
};

nb::dict orthospectrum_of(const HeldMetric& self, double length, std::size_t count,
                          double most_arcs, bool prove, const Limits& limits);
nb::tuple discs_of(const HeldMetric& self, double length, double most_arcs, const Limits& limits);
nb::str spots_svg(const HeldMetric& self, double length, const Limits& limits);

/// Cone angles [E]: a text is a cone order, a number an angle, a pair a rational multiple of pi.
std::vector<topology::ConeAngle> read_cone_angles(const nb::list& given);

/// A report as a dict; arrays are copies.
nb::dict as_dict(const structure::Report& report);
nb::dict as_dict(const structure::ClosedBigon& bigon);

}  // namespace tripus::python
