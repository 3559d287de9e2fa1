#include "topology/isomorphism.hpp"

#include <algorithm>
#include <random>
#include <string>

#include "base/error.hpp"
#include "base/stop.hpp"
#include "topology/components.hpp"

namespace tripus::topology {
namespace {

/// Extends "tetrahedron 0 of `from` goes to frame (t, p) of `to`" over the component of
/// tetrahedron 0, keeping its buffers from one frame to the next.
class FrameMatcher {
 public:
  FrameMatcher(const Gluings& from, const Gluings& to)
      : from_(from),
        to_(to),
        map_{std::vector<TetrahedronIndex>(from.tetrahedron_count(), kNoTetrahedron),
             std::vector<Perm4>(from.tetrahedron_count())},
        taken_(to.tetrahedron_count(), false) {
    queue_.reserve(from.tetrahedron_count());
  }

  bool match(TetrahedronIndex t, Perm4 p) {
    for (const TetrahedronIndex old : queue_) {
      taken_[map_.tetrahedron_images[old]] = false;
      map_.tetrahedron_images[old] = kNoTetrahedron;
    }
    queue_.clear();
    assign(0, t, p);
    // The queue grows while it is read. NOLINTNEXTLINE(modernize-loop-convert)
    for (std::size_t head = 0; head < queue_.size(); ++head)
      for (int f = 0; f < 4; ++f)
        if (!extend(queue_[head], f)) return false;
    return true;
  }
  const Isomorphism& map() const { return map_; }

 private:
  void assign(TetrahedronIndex from, TetrahedronIndex to, Perm4 p) {
    map_.tetrahedron_images[from] = to;
    map_.perms[from] = p;
    taken_[to] = true;
    queue_.push_back(from);
  }
  bool extend(TetrahedronIndex t, int f) {
    const TetrahedronIndex image = map_.tetrahedron_images[t];
    const Perm4 p = map_.perms[t];
    const int image_face = p(f);
    if (from_.is_open(t, f) || to_.is_open(image, image_face))
      return from_.is_open(t, f) && to_.is_open(image, image_face);
    const TetrahedronIndex next = from_.neighbour(t, f);
    const TetrahedronIndex next_image = to_.neighbour(image, image_face);
    const Perm4 next_perm = to_.gluing(image, image_face) * p * from_.gluing(t, f).inverse();
    if (map_.tetrahedron_images[next] != kNoTetrahedron)
      return map_.tetrahedron_images[next] == next_image && map_.perms[next] == next_perm;
    if (taken_[next_image]) return false;
    assign(next, next_image, next_perm);
    return true;
  }

