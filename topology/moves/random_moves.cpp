#include <random>

#include "base/error.hpp"
#include "topology/moves/detail/surgery.hpp"
#include "topology/moves/moves.hpp"

namespace tripus::topology {
namespace {

/// Where one move alone is legal, about one draw in 300 (T + 1) hits it.
std::size_t max_refusals(const Gluings& gluings) {
  return 5000 * (gluings.tetrahedron_count() + 1);
}

// The standard distributions differ between libraries; the engine does not. The bias of the
// remainder is of no account here.
Move draw(const Gluings& gluings, MoveKind kind, std::mt19937_64& engine) {
  const MoveInfo& line = info(kind);
  Move move{.kind = kind};
  move.tetrahedron = static_cast<TetrahedronIndex>(engine() % gluings.tetrahedron_count());
  if (line.place != MovePlace::kTetrahedron)
    move.place = static_cast<std::uint8_t>(engine() % (line.place == MovePlace::kEdge ? 6 : 4));
  if (!line.choice_name.empty()) move.choice = static_cast<std::uint8_t>(engine() % 2);
  if (line.has_steps) {
    const auto start = EdgeWalk::start(move.tetrahedron, move.place);
    const std::size_t count = detail::valence(gluings, start);
    if (count > 0) move.steps = static_cast<std::uint32_t>(engine() % count);
  }
  return move;
}

}  // namespace

std::vector<Move> randomize(Gluings& gluings, const RandomMovesOptions& options) {
  std::vector<Move> made;
  if (options.kinds.empty() || gluings.tetrahedron_count() == 0) return made;
  std::mt19937_64 engine(options.seed);
  for (std::size_t refusals = 0; made.size() < options.count && refusals < max_refusals(gluings);) {
    const MoveKind kind = options.kinds[engine() % options.kinds.size()];
    const auto after =
        static_cast<std::ptrdiff_t>(gluings.tetrahedron_count()) + info(kind).tetrahedra;
    const Move move = draw(gluings, kind, engine);
    const bool grows_too_far =
        info(kind).tetrahedra > 0 && after > static_cast<std::ptrdiff_t>(options.max_tetrahedra);
    if (grows_too_far || !can_apply(gluings, move)) {
      ++refusals;
      continue;
    }
    info(kind).apply(gluings, move);
    made.push_back(move);
    refusals = 0;
  }
  return made;
}

}  // namespace tripus::topology
