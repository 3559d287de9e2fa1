#pragma once

#include <algorithm>
#include <string_view>

namespace tripus {

/// Whether a content begins with control characters that no text has. Tells files that cannot be
/// what was asked for before their bytes are taken for words.
inline bool is_binary(std::string_view content) {
  return std::ranges::any_of(content.substr(0, 4096), [](char c) {
    return c >= 0 && c < ' ' && std::string_view("\t\r\n\f\v").find(c) == std::string_view::npos;
  });
}

}  // namespace tripus
