#pragma once

#include <cstddef>
#include <string>

#include "embedding/embedding.hpp"
#include "structure/report.hpp"
#include "topology/triangulation.hpp"
#include "viewer/wall_discs.hpp"

namespace tripus::viewer {

/// Pages hold every tetrahedron: about 3 KB each.
inline constexpr std::size_t kMostPageTetrahedra = 10'000;

/// The cells that the slider of a page reaches.
inline constexpr std::size_t kMostPageCells = 10'000;

/// What a page says and how it opens.
struct PageOptions {
  std::string name;                  ///< from outside: any bytes; the heading
  std::string isosig;                ///< empty where it is not known
  std::size_t cells = 20;            ///< shown at first, 1 to kMostPageCells
  std::string model = "ball";        ///< shown at first: "ball", "upper" or "klein"
  bool inside = false;               ///< whether it begins inside, else outside
  const WallDiscs* discs = nullptr;  ///< on the truncations; null: none
  std::string gallery;               ///< relative address of a page to go back to, empty for none
};

/// What the scripts of a page read, as JSON without "<" and "&" in its strings: the manifold, its
/// metric and embedding, and how the page opens.
///   report     of the same triangulation, geometric
///   embedding  of the same triangulation
/// Throws InvalidInput for a report that is not geometric, for options out of range, and
/// Unsupported beyond kMostPageTetrahedra.
std::string page_data(const PageOptions& options, const topology::Triangulation& triangulation,
                      const structure::Report& report, const embedding::Embedding& embedding);

}  // namespace tripus::viewer
