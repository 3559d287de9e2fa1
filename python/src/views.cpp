#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <tripus/tripus.hpp>

#include "python/src/arrays.hpp"
#include "python/src/bindings.hpp"
#include "viewer/wall_discs.hpp"
#include "viewer/web/page.hpp"
#include "viewer/web/thumbnail.hpp"

namespace tripus::python {
namespace {

const Metric& require_metric(const Manifold& manifold, const Context& context) {
  const Metric* metric = manifold.metric(context);
  if (metric == nullptr)
    throw InvalidInput("there is no metric to show: " + manifold.verdict(context).message);
  if (!topology::all_full(manifold.cone_angles()))
    throw Unsupported("views do not know cone angles other than 2 pi so far");
  topology::require_geodesic_boundary(manifold.triangulation());
  return *metric;
}

/// The page as UTF-8.
nb::bytes page(const Manifold& manifold, std::size_t cells, const std::string& model, bool inside,
               bool with_discs, std::optional<double> length, const Limits& limits) {
  return as_bytes(run(limits, [&](const Context& context) {
    const Metric& metric = require_metric(manifold, context);
    std::optional<viewer::WallDiscs> discs;
    if (with_discs) {
      discs = viewer::find_wall_discs(metric.embedding(), manifold.triangulation(),
                                      metric.edge_lengths(), length, context);
    }
    viewer::PageOptions options;
    options.name = manifold.name().empty() ? manifold.label() : manifold.name();
    options.isosig = manifold.signature().value_or("");
    options.cells = cells;
    options.model = model;
    options.inside = inside;
    options.discs = discs ? &*discs : nullptr;
    return viewer::page_html(options, manifold.triangulation(), metric.report(),
                             metric.embedding());
  }));
}

/// Pixels [height x width x 4] of the view from the middle of tetrahedron 0.
Array<std::uint8_t> inside_picture(const Manifold& manifold, int width, int height,
                                   const Limits& limits) {
  if (width < 1 || height < 1 || width > viewer::kLargestSide || height > viewer::kLargestSide)
    throw InvalidInput("the sides of a picture are 1 to " + std::to_string(viewer::kLargestSide) +
                       " pixels, not " + std::to_string(width) + " and " + std::to_string(height));
  viewer::Image image = run(limits, [&](const Context& context) {
    const Metric& metric = require_metric(manifold, context);
    return viewer::inside_picture(metric.embedding(), manifold.triangulation(), width, height);
  });
  return owned(std::move(image.pixels), {std::size_t(height), std::size_t(width), 4});
}

}  // namespace

void bind_views(nb::module_& module) {
  module.def("page", page);
  module.def("inside_picture", inside_picture);
}

}  // namespace tripus::python
