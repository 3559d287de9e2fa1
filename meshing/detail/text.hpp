#pragma once

#include <charconv>
#include <span>
#include <string>

namespace tripus::meshing::detail {

/// The numbers of one line, with the digits that read back to the same doubles.
inline void append_numbers(std::string& out, std::span<const double> numbers) {
  char digits[32];
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto end = std::to_chars(digits, digits + sizeof digits, numbers[i]).ptr;
    if (i > 0) out.push_back(' ');
    out.append(digits, end);
  }
  out.push_back('\n');
}

/// With the digits that read back to the same double; also nan and inf.
inline std::string number_text(double x) {
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, x).ptr};
}

/// What is wrong with a face of so many corners, after "face 3".
inline std::string not_a_triangle(std::size_t sides) {
  return " has " + std::to_string(sides) +
         " corners; only triangles are read: triangulate the surface first";
}

}  // namespace tripus::meshing::detail
