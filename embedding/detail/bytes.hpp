#pragma once

#include <algorithm>
#include <bit>
#include <cstring>
#include <ostream>
#include <vector>

namespace tripus::embedding::detail {

/// Numbers as bytes in a given order, collected and written in one go.
class ByteBuffer {
 public:
  explicit ByteBuffer(std::endian order) : swap_(order != std::endian::native) {}

  template <class Number>
  void append(Number value) {
    char bytes[sizeof(Number)];
    std::memcpy(bytes, &value, sizeof(Number));
    if (swap_) std::reverse(bytes, bytes + sizeof(Number));
    data_.insert(data_.end(), bytes, bytes + sizeof(Number));
  }

  void write_to(std::ostream& out) {
    out.write(data_.data(), static_cast<std::streamsize>(data_.size()));
    data_.clear();
  }

 private:
  bool swap_;
  std::vector<char> data_;
};

}  // namespace tripus::embedding::detail
