#pragma once

#include <string>
#include <string_view>

namespace tripus {

/// The bytes that base64 stands for, up to the first character that belongs to none; white space is
/// skipped. Parts that were encoded one by one, each with its own "=" at the end, are joined.
std::string decode_base64(std::string_view text);

std::string encode_base64(std::string_view bytes);

}  // namespace tripus
