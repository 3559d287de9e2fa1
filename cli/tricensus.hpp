#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "topology/enumerate.hpp"

namespace tripus::cli {

/// Runs Regina's program `tricensus` and calls `take` with the signature of each triangulation that
/// it finds and that is as asked for. False if it was interrupted, also
/// by --time-limit. Throws Unsupported where the program is not installed, IoError if it fails.
bool for_each_of_tricensus(std::size_t tetrahedra, const topology::EnumerationChoice& choice,
                           const std::function<void(const std::string&)>& take);

}  // namespace tripus::cli
