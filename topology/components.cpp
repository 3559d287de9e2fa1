#include "topology/components.hpp"

#include <utility>

namespace tripus::topology {
namespace {

/// [T] component of each tetrahedron, numbered by first tetrahedron; and their number.
std::pair<std::vector<std::uint32_t>, std::size_t> label_components(const Gluings& gluings) {
  constexpr std::uint32_t kUnset = 0xffffffffu;
  const std::size_t count = gluings.tetrahedron_count();
  std::vector<std::uint32_t> label(count, kUnset);
  std::vector<std::size_t> stack;
  std::uint32_t next = 0;
  for (std::size_t first = 0; first < count; ++first) {
    if (label[first] != kUnset) continue;
    label[first] = next;
    stack.push_back(first);
    while (!stack.empty()) {
      const std::size_t t = stack.back();
      stack.pop_back();
      for (int f = 0; f < 4; ++f) {
        if (gluings.is_open(t, f)) continue;
        const std::size_t other = gluings.neighbour(t, f);
        if (label[other] != kUnset) continue;
        label[other] = next;
        stack.push_back(other);
      }
    }
    ++next;
  }
  return {std::move(label), next};
}

}  // namespace

std::vector<Gluings> components(const Gluings& gluings) {
  const auto [label, component_count] = label_components(gluings);
  const std::size_t count = gluings.tetrahedron_count();
  std::vector<std::size_t> size(component_count, 0);
  std::vector<TetrahedronIndex> new_index(count);
  for (std::size_t t = 0; t < count; ++t)
    new_index[t] = static_cast<TetrahedronIndex>(size[label[t]]++);
  std::vector<Gluings> parts;
  parts.reserve(component_count);
  for (const std::size_t part_size : size) parts.emplace_back(part_size);
  for (std::size_t t = 0; t < count; ++t)
    for (int f = 0; f < 4; ++f)
      if (!gluings.is_open(t, f))
        parts[label[t]].set_one_side(new_index[t], f, new_index[gluings.neighbour(t, f)],
                                     gluings.gluing(t, f));
  return parts;
}

std::vector<Triangulation> components(const Triangulation& triangulation) {
  std::vector<Triangulation> parts;
  for (Gluings& part : components(triangulation.gluings())) parts.emplace_back(std::move(part));
  return parts;
}

}  // namespace tripus::topology
