#pragma once

#include <string_view>
#include <vector>

namespace tripus::cli {

/// Edge lengths from a text: numbers separated by white space or commas with # comments, a JSON
/// array of numbers, or a JSON object with "edge_lengths", such as an answer of `tripus solve`.
/// Throws InvalidInput naming the line or the entry; the numbers themselves are not judged.
std::vector<double> parse_lengths(std::string_view text);

/// An angle in radians: "6.28", "2pi", "2pi/3", "pi/2".
/// Throws InvalidInput.
double parse_angle(std::string_view text);

}  // namespace tripus::cli
