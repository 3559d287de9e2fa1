#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "topology/components.hpp"
#include "topology/detail/isosig_alphabet.hpp"
#include "topology/detail/text.hpp"
#include "topology/isosig.hpp"
#include "topology/orientation.hpp"

namespace tripus::topology {
namespace {

using detail::FaceAction;

/// Reads one component after another; every message carries the position of the character.
class SignatureReader {
 public:
  explicit SignatureReader(std::string_view text) : text_(text) {}

  Gluings read() {
    if (text_.empty())
      throw InvalidInput(
          "isomorphism signature: the text is empty; expected a signature such as "
          "cPcbbbihq");
    while (place_ < text_.size()) read_component();
    return std::move(gluings_);
  }

 private:
  struct Join {
    std::uint64_t destination;
    Perm4 perm;
    std::size_t destination_place;
  };

  [[noreturn]] void fail(std::size_t place, const std::string& what) const {
    throw InvalidInput("isomorphism signature " + quoted(std::string(text_.substr(0, 64))) +
                       ", character " + std::to_string(place + 1) + ": " + what);
  }

  int read_value(const char* expected) {
    if (place_ == text_.size())
      fail(place_, std::string("the signature ends here; expected ") + expected);
    const int value = detail::signature_value(text_[place_]);
    if (value < 0)
      fail(place_, quoted(std::string(1, text_[place_])) +
                       " is not a signature character (a-z, A-Z, 0-9, + and -); expected " +
                       expected);
    ++place_;
    return value;
  }

  std::uint64_t read_number(const char* expected) {
    std::uint64_t number = 0;
    for (unsigned i = 0; i < width_; ++i)
      number |= static_cast<std::uint64_t>(read_value(expected)) << (6 * i);
    return number;
  }

  /// The number of tetrahedra of the component; sets the width of numbers.
  std::size_t read_header() {
    const std::size_t begin = place_;
    width_ = 1;
    auto count = static_cast<std::uint64_t>(read_value("the number of tetrahedra"));
    if (count == detail::kFirstWideCount) {
      const int width = read_value("the number of characters per number");
      if (width < 1 || width > 10)
        fail(place_ - 1, "numbers of " + std::to_string(width) +
                             " characters; expected 1 to 10 characters per number");
      width_ = static_cast<unsigned>(width);
      count = read_number("the number of tetrahedra");
    }
    // 4 T faces take at least 2 T actions, three to a character.
    const std::size_t remaining = text_.size() - place_;
    if (count > 2 * remaining)
      fail(begin, "the header announces " + std::to_string(count) + " tetrahedra, but only " +
                      std::to_string(remaining) + " characters follow");
    if (gluings_.tetrahedron_count() + count > kMaxTetrahedra)
      fail(begin, "more than " + std::to_string(kMaxTetrahedra) + " tetrahedra");
    return static_cast<std::size_t>(count);
  }

  /// Fills actions_ and returns the number of joins.
  std::size_t read_actions(std::size_t count) {
    actions_.clear();
    std::size_t faces = 0;
    std::size_t joins = 0;
    while (faces < 4 * count) {
      int trits = read_value("what the next three faces do");
      for (int i = 0; i < 3; ++i, trits >>= 2) {
        const int action = trits & 3;
        if (faces == 4 * count) {
          if (action != 0)
            fail(place_ - 1, "actions for more faces than " + std::to_string(count) +
                                 " tetrahedra have; expected zeros");
          continue;
        }
        if (action == 3) fail(place_ - 1, "face action 3; expected 0, 1 or 2 for each face");
        faces += action == detail::kOpenFace ? 1 : 2;
        joins += action == detail::kToKnownTetrahedron;
        if (faces > 4 * count)
          fail(place_ - 1, "the face actions do not add up to the " + std::to_string(4 * count) +
                               " faces of " + std::to_string(count) + " tetrahedra");
        actions_.push_back(static_cast<FaceAction>(action));
      }
    }
    return joins;
  }

