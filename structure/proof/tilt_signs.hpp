#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "structure/proof/proof.hpp"

namespace tripus::structure {

enum class ProvedSign : std::int8_t { kNegative = -1, kUnknown = 0, kPositive = 1 };

/// Signs of the tilt sums of all faces at a proved metric, [T x 4], the same from both sides of a
/// face. Unknown: the enclosure contains 0, in doubles' lengths and again in lengths of 50 digits;
/// where the sum is 0 it always does. With cusps: of horospheres of one area that shrink, as
/// docs/canonical.md (T7).
///   proof  of this triangulation, proved, claim kMetric
/// Source: docs/theory.md (99).
std::vector<std::array<ProvedSign, 4>> tilt_signs(const topology::Triangulation& triangulation,
                                                  const Proof& proof, const Context& context = {});

}  // namespace tripus::structure