  const Gluings& from_;
  const Gluings& to_;
  Isomorphism map_;
  std::vector<bool> taken_;
  std::vector<TetrahedronIndex> queue_;
};

std::optional<Isomorphism> match_connected(const Gluings& from, const Gluings& to) {
  if (from.tetrahedron_count() != to.tetrahedron_count()) return std::nullopt;
  FrameMatcher matcher(from, to);
  for (TetrahedronIndex t = 0; t < to.tetrahedron_count(); ++t)
    for (int rank = 0; rank < 24; ++rank)
      if (matcher.match(t, Perm4::from_rank(rank))) return matcher.map();
  return std::nullopt;
}

/// [component][index in it] = tetrahedron of the whole, in the numbering of components().
std::vector<std::vector<TetrahedronIndex>> members(const Gluings& gluings) {
  std::vector<std::vector<TetrahedronIndex>> result;
  std::vector<bool> seen(gluings.tetrahedron_count(), false);
  for (TetrahedronIndex first = 0; first < gluings.tetrahedron_count(); ++first) {
    if (seen[first]) continue;
    std::vector<TetrahedronIndex> part{first};
    seen[first] = true;
    for (std::size_t head = 0; head < part.size(); ++head)
      for (int f = 0; f < 4; ++f) {
        const TetrahedronIndex next = gluings.neighbour(part[head], f);
        if (next == kNoTetrahedron || seen[next]) continue;
        seen[next] = true;
        part.push_back(next);
      }
    std::ranges::sort(part);
    result.push_back(std::move(part));
  }
  return result;
}

/// Components are matched greedily, which is right because isomorphism is an equivalence.
std::optional<Isomorphism> match_components(const Gluings& from, const Gluings& to) {
  const auto from_parts = components(from);
  const auto to_parts = components(to);
  if (from_parts.size() != to_parts.size()) return std::nullopt;
  const auto from_members = members(from);
  const auto to_members = members(to);
  const std::size_t count = from.tetrahedron_count();
  Isomorphism whole{std::vector<TetrahedronIndex>(count), std::vector<Perm4>(count)};
  std::vector<bool> used(to_parts.size(), false);
  for (std::size_t i = 0; i < from_parts.size(); ++i) {
    std::optional<Isomorphism> part;
    for (std::size_t j = 0; j < to_parts.size() && !part; ++j) {
      if (used[j] || !(part = match_connected(from_parts[i], to_parts[j]))) continue;
      used[j] = true;
      for (std::size_t t = 0; t < from_members[i].size(); ++t) {
        whole.tetrahedron_images[from_members[i][t]] = to_members[j][part->tetrahedron_images[t]];
        whole.perms[from_members[i][t]] = part->perms[t];
      }
    }
    if (!part) return std::nullopt;
  }
  return whole;
}

}  // namespace

Gluings relabelled(const Gluings& gluings, const Isomorphism& isomorphism) {
  const std::size_t count = gluings.tetrahedron_count();
  const auto& images = isomorphism.tetrahedron_images;
  if (images.size() != count || isomorphism.perms.size() != count)
    throw InvalidInput("the relabelling is of " + std::to_string(images.size()) +
                       " tetrahedra, the triangulation has " + std::to_string(count));
  std::vector<bool> hit(count, false);
  for (std::size_t t = 0; t < count; ++t) {
    if (images[t] >= count || hit[images[t]])
      throw InvalidInput("the relabelling sends tetrahedron " + std::to_string(t) + " to " +
                         std::to_string(images[t]) + ", which is out of range or taken");
    hit[images[t]] = true;
  }
  Gluings result(count);
  for (std::size_t t = 0; t < count; ++t) {
    const Perm4 p = isomorphism.perms[t];
    for (int f = 0; f < 4; ++f) {
      if (gluings.is_open(t, f)) continue;
      const TetrahedronIndex other = gluings.neighbour(t, f);
      result.set_one_side(images[t], p(f), images[other],
                          isomorphism.perms[other] * gluings.gluing(t, f) * p.inverse());
    }
  }
  return result;
}

Isomorphism random_isomorphism(std::size_t tetrahedron_count, std::uint64_t seed) {
  // The standard distributions differ between libraries; the engine does not.
  std::mt19937_64 engine(seed);
  Isomorphism result;
  result.tetrahedron_images.resize(tetrahedron_count);
  result.perms.resize(tetrahedron_count);
  for (std::size_t t = 0; t < tetrahedron_count; ++t) {
    const std::size_t place = engine() % (t + 1);
    result.tetrahedron_images[t] = result.tetrahedron_images[place];
    result.tetrahedron_images[place] = static_cast<TetrahedronIndex>(t);
    result.perms[t] = Perm4::from_rank(static_cast<int>(engine() % 24));
  }
  return result;
}

Gluings random_relabelling(const Gluings& gluings, std::uint64_t seed) {
  return relabelled(gluings, random_isomorphism(gluings.tetrahedron_count(), seed));
}

std::optional<Isomorphism> find_isomorphism(const Gluings& from, const Gluings& to) {
  if (from.tetrahedron_count() != to.tetrahedron_count()) return std::nullopt;
  if (from.tetrahedron_count() == 0) return Isomorphism{};
  return match_components(from, to);
}

std::vector<Isomorphism> all_isomorphisms(const Gluings& from, const Gluings& to,
                                          const Stop& stop) {
  if (members(from).size() != 1)
    throw InvalidInput(
        "all isomorphisms are listed for connected triangulations only; this one "
        "has " +
        std::to_string(members(from).size()) + " components");
  std::vector<Isomorphism> found;
  if (from.tetrahedron_count() != to.tetrahedron_count()) return found;
  FrameMatcher matcher(from, to);
  for (TetrahedronIndex t = 0; t < to.tetrahedron_count(); ++t) {
    throw_if_stopped(stop);
    for (int rank = 0; rank < 24; ++rank)
      if (matcher.match(t, Perm4::from_rank(rank))) found.push_back(matcher.map());
  }
  return found;
}

}  // namespace tripus::topology
