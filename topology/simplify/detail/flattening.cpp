#include "topology/simplify/detail/flattening.hpp"

#include <utility>

#include "topology/simplify/carry_back.hpp"

namespace tripus::topology::detail {

void Flattening::reset(std::size_t slot_count) {
  ports_.clear();
  port_of_.assign(slot_count, 0);
}

void Flattening::clear() {
  for (const Port& each : ports_) port_of_[slot_of(each.t, each.f)] = 0;
  ports_.clear();
}

const Port* Flattening::port(TetrahedronIndex t, int f) const {
  const std::uint32_t number = port_of_[slot_of(t, f)];
  return number == 0 ? nullptr : &ports_[number - 1];
}

/// Out of face f of t, on through what is flattened, to the tetrahedron that stays.
std::tuple<TetrahedronIndex, Perm4> Flattening::chain_end(const Gluings& before, TetrahedronIndex t,
                                                          int f, Perm4 map) const {
  while (true) {
    const Perm4 p = before.gluing(t, f);
    t = before.neighbour(t, f);
    f = p(f);
    map = p * map;
    const Port* behind = port(t, f);
    if (behind == nullptr) return {t, map};
    map = behind->map * map;
    f = behind->map(f);
    t = behind->other;
  }
}

void Flattening::find_near(const Gluings& before) {
  for (std::uint32_t i = 0; i < ports_.size(); ++i)
    port_of_[slot_of(ports_[i].t, ports_[i].f)] = i + 1;
  for (Port& start : ports_) {
    if (start.near != kNoTetrahedron || port(before.neighbour(start.t, start.f),
                                             before.gluing(start.t, start.f)(start.f)) != nullptr)
      continue;
    // An end of a chain. The other one:
    const TetrahedronIndex one = before.neighbour(start.t, start.f);
    const Perm4 out = before.gluing(start.t, start.f);
    const auto [two, map] = chain_end(before, start.other, start.map(start.f), start.map);
    // Labels of the face at the end `one`, in terms of those of the end `two`.
    const bool near_is_one = std::pair(one, out(start.f)) < std::pair(two, map(start.f));
    const TetrahedronIndex near = near_is_one ? one : two;
    Perm4 labels = near_is_one ? out : map;  // of the tetrahedron that the walk is in
    Port* here = &start;
    while (true) {
      here->near = near;
      here->to_near = labels;
      labels = labels * here->map.inverse();
      Port& far = ports_[port_of_[slot_of(here->other, here->map(here->f))] - 1];
      far.near = near;
      far.to_near = labels;
      const Perm4 p = before.gluing(far.t, far.f);
      const std::uint32_t next = port_of_[slot_of(before.neighbour(far.t, far.f), p(far.f))];
      if (next == 0) break;
      labels = labels * p.inverse();
      here = &ports_[next - 1];
    }
  }
}

}  // namespace tripus::topology::detail
