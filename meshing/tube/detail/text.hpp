#pragma once

#include <array>
#include <charconv>
#include <string>

#include "meshing/surface_mesh.hpp"

namespace tripus::meshing::tube {

/// A number with the 6 digits that a message needs.
inline std::string as_text(double value) {
  std::array<char, 32> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                 std::chars_format::general, 6);
  return {buffer.data(), end.ptr};
}

inline std::string as_text(const Point& p) {
  return "(" + as_text(p[0]) + ", " + as_text(p[1]) + ", " + as_text(p[2]) + ")";
}

}  // namespace tripus::meshing::tube
