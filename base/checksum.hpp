#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace tripus {

/// FNV-1a, 64 bits. Every step is one to one in what came before, so that a text in which a single
/// byte was changed never has the same: it guards against damage, not against forgers.
constexpr std::uint64_t checksum(std::string_view text,
                                 std::uint64_t before = 0xcbf29ce484222325u) {
  for (const char c : text) before = (before ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return before;
}

/// The same as 16 hexadecimal digits.
std::string checksum_text(std::string_view text);

}  // namespace tripus
