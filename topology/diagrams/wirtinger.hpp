#pragma once

#include <vector>

#include "topology/covers/presentation.hpp"
#include "topology/diagrams/diagram.hpp"

namespace tripus::topology {

/// The fundamental group of the exterior with its peripheral elements.
struct WirtingerGroup {
  /// Generators: what is seen of the graph in one stretch from above, from where it comes up
  /// (or a vertex) to where it passes below (or a vertex); each a small loop around it, which goes
  /// under it from right to left as seen in the direction of the strand. Relators: one a crossing
  /// x_over^e x_out x_over^-e x_in^-1, one a vertex.
  Presentation presentation;
  Strands strands;
  /// [strands] a loop around the strand where it begins.
  std::vector<Word> meridians;
  /// [strands] the loop beside the strand: what it passes below. Of a closed one it ends where it
  /// began and is corrected by meridians, to be 0 in the homology of the knot's exterior; of
  /// another it says how a loop around its end is carried to its beginning.
  std::vector<Word> longitudes;
  /// [D] the generator of the stretch to which the arc belongs.
  std::vector<Letter> of_dart;
};

/// Diagrams in pieces give the free product, as they ought to. O(arcs).
WirtingerGroup wirtinger_group(const Diagram& diagram);

}  // namespace tripus::topology
