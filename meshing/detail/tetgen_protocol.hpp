#pragma once

#include <cstdint>

// What tripus and tripus-tetgen say to each other over a socket: each header is followed by its
// arrays, in the order of its counts. Both run on one machine and are built together, so numbers go
// as they lie in memory.

namespace tripus::meshing::detail {

struct TetgenRequest {
  static constexpr std::uint64_t kMark = 0x3373'7570'6972'7431;

  std::uint64_t mark = kMark;
  std::uint64_t memory_limit = 0;       ///< bytes of address space; 0: none
  std::uint64_t processor_seconds = 0;  ///< 0: no limit
  double max_volume = 0;                ///< of a tetrahedron; 0: no points are added for size
  std::uint64_t keep_boundary = 1;      ///< 0: new points may lie on it
  std::uint64_t points = 0;             ///< 3 doubles each
  std::uint64_t triangles = 0;          ///< 3 std::uint32_t each
  std::uint64_t holes = 0;              ///< a point of 3 doubles in each
};

enum class TetgenStatus : std::uint64_t {
  kDone = 0,
  kOutOfMemory = 1,
  kInternal = 2,  ///< TetGen calls it a bug of its own
  kSelfIntersection = 3,
  kTinyFeature = 4,
  kBadRequest = 100,
};

struct TetgenResponse {
  static constexpr std::uint64_t kMark = 0x3273'7570'6972'7432;

  std::uint64_t mark = kMark;
  std::uint64_t status = 0;  ///< TetgenStatus, or another code of TetGen
  std::uint64_t points = 0;
  std::uint64_t tetrahedra = 0;  ///< 4 std::uint32_t each
};

}  // namespace tripus::meshing::detail
