#include <algorithm>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "topology/components.hpp"
#include "topology/detail/isosig_alphabet.hpp"
#include "topology/disjoint_sets.hpp"
#include "topology/isosig.hpp"
#include "topology/orientation.hpp"

// A starting frame (tetrahedron, labels of its vertices) fixes a labelling of the whole component:
// tetrahedra are numbered as a breadth-first search meets them, each labelled so that the gluing
// that first reaches it is the identity. The signature is the least string over all 24 T frames.
//
// The string has three sections: what each face does, the destinations, the permutations. All
// candidates have sections of equal lengths, so while the first section is being compared a
// candidate can be dropped at its first larger character; the first differences in the other two
// sections are only noted, since they count only if everything before them is equal.
//
// A candidate that ties with the best is a symmetry. Two frames that a symmetry carries into each
// other give one string, so frames are kept in orbits (union-find), merged by every symmetry found;
// each doubles the known group at least, so there are at most log2(24 T) merges.

namespace tripus::topology {
namespace {

using detail::kSignatureAlphabet;

char letter(std::uint32_t value) { return kSignatureAlphabet[value & 63]; }

/// Orders numbers as their written forms of `width` characters: lowest six bits first, by ASCII.
int compare_written(std::uint32_t x, std::uint32_t y, unsigned width) {
  for (unsigned i = 0; i < width; ++i, x >>= 6, y >>= 6)
    if (letter(x) != letter(y)) return letter(x) < letter(y) ? -1 : 1;
  return 0;
}

unsigned number_width(std::size_t tetrahedron_count) {
  if (tetrahedron_count < detail::kFirstWideCount) return 1;
  unsigned width = 0;
  for (; tetrahedron_count > 0; tetrahedron_count >>= 6) ++width;
  return width;
}

/// Orbits of frames 24 t + rank under the symmetries found so far; empty until the first.
class FrameOrbits {
 public:
  /// Below this size a second full pass costs less than the bookkeeping.
  static constexpr std::size_t kLeastTetrahedra = 24;

  bool is_first_of_orbit(std::size_t frame) {
    return frames_.size() == 0 || frames_.root(static_cast<std::uint32_t>(frame)) == frame;
  }
  /// Merges along the symmetry t -> image(t) with vertices moved by perm(t).
  template <class Image, class Perm>
  void merge(std::size_t tetrahedron_count, Image image, Perm perm) {
    if (frames_.size() == 0) frames_ = DisjointSets(24 * tetrahedron_count);
    for (std::size_t t = 0; t < tetrahedron_count; ++t) {
      const Perm4 back = perm(t).inverse();
      for (int rank = 0; rank < 24; ++rank) {
        const Perm4 moved = Perm4::from_rank(rank) * back;
        unite(static_cast<std::uint32_t>(24 * t) + static_cast<std::uint32_t>(rank),
              24 * image(t) + static_cast<std::uint32_t>(moved.rank()));
      }
    }
  }

 private:
  void unite(std::uint32_t x, std::uint32_t y) {
    // The least frame stays the root: it is the one that has been tried.
    const auto [least, other] = std::minmax({frames_.root(x), frames_.root(y)});
    frames_.join(other, least);
  }
  DisjointSets frames_;
};

/// The least string over the frames of the component of tetrahedron 0.
class ComponentEncoder {
 public:
  explicit ComponentEncoder(const Gluings& gluings)
      : gluings_(gluings),
        count_(gluings.tetrahedron_count()),
        width_(number_width(count_)),
        image_(count_, kNoTetrahedron),
        map_(count_),
        preimage_(count_) {
    candidate_.resize(count_);
    best_.resize(count_);
    best_preimage_.resize(count_);
    best_map_.resize(count_);
  }

  /// True if tetrahedron 0 reaches all the others.
  bool is_connected() {
    have_best_ = false;
    (void)try_frame(0, Perm4());
    return met_ == count_;
  }

  /// False if the work limit was reached. Only for connected tables.
  bool run(std::size_t work_limit) {
    FrameOrbits orbits;
    for (std::size_t t = 0; t < count_; ++t)
      for (int rank = 0; rank < 24; ++rank) {
        if (!orbits.is_first_of_orbit(24 * t + static_cast<std::size_t>(rank))) continue;
        const int order = try_frame(static_cast<TetrahedronIndex>(t), Perm4::from_rank(rank));
        if (work_ > work_limit) return false;
        if (order < 0) {
          keep_candidate();
        } else if (order == 0) {
          note_symmetry();
          if (count_ >= FrameOrbits::kLeastTetrahedra) merge_symmetry(orbits);
        }
      }
    return true;
  }

