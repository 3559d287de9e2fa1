#pragma once

#include <span>
#include <string_view>

#include <fmt/format.h>

#include "base/error.hpp"

namespace tripus {

/// A JSON text in the making. Numbers are printed with the digits that round-trip.
using JsonText = fmt::memory_buffer;

/// Appends a quoted and escaped string; bytes that are not UTF-8 become U+FFFD.
void append_string(JsonText& out, std::string_view text);

/// Appends a finite number. Throws InternalError for NaN and infinity, which never appear.
void append_number(JsonText& out, double value);

inline void append(JsonText& out, std::string_view text) {
  out.append(text.data(), text.data() + text.size());
}

/// Appends [a, b, ...] with one call of `append_item(out, item)` for each item.
template <class Range, class AppendItem>
void append_array(JsonText& out, const Range& items, AppendItem&& append_item) {
  out.push_back('[');
  bool first = true;
  for (const auto& item : items) {
    if (!first) append(out, ", ");
    first = false;
    append_item(out, item);
  }
  out.push_back(']');
}

void append_numbers(JsonText& out, std::span<const double> values);

/// A further member of an object, `, "key": value`.
void append_text_key(JsonText& out, std::string_view key, std::string_view value);
void append_number_key(JsonText& out, std::string_view key, double value);

/// {"tripus": ..., "input": ..., the start of every answer; no closing brace.
void append_header(JsonText& out, std::string_view input);

/// The kind of an error, as in its JSON: invalid-input, unsupported, interrupted, system, internal.
std::string_view error_kind(const std::exception& error);

/// The whole object of an error.
void append_error(JsonText& out, std::string_view input, std::string_view kind,
                  std::string_view message);

}  // namespace tripus
