#pragma once

#include <cstdint>
#include <string_view>

namespace tripus::topology::detail {

/// The 64 characters of a signature; the value of a character is its place here.
inline constexpr std::string_view kSignatureAlphabet =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789+-";

/// The value 0..63 of a signature character, or -1.
constexpr int signature_value(char c) {
  if (c >= 'a' && c <= 'z') return c - 'a';
  if (c >= 'A' && c <= 'Z') return c - 'A' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+') return 62;
  if (c == '-') return 63;
  return -1;
}

/// Up to this many tetrahedra a number is one character; from here on the signature opens with
/// the marker 63, the number of characters a number takes, and numbers are written lowest six
/// bits first.
inline constexpr std::uint32_t kFirstWideCount = 63;

/// What a face does, in the order in which the faces are met.
enum FaceAction : std::uint8_t {
  kOpenFace = 0,
  kToNewTetrahedron = 1,   ///< the next unused one, by the identity
  kToKnownTetrahedron = 2  ///< one met before: its number and permutation follow further on
};

}  // namespace tripus::topology::detail
