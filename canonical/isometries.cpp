#include "canonical/isometries.hpp"

#include "base/stop.hpp"
#include "canonical/group_name.hpp"
#include "topology/disjoint_sets.hpp"

namespace tripus::canonical {
namespace {

/// Orders flags breadth first from a start, comparing the code with the best so far as it grows.
class Orderer {
 public:
  explicit Orderer(const Decomposition& decomposition)
      : decomposition_(decomposition),
        width_(decomposition.cone_angles().empty() ? 4 : 5),
        number_(decomposition.flag_count(), kNoFlag) {
    queue_.reserve(decomposition.flag_count());
  }

  /// Less, equal or greater than the best code; the best is replaced if less.
  int compare_from(FlagIndex start, CanonicalOrder& best) {
    for (const FlagIndex flag : queue_) number_[flag] = kNoFlag;
    queue_.assign(1, start);
    number_[start] = 0;
    bool less = best.code.empty();
    if (less) best.code.resize(width_ * number_.size());
    for (std::size_t k = 0; k < queue_.size(); ++k) {
      for (std::size_t i = 0; i < width_; ++i) {
        const std::uint32_t value =
            i < 4 ? place_after(static_cast<int>(i), queue_[k]) : decomposition_.label(queue_[k]);
        std::uint32_t& entry = best.code[width_ * k + i];
        if (!less && value > entry) return 1;
        if (value < entry) less = true;
        if (less) entry = value;
      }
    }
    return less ? -1 : 0;
  }

  const std::vector<FlagIndex>& flags() const { return queue_; }

 private:
  /// The place of the flag that a step leads to, which takes the next one if it has none yet.
  std::uint32_t place_after(int step, FlagIndex flag) {
    const FlagIndex next = decomposition_.step(step, flag);
    if (number_[next] == kNoFlag) {
      number_[next] = static_cast<std::uint32_t>(queue_.size());
      queue_.push_back(next);
    }
    return number_[next];
  }

  const Decomposition& decomposition_;
  const std::size_t width_;  // of the code of a flag: four steps, and its label if there are any
  std::vector<std::uint32_t> number_;
  std::vector<FlagIndex> queue_;
};

std::vector<std::uint32_t> inverse(const std::vector<FlagIndex>& flags) {
  std::vector<std::uint32_t> number(flags.size());
  for (std::uint32_t k = 0; k < flags.size(); ++k) number[flags[k]] = k;
  return number;
}

/// The automorphism [F] that carries flags[0] of the order to `start`.
std::vector<FlagIndex> automorphism(const Decomposition& decomposition, const CanonicalOrder& order,
                                    FlagIndex start) {
  std::vector<FlagIndex> image(order.flags.size());
  image[order.flags[0]] = start;
  // Places are first reached from earlier ones.
  const std::size_t width = order.code.size() / order.flags.size();
  std::uint32_t reached = 1;
  for (std::uint32_t k = 0; k < reached; ++k) {
    for (int i = 0; i < 4; ++i) {
      if (order.code[width * k + static_cast<std::size_t>(i)] != reached) continue;
      image[order.flags[reached]] = decomposition.step(i, image[order.flags[k]]);
      ++reached;
    }
  }
  return image;
}

/// The orbits of flags under the automorphisms that are known so far: orders that begin in one
/// orbit have one code.
class Orbits {
 public:
  explicit Orbits(std::size_t flag_count) : flags_(flag_count), out_(flag_count) {}
  bool same(FlagIndex p, FlagIndex q) { return flags_.root(p) == flags_.root(q); }
  /// Whether the code from there is known to be larger than the least.
  bool is_out(FlagIndex flag) { return out_[flags_.root(flag)] != 0; }
  void put_out(FlagIndex flag) { out_[flags_.root(flag)] = 1; }
  void join(FlagIndex p, FlagIndex q) {
    const bool is_either_out = is_out(p) || is_out(q);
    flags_.join(p, q);
    if (is_either_out) put_out(q);
  }

