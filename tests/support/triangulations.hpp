#pragma once

#include <string>
#include <vector>

#include "topology/covers/cover_homology.hpp"
#include "topology/homology.hpp"
#include "topology/isosig.hpp"
#include "topology/moves/moves.hpp"
#include "topology/triangulation.hpp"

namespace tripus::testing {

inline topology::Triangulation decode(const std::string& signature) {
  return topology::Triangulation(topology::decode_isosig(signature));
}

/// Whether all gluings of faces are odd, so that labels agree with one orientation.
inline bool is_oriented(const topology::Gluings& gluings) {
  for (std::size_t t = 0; t < gluings.tetrahedron_count(); ++t)
    for (int f = 0; f < 4; ++f)
      if (!gluings.is_open(t, f) && !gluings.gluing(t, f).is_odd()) return false;
  return true;
}

inline std::vector<topology::MoveKind> every_kind_of_move() {
  std::vector<topology::MoveKind> kinds;
  for (const topology::MoveInfo& line : topology::move_table()) kinds.push_back(line.kind);
  return kinds;
}

inline topology::AbelianGroup abelianized(const topology::Presentation& group) {
  topology::TransitiveAction trivial{.degree = 1, .images = {}, .deck_group_order = 1};
  trivial.images.assign(group.generator_count, {0});
  return topology::first_homology(group, trivial);
}

}  // namespace tripus::testing
