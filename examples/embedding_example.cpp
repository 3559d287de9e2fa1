// From a signature to the first cells of the universal cover, as a file for a mesh viewer.
#include <cstdio>
#include <sstream>

#include "embedding/export/mesh_formats.hpp"
#include "structure/solve.hpp"
#include "topology/isosig.hpp"

int main() {
  using namespace tripus;
  const topology::Triangulation manifold(topology::decode_isosig("cPcbbbihq"));
  const structure::Report report = structure::solve(manifold);
  const embedding::Embedding placed = embedding::embed(manifold, report.edge_lengths);
  const auto cells = embedding::universal_cover(placed, manifold, {.max_cells = 20});
  const embedding::Tessellation drawn(placed, cells, {embedding::Model::kPoincareBall, 0.01});
  std::ostringstream file;
  embedding::write_ply(file, drawn);
  std::printf("%zu cells, %zu triangles, %zu bytes\n", cells.size(), drawn.triangle_count(),
              file.str().size());
  return cells.size() == 20 ? 0 : 1;
}