 private:
  topology::DisjointSets flags_;
  std::vector<char> out_;
};

/// Adds to `member`, a group of automorphisms known by the images of one flag, what the generators
/// make of it.
void close(const std::vector<std::vector<FlagIndex>>& generators, FlagIndex base,
           std::vector<char>& member) {
  std::vector<FlagIndex> todo{base};
  member.assign(member.size(), 0);
  member[base] = 1;
  while (!todo.empty()) {
    const FlagIndex here = todo.back();
    todo.pop_back();
    for (const auto& generator : generators) {
      if (member[generator[here]]) continue;
      member[generator[here]] = 1;
      todo.push_back(generator[here]);
    }
  }
}

/// Beyond so many elements the table of a group takes too long to make.
constexpr std::size_t kMostNamed = 1000;

/// Element k carries flags[0] of the order to starts[k].
GroupTable group_table(const Decomposition& decomposition, const CanonicalOrder& order) {
  std::vector<std::uint32_t> number(decomposition.flag_count());
  for (std::uint32_t k = 0; k < order.starts.size(); ++k) number[order.starts[k]] = k;
  GroupTable table{order.starts.size(), {}};
  for (const FlagIndex start : order.starts) {
    const auto image = automorphism(decomposition, order, start);
    for (const FlagIndex other : order.starts) table.products.push_back(number[image[other]]);
  }
  return table;
}

}  // namespace

CanonicalOrder canonical_order(const Decomposition& decomposition, const Stop& stop) {
  CanonicalOrder best;
  Orderer orderer(decomposition);
  Orbits orbits(decomposition.flag_count());
  for (FlagIndex start = 0; start < decomposition.flag_count(); ++start) {
    throw_if_stopped(stop);
    if (orbits.is_out(start)) continue;
    if (start > 0 && orbits.same(start, best.flags[0])) {
      best.starts.push_back(start);
      continue;
    }
    const int comparison = orderer.compare_from(start, best);
    if (comparison > 0) {
      orbits.put_out(start);
      continue;
    }
    if (comparison < 0) {
      if (start > 0) orbits.put_out(best.flags[0]);
      best.starts.clear();
      best.flags = orderer.flags();
    } else {
      const auto image = automorphism(decomposition, best, start);
      for (FlagIndex flag = 0; flag < image.size(); ++flag) orbits.join(flag, image[flag]);
    }
    best.starts.push_back(start);
  }
  best.number = inverse(best.flags);
  best.cone_angles = decomposition.cone_angles();
  return best;
}

IsometryGroup isometry_group(const Decomposition& decomposition, const CanonicalOrder& order,
                             std::size_t boundary_component_count) {
  IsometryGroup group;
  group.order = order.starts.size();
  const FlagIndex base = order.flags[0];
  std::vector<char> member(decomposition.flag_count());
  member[base] = 1;
  for (const FlagIndex start : order.starts) {
    const bool preserving = decomposition.is_negative(start) == decomposition.is_negative(base);
    if (decomposition.is_orientable()) {
      group.orientation_preserving += preserving;
      group.is_amphicheiral = group.is_amphicheiral || !preserving;
    }
    if (member[start]) continue;
    group.generators.push_back(automorphism(decomposition, order, start));
    close(group.generators, base, member);
    std::vector<std::uint32_t> on_boundary(boundary_component_count);
    for (FlagIndex flag = 0; flag < decomposition.flag_count(); ++flag) {
      on_boundary[decomposition.boundary_component(flag)] =
          decomposition.boundary_component(group.generators.back()[flag]);
    }
    group.generators_on_boundary.push_back(std::move(on_boundary));
  }
  if (group.order <= kMostNamed) {
    const GroupTable table = group_table(decomposition, order);
    group.name = group_name(table);
    group.element_orders = element_orders(table);
  }
  return group;
}

std::vector<FlagIndex> isomorphism(const CanonicalOrder& from, const CanonicalOrder& to) {
  std::vector<FlagIndex> image(from.flags.size());
  for (std::size_t k = 0; k < image.size(); ++k) image[from.flags[k]] = to.flags[k];
  return image;
}

std::vector<std::vector<FlagIndex>> all_isomorphisms(const CanonicalOrder& from,
                                                     const Decomposition& to,
                                                     const CanonicalOrder& to_order) {
  const std::vector<FlagIndex> first = isomorphism(from, to_order);
  std::vector<std::vector<FlagIndex>> all;
  for (const FlagIndex start : to_order.starts) {
    std::vector<FlagIndex> image = automorphism(to, to_order, start);
    std::vector<FlagIndex> composed(first.size());
    for (std::size_t flag = 0; flag < first.size(); ++flag) composed[flag] = image[first[flag]];
    all.push_back(std::move(composed));
  }
  return all;
}

CellMap as_cell_map(const Decomposition& from, const Decomposition& to,
                    const std::vector<FlagIndex>& flag_images) {
  CellMap map;
  map.cell_images.resize(from.cell_count());
  map.vertex_images.resize(from.cell_count());
  for (FlagIndex flag = 0; flag < from.flag_count(); ++flag) {
    const std::uint32_t cell = from.cell(flag), vertex = from.vertex(flag);
    const FlagIndex image = flag_images[flag];
    map.cell_images[cell] = to.cell(image);
    auto& vertices = map.vertex_images[cell];
    if (vertices.size() <= vertex) vertices.resize(vertex + 1);
    vertices[vertex] = to.vertex(image);
  }
  return map;
}

}  // namespace tripus::canonical
