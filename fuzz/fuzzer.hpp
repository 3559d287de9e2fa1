#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "base/error.hpp"
#include "topology/homology.hpp"
#include "topology/isosig.hpp"
#include "topology/triangulation.hpp"

namespace tripus::fuzz {

/// A property that must hold; a failure is a crash to libFuzzer.
inline void require(bool holds) {
  if (!holds) std::abort();
}

inline std::string_view as_text(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// Everything that must hold of a table that a parser let through.
inline void check_table(const topology::Gluings& gluings) {
  topology::require_consistent(gluings, topology::OpenFaces::kAllowed);
  const auto signature = topology::isosig(gluings, 2'000'000);
  if (signature) {
    const auto decoded = topology::decode_isosig(*signature);
    require(decoded.tetrahedron_count() == gluings.tetrahedron_count());
    const auto again = topology::isosig(decoded, 4'000'000);
    require(!again || again == signature);
  }
  try {
    const topology::Triangulation triangulation(gluings);
    if (triangulation.tetrahedron_count() <= 40) (void)first_homology(triangulation);
  } catch (const InvalidInput&) {
    // Open faces and reversed edges are refused; anything else is a crash.
  }
}

}  // namespace tripus::fuzz
