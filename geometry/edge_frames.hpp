#pragma once

namespace tripus::geometry {

/// Position of the entry (i, j), i <= j, in the packed upper triangle of a 6 x 6 matrix.
constexpr int packed_index(int i, int j) { return i * 6 - i * (i - 1) / 2 + (j - i); }

/// The vertices of edge e = ij and of its opposite edge 5 - e = kl.
struct EdgeFrame {
  int i, j, k, l;
};
inline constexpr EdgeFrame kEdgeFrames[6] = {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2},
                                             {1, 2, 0, 3}, {1, 3, 0, 2}, {2, 3, 0, 1}};
/// The edge between two vertices.
inline constexpr int kEdgeBetween[4][4] = {
    {-1, 0, 1, 2}, {0, -1, 3, 4}, {1, 3, -1, 5}, {2, 4, 5, -1}};

}  // namespace tripus::geometry
