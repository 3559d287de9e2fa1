#pragma once

#include <string>

#include "viewer/web/page_data.hpp"

namespace tripus::viewer {

/// One self-contained HTML page that shows the manifold from outside, as cells of the universal
/// cover, and from inside. It needs a browser with WebGL2, nothing from the network, and works from
/// a file.
///   report     of the same triangulation, geometric
///   embedding  of the same triangulation
/// Throws InvalidInput for a report that is not geometric, for options out of range, and
/// Unsupported beyond kMostPageTetrahedra.
std::string page_html(const PageOptions& options, const topology::Triangulation& triangulation,
                      const structure::Report& report, const embedding::Embedding& embedding);

}  // namespace tripus::viewer
