#pragma once

#include <charconv>
#include <span>
#include <string>
#include <string_view>

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

/// In lower case.
inline std::string lowered(std::string_view word) {
  std::string low(word);
  for (char& c : low)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return low;
}

/// In any case of the letters; the ending in lower case.
inline bool has_ending(std::string_view name, std::string_view ending) {
  return name.size() >= ending.size() &&
         lowered(name.substr(name.size() - ending.size())) == ending;
}

}  // namespace tripus::meshing::detail
