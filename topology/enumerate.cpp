#include "topology/enumerate.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "base/error.hpp"

// A labelled triangulation is a word: tetrahedron 0 first, its faces in order, then those of the
// next; for every face that is not glued yet one symbol says what it is glued to. A tetrahedron
// that is met for the first time gets the next number, and such labels that the gluing is the
// identity. So a word is determined by the tetrahedron and the labels that it begins with, its
// frame: 24 T words of one triangulation, mirror images included. The least of them stands for it.
//
// The search writes words symbol by symbol. A word that has a smaller rival already, read from
// another frame, cannot be the beginning of a least one and is dropped with all that begins with
// it. A rival that meets a face that is open so far, or agrees to the end, stays; one that is
// larger stays larger and is never read again. Where the word is complete the rivals that agree are
// the automorphisms.
//
// Gluings of a tetrahedron to itself come first in the order, to new tetrahedra last: a rare
// feature anywhere rules out early all words that do not begin with it.

namespace tripus::topology {
namespace {

constexpr std::uint16_t kNewTetrahedron = 0xffff;
constexpr std::uint8_t kNobody = 0xff;
constexpr int kReversed = 1 << 20;  // for an edge glued to itself the other way round

/// Where a rival word stands.
enum class Rival { kSmaller, kLarger, kUndecided };

struct Frame {
  std::uint8_t tetrahedron;
  std::uint8_t labels;  ///< rank of old to new vertices
};

class Enumeration {
 public:
  using Take = std::function<void(const Gluings&, unsigned)>;

  Enumeration(std::size_t tetrahedra, const EnumerationChoice& choice, const Stop& stop)
      : count_(static_cast<int>(tetrahedra)),
        choice_(choice),
        // The Euler characteristics of the links add up to 2 E - 2 T.
        most_edges_(choice.links == LinkChoice::kCusped ? count_ : count_ - 1),
        stop_(stop) {
    neighbour_.fill(kNobody);
    gluing_.fill(0);
    sign_.fill(false);
    frames_.resize(2 * tetrahedra + 1);
    add_frames(0, frames_[0]);
  }

  /// All words that begin with the piece.
  std::uint64_t run(const EnumerationPiece& piece, const Take& take) {
    take_ = &take;
    if (replay(piece)) extend();
    return found_;
  }

  /// The beginnings of so many symbols, or whole words if these are shorter.
  std::vector<EnumerationPiece> pieces(std::size_t symbols) {
    piece_length_ = symbols;
    extend();
    return std::move(pieces_);
  }

 private:
  static constexpr std::size_t kFaces = 4 * kMaxEnumerated;
  static std::size_t slot(int t, int f) { return static_cast<std::size_t>(4 * t + f); }
  bool is_open(int t, int f) const { return neighbour_[slot(t, f)] == kNobody; }
  Perm4 gluing(int t, int f) const { return Perm4::from_rank(gluing_[slot(t, f)]); }
  static std::uint16_t symbol_of(int t, Perm4 p) {
    return static_cast<std::uint16_t>(24 * t + p.rank());
  }

  void set(int t, int f, int u, Perm4 p) {
    neighbour_[slot(t, f)] = static_cast<std::uint8_t>(u);
    gluing_[slot(t, f)] = static_cast<std::uint8_t>(p.rank());
    neighbour_[slot(u, p(f))] = static_cast<std::uint8_t>(t);
    gluing_[slot(u, p(f))] = static_cast<std::uint8_t>(p.inverse().rank());
  }
  void unset(int t, int f) {
    const int u = neighbour_[slot(t, f)];
    neighbour_[slot(u, gluing(t, f)(f))] = kNobody;
    neighbour_[slot(t, f)] = kNobody;
  }

  static void add_frames(int t, std::vector<Frame>& frames) {
    for (int rank = t == 0 ? 1 : 0; rank < 24; ++rank)  // the word's own frame is no rival
      frames.push_back({static_cast<std::uint8_t>(t), static_cast<std::uint8_t>(rank)});
  }