  std::string text() const {
    std::string out;
    out.reserve(count_ * (2 * width_ + 3) + 8);
    const auto write_number = [&](std::uint32_t value) {
      for (unsigned i = 0; i < width_; ++i, value >>= 6) out += letter(value);
    };
    if (count_ >= detail::kFirstWideCount) {
      out += letter(63);
      out += letter(width_);
    }
    write_number(static_cast<std::uint32_t>(count_));
    out.append(best_.actions.begin(), best_.actions.begin() + best_.action_count);
    for (std::size_t i = 0; i < best_.join_count; ++i) write_number(best_.destinations[i]);
    for (std::size_t i = 0; i < best_.join_count; ++i)
      out += letter(static_cast<std::uint32_t>(best_.perms[i].rank()));
    return out;
  }

  /// Of an orientable table: whether the best frame reverses its orientation, and whether there is
  /// a symmetry that does. Symmetries that were not tried are products of those that were.
  char sign() const { return !reversing_symmetry_ && is_reversed(best_frame_) ? '-' : '+'; }
  bool is_amphicheiral() const { return reversing_symmetry_; }
  /// For sign(): [T] which tetrahedra have labels of the other orientation. Empty: not wanted.
  void set_disagreeing(std::vector<char> disagreeing) { disagreeing_ = std::move(disagreeing); }

  Isomorphism isomorphism() const {
    Isomorphism result{std::vector<TetrahedronIndex>(count_), std::vector<Perm4>(count_)};
    for (std::size_t i = 0; i < count_; ++i) {
      result.tetrahedron_images[best_preimage_[i]] = static_cast<TetrahedronIndex>(i);
      result.perms[best_preimage_[i]] = best_map_[i];
    }
    return result;
  }

 private:
  struct Word {
    std::vector<char> actions;                // letters, three faces each
    std::vector<std::uint32_t> destinations;  // of joins
    std::vector<Perm4> perms;                 // of joins
    std::ptrdiff_t action_count = 0;
    std::size_t join_count = 0;

    void resize(std::size_t count) {
      actions.resize((4 * count + 2) / 3);
      destinations.resize(2 * count);
      perms.resize(2 * count);
    }
  };

  /// Appends an action to the candidate. False once the candidate is known to be larger.
  bool add_action(detail::FaceAction action) {
    pending_ |= static_cast<std::uint32_t>(action) << (2 * pending_count_);
    return ++pending_count_ < 3 || flush_actions();
  }
  bool flush_actions() {
    const char c = letter(pending_);
    const auto place = static_cast<std::size_t>(candidate_.action_count++);
    candidate_.actions[place] = c;
    pending_ = 0;
    pending_count_ = 0;
    if (smaller_) return true;
    const char rival = best_.actions[place];
    smaller_ = c < rival;
    return c <= rival;
  }
  void add_join(std::uint32_t destination, Perm4 p) {
    const std::size_t place = candidate_.join_count++;
    candidate_.destinations[place] = destination;
    candidate_.perms[place] = p;
    if (smaller_) return;
    if (destination_order_ == 0 && destination != best_.destinations[place])
      destination_order_ = compare_written(destination, best_.destinations[place], width_);
    if (perm_order_ == 0 && p != best_.perms[place])
      perm_order_ = compare_written(static_cast<std::uint32_t>(p.rank()),
                                    static_cast<std::uint32_t>(best_.perms[place].rank()), 1);
  }

  struct Frame {
    TetrahedronIndex first = 0;
    Perm4 labels;
  };
  bool is_reversed(Frame frame) const {
    return frame.labels.is_odd() != (disagreeing_[frame.first] != 0);
  }
  void note_symmetry() {
    if (disagreeing_.empty()) return;
    if (is_reversed(frame_) != is_reversed(best_frame_)) reversing_symmetry_ = true;
  }

  void start_frame(TetrahedronIndex first, Perm4 labels) {
    frame_ = {first, labels};
    for (std::size_t i = 0; i < met_; ++i) image_[preimage_[i]] = kNoTetrahedron;
    candidate_.action_count = 0;
    candidate_.join_count = 0;
    pending_ = 0;
    pending_count_ = 0;
    smaller_ = !have_best_;
    destination_order_ = 0;
    perm_order_ = 0;
    met_ = 1;
    image_[first] = 0;
    map_[first] = labels;
    preimage_[0] = first;
  }

