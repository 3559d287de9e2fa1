// Four vertices of two tetrahedra in one plane, beside a face with an edge e, are a quadrilateral
// with e for a diagonal. Where the other side of the plane is two tetrahedra too, a 4-4 move
// changes the diagonal; where it is not, or where one tetrahedron lies on both sides, no move does
// that at once. A 2-3 move at the face makes the quadrilateral a flat tetrahedron, and moves at
// that follow.
#include "canonical/detail/flat_passage.hpp"

#include <cstdint>
#include <deque>
#include <string>
#include <unordered_set>
#include <vector>

#include "topology/labelled_isosig.hpp"

namespace tripus::canonical::detail {
namespace {

using topology::Move;
using topology::MoveKind;

constexpr std::size_t kMostFlat = 3;
/// Tetrahedra more than at the start, and triangulations to look at.
constexpr std::size_t kMoreTetrahedra = 4, kPassageBudget = 3000;

class Passage {
 public:
  Passage(const MetricState& stuck, const FaceKinds& faces,
          const std::function<bool(CarriedMetric&)>& attempt, const Stop& stop, std::size_t& budget)
      : budget_(budget),
        limit_(stuck.triangulation.tetrahedron_count() + kMoreTetrahedra),
        attempt_(attempt),
        stop_(stop) {
    open_.push_back(stuck);
    known_.insert(key(stuck));
    for (std::size_t t = 0; t < faces.kind.size(); ++t)
      for (int f = 0; f < 4; ++f)
        if (faces.kind[t][static_cast<std::size_t>(f)] == FaceKind::kConcave)
          start_.push_back(at_face(t, f));
  }

  bool run() {
    for (bool first = true; !open_.empty(); first = false) {
      const MetricState here = std::move(open_.front());
      open_.pop_front();
      for (const Move& move : first ? start_ : moves_at_flat(here)) {
        if (left_ == 0 || budget_ == 0 || stop_.requested()) return false;
        if (step(here, move)) return true;
      }
    }
    return false;
  }

 private:
  static std::string key(const MetricState& state) {
    return topology::labelled_isosig(state.triangulation, state.cone_angles);
  }

  static Move at_face(std::size_t t, int f) {
    return {MoveKind::kTwoThree, static_cast<topology::TetrahedronIndex>(t),
            static_cast<std::uint8_t>(f), 0, 0};
  }

  static std::vector<Move> moves_at_flat(const MetricState& state) {
    std::vector<Move> moves;
    for (const std::size_t t : state.report.flat_tetrahedra) {
      const auto tetrahedron = static_cast<topology::TetrahedronIndex>(t);
      for (std::uint8_t e = 0; e < 6; ++e) {
        const std::size_t valence =
            state.triangulation.valence(state.triangulation.edge_class(t, e));
        if (valence == 3) moves.push_back({MoveKind::kThreeTwo, tetrahedron, e, 0, 0});
        for (std::uint8_t axis = 0; valence == 4 && axis < 2; ++axis)
          moves.push_back({MoveKind::kFourFour, tetrahedron, e, axis, 0});
      }
      for (int f = 0; f < 4; ++f) moves.push_back(at_face(t, f));
    }
    return moves;
  }

  bool step(const MetricState& here, const Move& move) {
    const bool grows = move.kind == MoveKind::kTwoThree;
    if (here.triangulation.tetrahedron_count() + grows > limit_) return false;
    auto next = carried_metric(here, move);
    if (!next) return false;
    --left_;
    --budget_;
    if (!lay_out_flat(*next, kMostFlat) || !known_.insert(key(next->state)).second) return false;
    if (next->state.report.flat_tetrahedra.empty()) return attempt_(*next);
    open_.push_back(std::move(next->state));
    return false;
  }

  std::size_t& budget_;
  const std::size_t limit_;
  const std::function<bool(CarriedMetric&)>& attempt_;
  const Stop stop_;
  std::vector<Move> start_;
  std::deque<MetricState> open_;
  std::unordered_set<std::string> known_;
  std::size_t left_ = kPassageBudget;
};

}  // namespace

bool pass_through_planes(const MetricState& stuck, const FaceKinds& faces,
                         const std::function<bool(CarriedMetric&)>& attempt, const Stop& stop,
                         std::size_t& budget) {
  return Passage(stuck, faces, attempt, stop, budget).run();
}

}  // namespace tripus::canonical::detail
