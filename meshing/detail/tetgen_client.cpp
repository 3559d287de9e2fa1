#include <algorithm>
#include <csignal>

#include "base/error.hpp"
#include "base/stop.hpp"
#include "meshing/detail/child_process.hpp"
#include "meshing/detail/filling.hpp"
#include "meshing/detail/tetgen_protocol.hpp"
#include "meshing/find_tetgen.hpp"

namespace tripus::meshing::detail {
namespace {

using Transfer = ChildProcess::Transfer;

/// The talk with one process broke off.
struct BrokenOff {
  std::string problem;
  bool by_itself = false;  ///< it ended, or what it said makes no sense
};

class TetgenTalk {
 public:
  explicit TetgenTalk(const TetgenQuestion& question)
      : question_(question), child_(find_tetgen()) {}

  template <class Item>
  void send(const std::vector<Item>& items) {
    send(items.data(), items.size() * sizeof(Item));
  }
  void send(const void* data, std::size_t size) {
    require(child_.send(data, size, question_.deadline, question_.stop));
  }
  void receive(void* data, std::size_t size) {
    require(child_.receive(data, size, question_.deadline, question_.stop));
  }

 private:
  void require(Transfer transfer) {
    if (transfer == Transfer::kDone) return;
    if (transfer == Transfer::kTimeOut) throw BrokenOff{"TetGen was not done in time"};
    const std::string ending = child_.ending();
    if (child_.signal() == SIGXCPU) throw BrokenOff{"TetGen was not done in time"};
    throw_if_stopped(question_.stop);
    if (child_.signal() == SIGINT || child_.signal() == SIGTERM) throw Stopped();
    throw BrokenOff{"the mesher " + quoted(find_tetgen(), 200) + " " + ending, true};
  }

  const TetgenQuestion& question_;
  ChildProcess child_;
};

TetgenAnswer problem_of(std::uint64_t status) {
  switch (static_cast<TetgenStatus>(status)) {
    case TetgenStatus::kOutOfMemory:
      return {std::nullopt, "TetGen ran out of memory", true, false};
    case TetgenStatus::kSelfIntersection:
    case TetgenStatus::kTinyFeature:
      return {std::nullopt, "TetGen does not tell apart parts of the surface that are near", false,
              false};
    default:
      return {std::nullopt,
              "TetGen gave up on this surface (its error " + std::to_string(status) + ")", false,
              false};
  }
}

TetgenAnswer talk(const TetgenQuestion& question) {
  TetgenRequest request;
  request.memory_limit = question.memory_limit;
  request.processor_seconds = question.processor_seconds;
  request.max_volume = question.max_volume;
  request.keep_boundary = question.keep_boundary ? 1 : 0;
  request.points = question.points.size();
  request.triangles = question.triangles.size();
  request.holes = question.holes.size();
  TetgenTalk talk(question);
  talk.send(&request, sizeof request);
  talk.send(question.points);
  talk.send(question.triangles);
  talk.send(question.holes);
  TetgenResponse response;
  talk.receive(&response, sizeof response);
  if (response.mark != TetgenResponse::kMark)
    throw BrokenOff{"the answer of the mesher " + quoted(find_tetgen(), 200) +
                        " is damaged, or of another version",
                    true};
  if (static_cast<TetgenStatus>(response.status) != TetgenStatus::kDone)
    return problem_of(response.status);
  // A wrong count is not believed.
  const std::uint64_t most = question.memory_limit;
  if (response.points > most / sizeof(Point) || response.tetrahedra > most / sizeof(Tetrahedron))
    throw BrokenOff{"the answer of the mesher " + quoted(find_tetgen(), 200) + " is damaged", true};
  TetrahedralMesh mesh;
  mesh.points.resize(response.points);
  mesh.tetrahedra.resize(response.tetrahedra);
  talk.receive(mesh.points.data(), mesh.points.size() * sizeof(Point));
  talk.receive(mesh.tetrahedra.data(), mesh.tetrahedra.size() * sizeof(Tetrahedron));
  for (const Tetrahedron& t : mesh.tetrahedra)
    for (const std::uint32_t corner : t)
      if (corner >= mesh.points.size())
        throw BrokenOff{"the answer of the mesher " + quoted(find_tetgen(), 200) +
                            " is damaged: it names a corner that does not exist",
                        true};
  return {std::move(mesh), "", false, false};
}

}  // namespace

TetgenAnswer ask_tetgen(const TetgenQuestion& question) {
  try {
    return talk(question);
  } catch (const BrokenOff& broken_off) {
    return {std::nullopt, broken_off.problem, false, broken_off.by_itself};
  }
}

}  // namespace tripus::meshing::detail