  /// < 0, 0, > 0: the frame's string is smaller than the best, equal, larger.
  int try_frame(TetrahedronIndex first, Perm4 labels) {
    start_frame(first, labels);
    for (std::uint32_t here = 0; here < met_; ++here) {
      const TetrahedronIndex source = preimage_[here];
      const Perm4 map = map_[source];
      const Perm4 unmap = map.inverse();
      work_ += 4;
      for (int face_image = 0; face_image < 4; ++face_image) {
        const int face = unmap(face_image);
        const TetrahedronIndex other = gluings_.neighbour(source, face);
        if (other == kNoTetrahedron) {
          if (!add_action(detail::kOpenFace)) return 1;
          continue;
        }
        const Perm4 gluing = gluings_.gluing(source, face);
        const std::uint32_t there = image_[other];
        if (there == kNoTetrahedron) {
          image_[other] = met_;
          preimage_[met_++] = other;
          map_[other] = map * gluing.inverse();
          if (!add_action(detail::kToNewTetrahedron)) return 1;
          continue;
        }
        // Seen from the other side before?
        if (there < here || (there == here && map(gluing(face)) < face_image)) continue;
        add_join(there, map_[other] * gluing * unmap);
        if (!add_action(detail::kToKnownTetrahedron)) return 1;
      }
    }
    if (pending_count_ > 0 && !flush_actions()) return 1;
    if (smaller_) return -1;
    return destination_order_ != 0 ? destination_order_ : perm_order_;
  }

  void keep_candidate() {
    std::swap(candidate_, best_);
    have_best_ = true;
    best_frame_ = frame_;
    for (std::size_t i = 0; i < count_; ++i) {
      best_preimage_[i] = preimage_[i];
      best_map_[i] = map_[preimage_[i]];
    }
  }

  void merge_symmetry(FrameOrbits& orbits) {
    std::vector<TetrahedronIndex> best_image(count_);
    for (std::size_t i = 0; i < count_; ++i)
      best_image[best_preimage_[i]] = static_cast<TetrahedronIndex>(i);
    const auto image = [&](std::size_t t) { return preimage_[best_image[t]]; };
    orbits.merge(count_, image, [&](std::size_t t) {
      return map_[image(t)].inverse() * best_map_[best_image[t]];
    });
    work_ += 24 * count_;
  }

  const Gluings& gluings_;
  std::size_t count_;
  unsigned width_;
  std::vector<std::uint32_t> image_;             // [T] kNoTetrahedron: not met yet
  std::vector<Perm4> map_;                       // [T]
  std::vector<TetrahedronIndex> preimage_;       // [T]
  std::vector<TetrahedronIndex> best_preimage_;  // [T]
  std::vector<Perm4> best_map_;                  // [T] by image
  Word candidate_;
  Word best_;
  std::uint32_t met_ = 0;
  std::uint32_t pending_ = 0;
  int pending_count_ = 0;
  bool smaller_ = true;
  bool have_best_ = false;
  int destination_order_ = 0;
  int perm_order_ = 0;
  std::size_t work_ = 0;
  Frame frame_, best_frame_;
  std::vector<char> disagreeing_;  // [T] or empty
  bool reversing_symmetry_ = false;
};

constexpr std::size_t kNoLimit = static_cast<std::size_t>(-1);

}  // namespace

std::optional<Isosig> full_isosig(const Gluings& gluings, std::size_t work_limit) {
  if (gluings.tetrahedron_count() > 0) {
    ComponentEncoder whole(gluings);
    auto disagreeing = disagreeing_labels(gluings);
    if (disagreeing && whole.is_connected()) {
      whole.set_disagreeing(*std::move(disagreeing));
      if (!whole.run(work_limit)) return std::nullopt;
      return Isosig{whole.text(), whole.sign(), whole.is_amphicheiral()};
    }
  }
  auto plain = isosig(gluings, work_limit);
  if (!plain) return std::nullopt;
  return Isosig{*std::move(plain), '\0', false};
}

Isosig full_isosig(const Gluings& gluings) { return *full_isosig(gluings, kNoLimit); }

std::optional<std::string> isosig(const Gluings& gluings, std::size_t work_limit) {
  if (gluings.tetrahedron_count() == 0) return "a";
  ComponentEncoder whole(gluings);
  if (whole.is_connected()) {
    if (!whole.run(work_limit)) return std::nullopt;
    return whole.text();
  }
  std::vector<std::string> parts;
  for (const Gluings& part : components(gluings)) {
    ComponentEncoder encoder(part);
    if (!encoder.run(work_limit)) return std::nullopt;
    parts.push_back(encoder.text());
  }
  std::ranges::sort(parts);
  return std::accumulate(parts.begin(), parts.end(), std::string());
}

std::string isosig(const Gluings& gluings) { return *isosig(gluings, kNoLimit); }

CanonicalLabelling canonical_labelling(const Gluings& gluings) {
  if (gluings.tetrahedron_count() == 0)
    throw InvalidInput("a triangulation without tetrahedra has no canonical labelling");
  ComponentEncoder encoder(gluings);
  if (!encoder.is_connected())
    throw InvalidInput(
        "a canonical labelling is defined for connected triangulations only; take "
        "the components one by one");
  (void)encoder.run(kNoLimit);
  return {encoder.text(), encoder.isomorphism()};
}

}  // namespace tripus::topology