  /// Reads the word from another frame, as far as it goes.
  Rival compare(Frame frame) const {
    std::array<std::uint8_t, kMaxEnumerated> number, order;
    std::array<Perm4, kMaxEnumerated> labels;  // of old tetrahedra, old to new
    number.fill(kNobody);
    int met = 1;
    number[frame.tetrahedron] = 0;
    order[0] = frame.tetrahedron;
    labels[frame.tetrahedron] = Perm4::from_rank(frame.labels);
    for (std::size_t k = 0; k < length_; ++k) {
      // The words agree so far, so it is the same face's turn.
      const int t = order[place_[k] >> 2];
      const Perm4 from = labels[static_cast<std::size_t>(t)];
      const int f = from.inverse()(place_[k] & 3);
      if (is_open(t, f)) return Rival::kUndecided;
      const auto u = static_cast<std::size_t>(neighbour_[slot(t, f)]);
      const Perm4 p = gluing(t, f);
      std::uint16_t symbol = kNewTetrahedron;
      if (number[u] == kNobody) {
        labels[u] = from * p.inverse();
        number[u] = static_cast<std::uint8_t>(met);
        order[static_cast<std::size_t>(met++)] = static_cast<std::uint8_t>(u);
      } else {
        symbol = symbol_of(number[u], labels[u] * p * from.inverse());
      }
      if (symbol != word_[k]) return symbol < word_[k] ? Rival::kSmaller : Rival::kLarger;
    }
    return Rival::kUndecided;
  }

  /// Whether the word has no smaller rival; fills the rivals that remain.
  bool is_least(const std::vector<Frame>& before, std::vector<Frame>& after, bool met_new) const {
    after.clear();
    const auto consider = [&](Frame frame) {
      const Rival rival = compare(frame);
      if (rival == Rival::kUndecided) after.push_back(frame);
      return rival != Rival::kSmaller;
    };
    for (const Frame frame : before)
      if (!consider(frame)) return false;
    for (int rank = 0; met_new && rank < 24; ++rank)
      if (!consider({static_cast<std::uint8_t>(used_ - 1), static_cast<std::uint8_t>(rank)}))
        return false;
    return true;
  }

  /// How many edges the gluing of face f of t has closed. An edge is closed if going around it from
  /// the face leads back there; more than any number if one leads back the other way round.
  int closed_edges(int t, int f) const {
    const int u0 = neighbour_[slot(t, f)];
    const Perm4 g = gluing(t, f);
    const Perm4 back = g.inverse();
    unsigned seen = 0;  // corners of the face whose opposite edges have been gone around
    int closed = 0;
    for (int c0 = 0; c0 < 4; ++c0) {
      if (c0 == f || (seen >> c0 & 1)) continue;
      int tet = t, out = f, other = c0;
      const int first_end = c0 == 0 || f == 0 ? (c0 == 1 || f == 1 ? 2 : 1) : 0;
      int end = first_end;
      bool whole = false;
      while (!whole && !is_open(tet, out)) {
        if (tet == t && out == f) seen |= 1u << other;
        if (tet == u0 && out == g(f)) seen |= 1u << back(other);
        const Perm4 p = gluing(tet, out);
        const int next = neighbour_[slot(tet, out)];
        const int next_out = p(other), next_other = p(out);
        end = p(end);
        tet = next;
        out = next_out;
        other = next_other;
        whole = tet == t && out == f && other == c0;
      }
      if (whole && end != first_end) return kReversed;
      closed += whole;
    }
    return closed;
  }

  /// Writes a symbol and searches on, unless the word is dropped. `next` is called with the word.
  template <class Next>
  void with_symbol(int t, int f, std::uint16_t symbol, const Next& next) {
    const bool is_new = symbol == kNewTetrahedron;
    const int u = is_new ? used_ : symbol / 24;
    const Perm4 p = is_new ? Perm4() : Perm4::from_rank(symbol % 24);
    if (is_new) {
      sign_[static_cast<std::size_t>(u)] = !sign_[static_cast<std::size_t>(t)];
      ++used_;
    }
    set(t, f, u, p);
    word_[length_] = symbol;
    place_[length_] = static_cast<std::uint8_t>(slot(t, f));
    ++length_;
    const int closed = is_new ? 0 : closed_edges(t, f);
    const bool twisted = !is_new && reverses(t, u, p);
    edges_ += closed;
    twisted_ += twisted;
    if (edges_ <= most_edges_ && is_least(frames_[length_ - 1], frames_[length_], is_new)) next();
    twisted_ -= twisted;
    edges_ -= closed;
    --length_;
    unset(t, f);
    if (is_new) --used_;
  }

  /// Whether a gluing to a tetrahedron that is there disagrees with the orientations that are
  /// carried from tetrahedron 0 to new ones. One that agrees is odd between labels of one sign.
  bool reverses(int t, int u, Perm4 p) const {
    return p.is_odd() != (sign_[static_cast<std::size_t>(u)] == sign_[static_cast<std::size_t>(t)]);
  }

