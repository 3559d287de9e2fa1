#include "cli/describe.hpp"

#include <algorithm>
#include <map>

#include <fmt/ranges.h>

#include "cli/remedies.hpp"
#include "topology/vertex_kinds.hpp"

namespace tripus::cli {
std::string objection_to(const topology::Triangulation& triangulation,
                         std::span<const topology::ConeAngle> cone_angles) {
  try {
    require_with_remedy(triangulation, cone_angles);
    return {};
  } catch (const InvalidInput& error) {
    return error.what();
  }
}

std::string printable(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f) {
      out += fmt::format("\\x{:02x}", byte);
    } else {
      out += c;
    }
  }
  return out;
}

std::string signature_text(const std::optional<std::string>& isosig) {
  constexpr std::size_t kMostShown = 2000;  // some 400 tetrahedra
  constexpr std::size_t kBeginning = 60;
  if (!isosig) return "not computed: it would take too long";
  if (isosig->size() <= kMostShown) return *isosig;
  return fmt::format("{}... ({} characters; --json gives it whole)", isosig->substr(0, kBeginning),
                     isosig->size());
}

std::string counted(std::size_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string shortened(const std::vector<std::string>& items, std::size_t limit) {
  if (items.size() <= limit) return fmt::format("{}", fmt::join(items, ", "));
  return fmt::format("{}, ... ({} in all)",
                     fmt::join(items.begin(), items.begin() + std::ptrdiff_t(limit), ", "),
                     items.size());
}

std::string one_line(const topology::Triangulation& m) {
  std::map<std::string, std::size_t> links;
  for (std::size_t v = 0; v < m.vertex_count(); ++v) {
    const auto& link = m.link(v);
    const std::string_view kind = link_kind(link);
    std::string name(kind);
    if (!link.orientable) {
      name = topology::surface_name(link).substr(2);
    } else if (kind == "geodesic") {
      name = fmt::format("genus {}", link.genus());
    }
    ++links[name];
  }
  std::vector<std::string> boundary;
  boundary.reserve(links.size());
  for (const auto& [name, count] : links)
    boundary.push_back(count == 1 ? name : fmt::format("{} x {}", count, name));
  return fmt::format(
      "{}, {}, {}; vertex links: {}", counted(m.tetrahedron_count(), "tetrahedron", "tetrahedra"),
      counted(m.edge_count(), "edge class", "edge classes"),
      m.is_orientable() ? "orientable" : "non-orientable", fmt::join(boundary, ", "));
}

}  // namespace tripus::cli