  void read_joins(std::size_t join_count) {
    joins_.clear();
    // Each join still has a character to come for its permutation and one for its destination.
    if (join_count > text_.size() - place_)
      fail(text_.size(), "the signature ends here; expected " + std::to_string(join_count) +
                             " destinations and as many permutations");
    for (std::size_t i = 0; i < join_count; ++i) {
      const std::size_t at = place_;
      joins_.push_back({read_number("the tetrahedron that a face is glued to"), Perm4(), at});
    }
    for (Join& join : joins_) {
      const int rank = read_value("a gluing permutation");
      if (rank >= 24)
        fail(place_ - 1, "permutation number " + std::to_string(rank) +
                             "; expected 0 to 23, "
                             "that is a to x");
      join.perm = Perm4::from_rank(rank);
    }
  }

  void read_component() {
    const std::size_t begin = place_;
    const std::size_t count = read_header();
    if (count == 0) return;  // Regina writes the empty triangulation as "a".
    read_joins(read_actions(count));
    const std::size_t base = gluings_.tetrahedron_count();
    gluings_.resize(base + count);
    std::size_t next_new = 1;
    auto action = actions_.begin();
    auto join = joins_.begin();
    for (std::size_t t = 0; t < count; ++t)
      for (int f = 0; f < 4; ++f) {
        if (!gluings_.is_open(base + t, f)) continue;
        const FaceAction what = *action++;
        if (what == detail::kToNewTetrahedron) {
          if (next_new >= count)
            fail(begin, "face " + std::to_string(f) + " of tetrahedron " + std::to_string(t) +
                            " is glued to a new tetrahedron, but all " + std::to_string(count) +
                            " have been met");
          glue(begin, base, t, f, next_new++, Perm4());
        } else if (what == detail::kToKnownTetrahedron) {
          if (join->destination >= next_new)
            fail(join->destination_place,
                 "a gluing to tetrahedron " + std::to_string(join->destination) + "; expected " +
                     "one that was met before, 0 to " + std::to_string(next_new - 1));
          glue(join->destination_place, base, t, f, static_cast<std::size_t>(join->destination),
               join->perm);
          ++join;
        }
      }
  }

  void glue(std::size_t place, std::size_t base, std::size_t t, int f, std::size_t other, Perm4 p) {
    const bool itself = other == t && p(f) == f;
    // Faces before this one have had their action: open ones are meant to stay so.
    const bool settled = other < t || (other == t && p(f) < f);
    if (itself || settled || !gluings_.is_open(base + other, p(f)))
      fail(place, "face " + std::to_string(f) + " of tetrahedron " + std::to_string(t) +
                      " is glued to " +
                      (itself ? "itself" : "a face that is glued already or declared open"));
    gluings_.glue(base + t, f, static_cast<TetrahedronIndex>(base + other), p);
  }

  std::string_view text_;
  std::size_t place_ = 0;
  unsigned width_ = 1;
  Gluings gluings_;
  std::vector<FaceAction> actions_;
  std::vector<Join> joins_;
};

}  // namespace

Gluings decode_isosig(std::string_view text) {
  Gluings gluings = SignatureReader(without_sign(text)).read();
  const char sign = isosig_sign(text);
  if (sign == 0) return gluings;
  const std::string whole = quoted(std::string(detail::trimmed(text)));
  if (components(gluings).size() > 1) {
    throw InvalidInput("isomorphism signature " + whole +
                       ": a sign at the end keeps the orientation " +
                       "of a connected triangulation, and this has several components");
  }
  if (!is_orientable(gluings)) {
    throw InvalidInput("isomorphism signature " + whole +
                       ": the triangulation is not orientable, " + "so the " + sign +
                       " at the end means nothing; leave it out");
  }
  gluings = oriented(gluings);
  return sign == '+' ? gluings : mirrored(gluings);
}

char isosig_sign(std::string_view text) {
  text = detail::trimmed(text);
  return text.size() > 1 && (text.back() == '+' || text.back() == '-') ? text.back() : '\0';
}

std::string_view without_sign(std::string_view text) {
  text = detail::trimmed(text);
  if (isosig_sign(text) != 0) text.remove_suffix(1);
  return text;
}

bool looks_like_isosig(std::string_view text) {
  text = detail::trimmed(text);
  if (text.empty()) return false;
  for (const char c : text)
    if (detail::signature_value(c) < 0) return false;
  return true;
}

}  // namespace tripus::topology
