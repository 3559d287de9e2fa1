#include "manifold/canonical_json.hpp"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "topology/isosig.hpp"

namespace tripus {
namespace {

using canonical::CanonicalManifold;
using canonical::CensusEntry;

void append_indices(JsonText& out, const std::vector<std::uint32_t>& values) {
  append_array(out, values, [](JsonText& to, std::uint32_t value) {
    fmt::format_to(std::back_inserter(to), "{}", value);
  });
}

void append_cells(JsonText& out, const canonical::Decomposition& decomposition) {
  append(out, ", \"cells\": [");
  for (std::size_t cell = 0; cell < decomposition.cell_count(); ++cell) {
    const canonical::CellType type = canonical::cell_type(decomposition, cell);
    append(out, cell == 0 ? "{\"type\": " : ", {\"type\": ");
    append_string(out, type.name);
    fmt::format_to(std::back_inserter(out), ", \"vertex_count\": {}, \"face_sizes\": [{}]}}",
                   type.vertex_count, fmt::join(type.face_sizes, ", "));
  }
  out.push_back(']');
}

void append_isometries(JsonText& out, const CanonicalManifold& manifold) {
  const canonical::IsometryGroup& group = manifold.isometries;
  fmt::format_to(std::back_inserter(out),
                 ", \"isometry_group\": {{\"order\": {}, \"orientation_preserving\": {}, "
                 "\"amphicheiral\": {}, ",
                 group.order, group.orientation_preserving, group.is_amphicheiral);
  if (!group.name.empty()) {
    append(out, "\"name\": ");
    append_string(out, group.name);
    append(out, ", \"element_orders\": {");
    for (bool first = true; const auto& [order, count] : group.element_orders) {
      fmt::format_to(std::back_inserter(out), "{}\"{}\": {}", first ? "" : ", ", order, count);
      first = false;
    }
    append(out, "}, ");
  }
  append(out, "\"generators\": [");
  for (std::size_t k = 0; k < group.generators.size(); ++k) {
    append(out, k == 0 ? "{\"map\": " : ", {\"map\": ");
    append_cell_map(out, canonical::as_cell_map(manifold.decomposition, manifold.decomposition,
                                                group.generators[k]));
    append(out, ", \"boundary\": ");
    append_indices(out, group.generators_on_boundary[k]);
    out.push_back('}');
  }
  append(out, "]}");
}

}  // namespace

void append_cell_map(JsonText& out, const canonical::CellMap& map) {
  append(out, "{\"cells\": ");
  append_indices(out, map.cell_images);
  append(out, ", \"vertices\": ");
  append_array(out, map.vertex_images, [](JsonText& to, const std::vector<std::uint32_t>& images) {
    append_indices(to, images);
  });
  out.push_back('}');
}

void append_manifold(JsonText& out, const CanonicalManifold& manifold) {
  append_number_key(out, "volume", manifold.report.volume);
  append_number_key(out, "volume_error", manifold.volume_error);
  append_text_key(out, "decomposition", manifold.cells);
  append_cells(out, manifold.decomposition);
  append_text_key(out, "signature", manifold.signature.unoriented);
  append_text_key(out, "oriented_signature", manifold.signature.oriented);
  append_isometries(out, manifold);
  fmt::format_to(std::back_inserter(out), ", \"tilts\": {{\"precise\": {}", manifold.faces.precise);
  append_number_key(out, "largest_zero", manifold.faces.largest_zero);
  append(out, ", \"margin\": ");
  if (std::isfinite(manifold.faces.margin)) {
    append_number(out, manifold.faces.margin);
  } else {
    append(out, "null");
  }
  out.push_back('}');
  append_text_key(out, "triangulation", topology::isosig(manifold.triangulation.gluings()));
  if (!manifold.simplified.empty()) append_text_key(out, "simplified", manifold.simplified);
  append(out, ", \"path\": ");
  append_array(out, manifold.path, [](JsonText& to, const topology::Move& move) {
    append_string(to, topology::to_string(move));
  });
}

void append_entry(JsonText& out, const CensusEntry& entry) {
  append(out, "{\"name\": ");
  append_string(out, entry.name);
  fmt::format_to(std::back_inserter(out), ", \"tetrahedra\": {}", entry.tetrahedra);
  append_text_key(out, "boundary", entry.boundary);
  append_number_key(out, "volume", entry.volume);
  append_text_key(out, "H1", entry.homology);
  append_text_key(out, "decomposition", entry.cells);
  fmt::format_to(std::back_inserter(out),
                 ", \"orientation_preserving\": {}, \"orientation_reversing\": {}", entry.keeping,
                 entry.reversing);
  append_text_key(out, "signature", entry.signature);
  append(out, ", \"triangulations\": ");
  append_array(out, entry.triangulations,
               [](JsonText& to, const std::string& isosig) { append_string(to, isosig); });
  out.push_back('}');
}

}  // namespace tripus
