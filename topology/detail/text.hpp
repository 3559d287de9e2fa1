#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "topology/perm4.hpp"

namespace tripus::topology::detail {

// Independent of the locale, unlike <cctype>.
constexpr bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v';
}

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

constexpr std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

/// Takes the next run of non-space characters off the front; empty at the end.
constexpr std::string_view take_token(std::string_view& text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  std::size_t length = 0;
  while (length < text.size() && !is_space(text[length])) ++length;
  const auto token = text.substr(0, length);
  text.remove_prefix(length);
  return token;
}

/// Takes the next line off the front, without its end: \n, \r\n or, as on old Macintoshes, \r.
constexpr std::string_view take_line(std::string_view& text) {
  const std::size_t end = text.find_first_of("\r\n");
  const auto line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end);
  if (text.starts_with("\r\n"))
    text.remove_prefix(2);
  else if (!text.empty())
    text.remove_prefix(1);
  return line;
}

/// A decimal integer of at most 18 digits, with an optional minus sign, and nothing else.
constexpr std::optional<std::int64_t> parse_integer(std::string_view token) {
  const bool negative = token.starts_with('-');
  if (negative) token.remove_prefix(1);
  if (token.empty() || token.size() > 18) return std::nullopt;
  std::int64_t value = 0;
  for (const char c : token) {
    if (c < '0' || c > '9') return std::nullopt;
    value = 10 * value + (c - '0');
  }
  return negative ? -value : value;
}

/// Four digits 0..3, all different.
constexpr std::optional<Perm4> parse_perm(std::string_view token) {
  if (token.size() != 4) return std::nullopt;
  unsigned seen = 0;
  for (const char c : token) {
    if (c < '0' || c > '3') return std::nullopt;
    seen |= 1u << (c - '0');
  }
  if (seen != 15) return std::nullopt;
  return Perm4::from_images(token[0] - '0', token[1] - '0', token[2] - '0', token[3] - '0');
}

}  // namespace tripus::topology::detail
