#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/stop.hpp"
#include "meshing/tetrahedral_mesh.hpp"

namespace tripus::meshing::detail {

/// One question to TetGen.
struct TetgenQuestion {
  std::vector<Point> points;
  std::vector<Triangle> triangles;
  std::vector<Point> holes;             ///< a point in each
  double max_volume = 0;                ///< 0: no matter
  bool keep_boundary = true;            ///< whether it is asked to; it does not always
  std::uint64_t memory_limit = 0;       ///< bytes
  std::uint64_t processor_seconds = 0;  ///< at most
  double deadline = 0;                  ///< of now_in_seconds
  Stop stop{};
};

/// A mesh of which nothing is promised but that its numbers are those of points, or why there is
/// none.
struct TetgenAnswer {
  std::optional<TetrahedralMesh> mesh;
  std::string problem;         ///< a sentence without its full stop
  bool out_of_memory = false;  ///< another try would end so as well
  bool mesher_failed = false;  ///< it crashed, or its answer makes no sense
};

/// Asks TetGen in a process of its own (tripus-tetgen), and ends that.
/// Throws Unsupported if the program is missing, IoError if it cannot be started, Stopped.
TetgenAnswer ask_tetgen(const TetgenQuestion& question);

}  // namespace tripus::meshing::detail