  /// The first open face in order; false if there is none.
  bool next_face(int& t, int& f) const {
    std::size_t k = length_ == 0 ? 0 : place_[length_ - 1] + 1u;
    for (; k < static_cast<std::size_t>(4 * used_); ++k) {
      if (neighbour_[k] != kNobody) continue;
      t = static_cast<int>(k >> 2);
      f = static_cast<int>(k & 3);
      return true;
    }
    return false;
  }

  void extend() {
    if (stop_.requested()) return;
    if (piece_length_ != 0 && length_ == piece_length_) {
      pieces_.push_back({{word_.begin(), word_.begin() + static_cast<std::ptrdiff_t>(length_)}});
      return;
    }
    int t = 0, f = 0;
    if (!next_face(t, f)) {
      if (used_ == count_) finish();
      return;
    }
    for (int u = t; u < used_; ++u)
      for (int rank = 0; rank < 24; ++rank) {
        const Perm4 p = Perm4::from_rank(rank);
        if (choice_.orientability == Orientability::kOrientable && reverses(t, u, p)) continue;
        if (!is_open(u, p(f)) || (u == t && p(f) == f)) continue;
        with_symbol(t, f, symbol_of(u, p), [this] { extend(); });
      }
    if (used_ < count_) with_symbol(t, f, kNewTetrahedron, [this] { extend(); });
  }

  /// Writes the symbols of a piece, one by one, and goes on after the last.
  bool replay(const EnumerationPiece& piece) {
    for (const std::uint16_t symbol : piece.symbols) {
      int t = 0, f = 0;
      if (!next_face(t, f)) return false;
      bool kept = false;
      const bool is_new = symbol == kNewTetrahedron;
      if (is_new) sign_[static_cast<std::size_t>(used_)] = !sign_[static_cast<std::size_t>(t)];
      const int u = is_new ? used_++ : symbol / 24;
      set(t, f, u, is_new ? Perm4() : Perm4::from_rank(symbol % 24));
      word_[length_] = symbol;
      place_[length_] = static_cast<std::uint8_t>(slot(t, f));
      ++length_;
      const Perm4 p = is_new ? Perm4() : Perm4::from_rank(symbol % 24);
      if (!is_new) edges_ += closed_edges(t, f);
      twisted_ += !is_new && reverses(t, u, p);
      kept = is_least(frames_[length_ - 1], frames_[length_], is_new);
      if (!kept) return false;
    }
    return true;
  }

  /// Whether the vertex links of the complete word are those that are wanted.
  bool has_wanted_links() const {
    std::array<std::uint8_t, kFaces> parent;
    for (std::size_t k = 0; k < parent.size(); ++k) parent[k] = static_cast<std::uint8_t>(k);
    const auto root = [&](std::size_t k) {
      while (parent[k] != k) k = parent[k] = parent[parent[k]];
      return k;
    };
    for (int t = 0; t < count_; ++t)
      for (int f = 0; f < 4; ++f)
        for (int v = 0; v < 4; ++v) {
          if (v == f) continue;
          const std::size_t a = root(slot(t, v));
          const std::size_t b = root(slot(neighbour_[slot(t, f)], gluing(t, f)(v)));
          parent[std::max(a, b)] = static_cast<std::uint8_t>(std::min(a, b));
        }
    // chi = ends of edges - triangles / 2; twice that is counted.
    std::array<int, kFaces> twice{};
    for (std::size_t k = 0; k < static_cast<std::size_t>(4 * count_); ++k) --twice[root(k)];
    add_edge_ends([&](std::size_t end) { twice[root(end)] += 2; });
    int tori = 0, larger = 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(4 * count_); ++k) {
      if (parent[k] != k) continue;
      if (twice[k] > 0) return false;
      ++(twice[k] == 0 ? tori : larger);
    }
    switch (choice_.links) {
      case LinkChoice::kGeodesic:
        return tori == 0;
      case LinkChoice::kMixed:
        return tori > 0 && larger > 0;
      case LinkChoice::kCusped:
        return larger == 0;
    }
    return false;
  }

