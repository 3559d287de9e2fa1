#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tripus {

/// Whether a content begins as gzip's does.
bool is_gzip(std::string_view content);

/// What gzip-compressed data hold, of all members if there are several.
/// Throws InvalidInput if they are damaged or cut off, or hold more than `most` bytes.
std::string gunzip(std::string_view data, std::size_t most);

/// What a block of zlib's own form holds; the same errors.
std::string inflate_block(std::string_view data, std::size_t most);

}  // namespace tripus
