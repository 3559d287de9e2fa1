#include "topology/moves/common_triangulation.hpp"

#include <algorithm>
#include <array>
#include <unordered_map>
#include <vector>

#include "topology/isosig.hpp"
#include "topology/moves/best_first.hpp"
#include "topology/moves/moves.hpp"
#include "topology/orientation.hpp"

namespace tripus::topology {
namespace {

constexpr std::array<MoveKind, 5> kMoves{MoveKind::kTwoOne, MoveKind::kTwoZeroEdge,
                                         MoveKind::kThreeTwo, MoveKind::kFourFour,
                                         MoveKind::kTwoThree};

/// What is known of one manifold: triangulations by signature, with their signs.
class Neighbourhood {
 public:
  Neighbourhood(const Gluings& start, std::size_t limit) : limit_(limit) { add(oriented(start)); }

  /// Makes all moves on the smallest triangulation not looked at. False if there is none.
  /// `visit` gets every new signature and returns true to stop.
  template <class Visit>
  bool grow(Visit&& visit) {
    if (!search_.has_open()) return false;
    const Gluings here = std::move(search_[search_.next()]);
    const Triangulation triangulation(here);
    for (const Move& move : all_moves(triangulation, kMoves)) {
      const auto size =
          static_cast<std::ptrdiff_t>(here.tetrahedron_count()) + info(move.kind).tetrahedra;
      if (size > static_cast<std::ptrdiff_t>(limit_)) continue;
      Gluings next = here;
      apply(next, move);
      const Isosig* added = add(std::move(next));
      if (added != nullptr && visit(*added)) return true;
    }
    return true;
  }

  const Isosig* find(const std::string& isosig) const {
    const auto found = known_.find(isosig);
    return found == known_.end() ? nullptr : &found->second;
  }
  std::size_t size() const { return known_.size(); }
  const Isosig& first() const { return *first_; }

 private:
  /// Null if it was known.
  const Isosig* add(Gluings gluings) {
    Isosig signature = full_isosig(gluings);
    const auto [entry, is_new] = known_.try_emplace(signature.isosig, signature);
    if (!is_new) return nullptr;
    if (first_ == nullptr) first_ = &entry->second;
    const std::size_t size = gluings.tetrahedron_count();
    search_.add(size, std::move(gluings));
    return &entry->second;
  }

  std::size_t limit_;
  BestFirst<Gluings> search_;
  std::unordered_map<std::string, Isosig> known_;
  const Isosig* first_ = nullptr;
};

CommonTriangulation meeting(const Isosig& first, const Isosig& second) {
  CommonTriangulation result{first.isosig, false, false};
  if (first.sign == 0) return result;
  const bool same = first.sign == second.sign;
  result.keeps_orientation = same || first.is_amphicheiral;
  result.reverses_orientation = !same || first.is_amphicheiral;
  return result;
}

}  // namespace

std::optional<CommonTriangulation> common_triangulation(const Gluings& first, const Gluings& second,
                                                        const CommonTriangulationOptions& options) {
  const std::size_t limit =
      std::max(first.tetrahedron_count(), second.tetrahedron_count()) + options.extra;
  std::array<Neighbourhood, 2> sides{Neighbourhood(first, limit), Neighbourhood(second, limit)};
  if (const Isosig* met = sides[0].find(sides[1].first().isosig))
    return meeting(*met, sides[1].first());
  std::optional<CommonTriangulation> found;
  for (bool growing = true; growing && !found;) {
    growing = false;
    for (std::size_t k = 0; k < 2 && !found; ++k) {
      if (options.stop.requested()) return std::nullopt;
      if (sides[k].size() >= options.budget) continue;
      growing |= sides[k].grow([&](const Isosig& here) {
        const Isosig* there = sides[1 - k].find(here.isosig);
        if (there != nullptr) found = k == 0 ? meeting(here, *there) : meeting(*there, here);
        return there != nullptr;
      });
    }
  }
  return found;
}

}  // namespace tripus::topology