  /// Calls `add` with a tetrahedron's vertex, 4 t + v, for both ends of each edge class.
  template <class Add>
  void add_edge_ends(const Add& add) const {
    std::array<bool, 16 * kMaxEnumerated> seen{};  // 16 t + 4 out + other: once around a class
    for (int t = 0; t < count_; ++t)
      for (int out = 0; out < 4; ++out)
        for (int other = 0; other < 4; ++other) {
          const auto code = [](int tet, int a, int b) {
            return static_cast<std::size_t>(16 * tet + 4 * a + b);
          };
          if (other == out || seen[code(t, out, other)]) continue;
          for (int v = 0; v < 4; ++v)
            if (v != out && v != other) add(slot(t, v));
          int tet = t, a = out, b = other;
          do {
            // Both senses of going around.
            seen[code(tet, a, b)] = true;
            seen[code(tet, b, a)] = true;
            const Perm4 p = gluing(tet, a);
            const int next = neighbour_[slot(tet, a)];
            const int next_a = p(b);
            b = p(a);
            a = next_a;
            tet = next;
          } while (tet != t || a != out || b != other);
        }
  }

  void finish() {
    if (choice_.orientability == Orientability::kNonOrientable && twisted_ == 0) return;
    if (!has_wanted_links()) return;
    ++found_;
    if (piece_length_ != 0) {  // a word shorter than pieces are
      pieces_.push_back({{word_.begin(), word_.begin() + static_cast<std::ptrdiff_t>(length_)}});
      return;
    }
    Gluings gluings(static_cast<std::size_t>(count_));
    for (int t = 0; t < count_; ++t)
      for (int f = 0; f < 4; ++f)
        gluings.set_one_side(static_cast<std::size_t>(t), f, neighbour_[slot(t, f)], gluing(t, f));
    (*take_)(gluings, 1 + static_cast<unsigned>(frames_[length_].size()));
  }

  const int count_;
  const EnumerationChoice choice_;
  const int most_edges_;
  Stop stop_;
  const Take* take_ = nullptr;
  std::size_t piece_length_ = 0;
  std::vector<EnumerationPiece> pieces_;
  std::uint64_t found_ = 0;

  std::array<std::uint8_t, kFaces> neighbour_, gluing_;
  std::array<bool, kMaxEnumerated> sign_;
  std::array<std::uint16_t, kFaces / 2> word_{};
  std::array<std::uint8_t, kFaces / 2> place_{};  // slot of the face that a symbol is about
  std::size_t length_ = 0;
  int used_ = 1, edges_ = 0;
  int twisted_ = 0;                         // gluings that no orientation agrees with
  std::vector<std::vector<Frame>> frames_;  // [length + 1] rivals that are not decided
};

void require_tetrahedra(std::size_t tetrahedra) {
  if (tetrahedra < 1 || tetrahedra > kMaxEnumerated)
    throw InvalidInput("triangulations with " + std::to_string(tetrahedra) +
                       " tetrahedra are not enumerated; ask for 1 to " +
                       std::to_string(kMaxEnumerated));
}

}  // namespace

std::string_view to_string(LinkChoice links) {
  switch (links) {
    case LinkChoice::kGeodesic:
      return "geodesic";
    case LinkChoice::kMixed:
      return "mixed";
    case LinkChoice::kCusped:
      return "cusped";
  }
  return "";
}

bool has_links(const Triangulation& triangulation, LinkChoice links) {
  std::size_t tori = 0;
  for (std::size_t v = 0; v < triangulation.vertex_count(); ++v) {
    const int characteristic = triangulation.link(v).euler_characteristic;
    if (characteristic > 0) return false;
    tori += characteristic == 0;
  }
  const std::size_t all = triangulation.vertex_count();
  switch (links) {
    case LinkChoice::kGeodesic:
      return tori == 0;
    case LinkChoice::kMixed:
      return tori > 0 && tori < all;
    case LinkChoice::kCusped:
      return tori == all;
  }
  return false;
}

bool is_chosen(const Triangulation& triangulation, const EnumerationChoice& choice) {
  const bool wanted =
      choice.orientability == Orientability::kBoth ||
      triangulation.is_orientable() == (choice.orientability == Orientability::kOrientable);
  return wanted && has_links(triangulation, choice.links);
}

std::vector<EnumerationPiece> enumeration_pieces(std::size_t tetrahedra,
                                                 const EnumerationChoice& choice) {
  require_tetrahedra(tetrahedra);
  // So long that there are enough for many workers, and so short that making them costs nothing.
  const std::size_t symbols = std::min<std::size_t>(tetrahedra, 6);
  return Enumeration(tetrahedra, choice, nullptr).pieces(symbols);
}

std::uint64_t enumerate(std::size_t tetrahedra, const EnumerationChoice& choice,
                        const EnumerationPiece& piece,
                        const std::function<void(const Gluings&, unsigned)>& take,
                        const Stop& stop) {
  require_tetrahedra(tetrahedra);
  return Enumeration(tetrahedra, choice, stop).run(piece, take);
}

}  // namespace tripus::topology
