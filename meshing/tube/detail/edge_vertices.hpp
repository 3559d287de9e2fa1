#pragma once

#include <cstdint>
#include <vector>

namespace tripus::meshing::tube {

/// Numbers of the mesh vertices on lattice edges: a hash table with open addressing, keyed by the
/// two ends of an edge (60 bits each).
class EdgeVertices {
 public:
  EdgeVertices() : slots_(std::size_t{1} << 12) {}

  /// The vertex of the edge a b; `fresh` becomes it if there is none yet.
  std::uint32_t find_or_add(std::uint64_t a, std::uint64_t b, std::uint32_t fresh) {
    if (2 * (count_ + 1) > slots_.size()) grow();
    Slot& slot = slot_of(slots_, a, b);
    if (slot.vertex == kFree) {
      slot = {a, b, fresh};
      ++count_;
    }
    return slot.vertex;
  }

 private:
  static constexpr std::uint32_t kFree = 0xffffffff;
  struct Slot {
    std::uint64_t a = 0, b = 0;
    std::uint32_t vertex = kFree;
  };

  static Slot& slot_of(std::vector<Slot>& slots, std::uint64_t a, std::uint64_t b) {
    std::uint64_t h = a * 0x9e3779b97f4a7c15u ^ b * 0xc2b2ae3d27d4eb4fu;
    h ^= h >> 29;
    h *= 0xbf58476d1ce4e5b9u;
    h ^= h >> 32;
    const std::size_t mask = slots.size() - 1;
    std::size_t i = h & mask;
    while (slots[i].vertex != kFree && (slots[i].a != a || slots[i].b != b)) i = (i + 1) & mask;
    return slots[i];
  }

  void grow() {
    std::vector<Slot> larger(2 * slots_.size());
    for (const Slot& slot : slots_)
      if (slot.vertex != kFree) slot_of(larger, slot.a, slot.b) = slot;
    slots_ = std::move(larger);
  }

  std::vector<Slot> slots_;
  std::size_t count_ = 0;
};

}  // namespace tripus::meshing::tube
