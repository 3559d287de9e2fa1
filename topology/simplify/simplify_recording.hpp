#pragma once

#include "topology/simplify/record.hpp"
#include "topology/simplify/simplify.hpp"

namespace tripus::topology {

/// `simplify` that writes down its steps, from the table to the result, into an empty record. The
/// tetrahedra are taken in the order of the table, be it good for the caches or not.
/// Throws what `simplify` throws.
Simplified simplify_recording(const Gluings& closed, SimplificationRecord& record,
                              const SimplifyOptions& options = {});

}  // namespace tripus::topology
