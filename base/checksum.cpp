#include "base/checksum.hpp"

namespace tripus {

std::string checksum_text(std::string_view text) {
  static constexpr char kHex[] = "0123456789abcdef";
  std::string out(16, '0');
  std::uint64_t value = checksum(text);
  for (auto digit = out.rbegin(); digit != out.rend(); ++digit, value >>= 4)
    *digit = kHex[value & 15];
  return out;
}

}  // namespace tripus
