#pragma once

#include <string>

#include "structure/proof/detail/arb_number.hpp"

namespace tripus::structure::detail {

/// A number of a proof for its checker: binary, "0x1.3p-1", exactly, or decimal, "0.25e-3", within
/// Arb's rounding. Throws InvalidInput for anything else.
Arb read_number(const std::string& text);

}  // namespace tripus::structure::detail
