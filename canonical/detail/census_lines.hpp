#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "canonical/census.hpp"

namespace tripus::canonical::detail {

/// Doubles hold a number of so many decimal digits, no less.
inline constexpr int kMostProvedDigits = 15;

/// Volumes with 15 digits or those that are proved, as a table shows them, or with all there are.
enum class VolumeDigits { kShown, kAll };

/// The lines of a table: manifolds, then what is unresolved.
std::vector<std::string> census_lines(const Census& census, VolumeDigits digits);

/// The surface by which the manifold of an unresolved triangulation is seen not to be hyperbolic:
/// "moebius band", "disc" or "essential annulus" (structure::closed_bigon); empty if none is seen,
/// which says nothing, and for a text that is no signature. Not kept: it follows from the
/// triangulation, and is made anew wherever a census is written.
std::string surface_in(const std::string& isosig);

/// Their checksums, eight hexadecimal digits each, parted by spaces.
std::string checksums_of(const std::vector<std::string>& lines);

/// The first line that has not its checksum; the number of lines if there are more or fewer of
/// them than checksums; nothing if all is as it was written.
std::optional<std::size_t> first_damaged(const std::vector<std::string>& lines,
                                         std::string_view checksums);

}  // namespace tripus::canonical::detail
