#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/texts.hpp"

namespace tripus::cli {
namespace {

using canonical::CanonicalManifold;
using canonical::CensusEntry;

/// "dihedral of order 6; 1 element of order 1, 3 of order 2, 2 of order 3"
std::string group_text(const canonical::IsometryGroup& group) {
  std::vector<std::string> parts;
  for (const auto& [order, count] : group.element_orders) {
    if (order > 1)
      parts.push_back(fmt::format("{}{} of order {}", count,
                                  parts.empty() ? (count == 1 ? " element" : " elements") : "",
                                  order));
  }
  return parts.empty() ? group.name : fmt::format("{}; {}", group.name, fmt::join(parts, ", "));
}

/// The sign of the orientation in the words of a person.
std::string chirality(const CanonicalManifold& manifold) {
  if (!manifold.decomposition.is_orientable()) return "non-orientable";
  return manifold.isometries.is_amphicheiral ? "amphicheiral" : "chiral";
}

}  // namespace

std::string cell_map_as_text(const canonical::CellMap& map) {
  std::vector<std::string> parts;
  for (std::size_t cell = 0; cell < map.cell_images.size(); ++cell) {
    parts.push_back(fmt::format("cell {} -> {}, vertices 0.. -> {}", cell, map.cell_images[cell],
                                fmt::join(map.vertex_images[cell], " ")));
  }
  return fmt::format("{}", fmt::join(parts, "; "));
}

std::string manifold_as_text(const CanonicalManifold& manifold) {
  std::string text;
  const auto line = [&](std::string_view label, const std::string& value) {
    text += fmt::format("  {:<14}{}\n", label, value);
  };
  const canonical::IsometryGroup& group = manifold.isometries;
  line("cells", manifold.cells);
  line("volume",
       fmt::format("{:.15g}, to within {:.1g}", manifold.report.volume, manifold.volume_error));
  line("signature", manifold.signature.unoriented);
  line("oriented", manifold.signature.oriented);
  line("isometries",
       manifold.decomposition.is_orientable()
           ? fmt::format("{}: {} keep the orientation, {} reverse it ({})", group.order,
                         group.orientation_preserving, group.order - group.orientation_preserving,
                         chirality(manifold))
           : fmt::format("{} (non-orientable)", group.order));
  if (!group.name.empty()) line("group", group_text(group));
  for (const auto& generator : group.generators) {
    line("generator", cell_map_as_text(canonical::as_cell_map(manifold.decomposition,
                                                              manifold.decomposition, generator)));
  }
  line("tilt sums", manifold.faces.precise
                        ? fmt::format("0 to within {:.1g} in 50 digits, or at least {:.3g} in size",
                                      manifold.faces.largest_zero, manifold.faces.margin)
                        : fmt::format("at least {:.3g} in size", manifold.faces.margin));
  if (!manifold.simplified.empty()) line("simplified to", manifold.simplified);
  line("moves", std::to_string(manifold.path.size()));
  return text;
}

std::string entry_as_text(const CensusEntry& entry) {
  return fmt::format("{:<12} {:<6} volume {:<18.15g} H1 {:<12} {}, isometries {} + {}, {}\n",
                     entry.name, entry.boundary, entry.volume, entry.homology, entry.cells,
                     entry.keeping, entry.reversing, entry.signature);
}

}  // namespace tripus::cli
