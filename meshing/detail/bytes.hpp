#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "base/error.hpp"

namespace tripus::meshing::detail {

static_assert(std::endian::native == std::endian::little, "binary files are read on little endian");

/// The bytes of a number, the least significant first.
template <class Number>
void append_little_endian(std::string& out, Number value) {
  const auto bytes = std::bit_cast<std::array<char, sizeof(Number)>>(value);
  out.append(bytes.data(), bytes.size());
}

/// Numbers of a binary file.
class Bytes {
 public:
  Bytes(std::string_view format, std::string_view data, bool big_endian)
      : format_(format), rest_(data), size_(data.size()), big_endian_(big_endian) {}

  template <class Number>
  Number take(std::string_view what) {
    std::array<char, sizeof(Number)> bytes;
    if (rest_.size() < sizeof(Number))
      fail("the file ends where " + std::string(what) + " was expected");
    std::memcpy(bytes.data(), rest_.data(), sizeof(Number));
    rest_.remove_prefix(sizeof(Number));
    if (big_endian_) std::reverse(bytes.begin(), bytes.end());
    return std::bit_cast<Number>(bytes);
  }
  void skip(std::size_t count) { rest_.remove_prefix(std::min(count, rest_.size())); }
  std::string_view rest() const { return rest_; }

  [[noreturn]] void fail(const std::string& what) const {
    throw InvalidInput(std::string(format_) + ", byte " + std::to_string(size_ - rest_.size()) +
                       ": " + what);
  }
  /// For indices that were read: below `count`.
  std::uint32_t index(std::int64_t value, std::size_t count) const {
    if (value < 0 || static_cast<std::uint64_t>(value) >= count)
      fail("point " + std::to_string(value) + " does not exist; the file has " +
           std::to_string(count) + " points, numbered from 0");
    return static_cast<std::uint32_t>(value);
  }
  /// A count from a header, whose entries take so many bytes at least.
  void require_room(std::uint64_t entries, std::size_t bytes, std::string_view what) const {
    if (entries > rest_.size() / std::max<std::size_t>(bytes, 1))
      fail(std::to_string(entries) + " announced as the number of " + std::string(what) +
           ", more than the file is long enough for");
  }

 private:
  std::string_view format_;
  std::string_view rest_;
  std::size_t size_;
  bool big_endian_;
};

}  // namespace tripus::meshing::detail
