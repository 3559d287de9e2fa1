#include "base/compression.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include <zlib.h>

#include "base/error.hpp"

namespace tripus {
namespace {

/// Added to the size of the window, this makes zlib expect gzip's header.
constexpr int kGzipHeader = 16;

/// A stream that is ended whatever happens.
class Inflater {
 public:
  explicit Inflater(int window) {
    if (inflateInit2(&stream_, window) != Z_OK) throw InternalError("zlib could not be started");
  }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;
  ~Inflater() { inflateEnd(&stream_); }

  /// Takes one member off the front of `data` and appends what it holds.
  void member(std::string_view& data, std::string& out, std::size_t most) {
    if (inflateReset(&stream_) != Z_OK) throw InternalError("zlib could not be started");
    std::array<unsigned char, 1 << 16> block;
    for (int status = Z_OK; status != Z_STREAM_END;) {
      const std::size_t given = std::min<std::size_t>(data.size(), std::numeric_limits<int>::max());
      // zlib does not write to its input.
      stream_.next_in = reinterpret_cast<unsigned char*>(const_cast<char*>(data.data()));
      stream_.avail_in = static_cast<uInt>(given);
      stream_.next_out = block.data();
      stream_.avail_out = block.size();
      status = inflate(&stream_, Z_NO_FLUSH);
      const std::size_t made = block.size() - stream_.avail_out;
      if ((status != Z_OK && status != Z_STREAM_END && status != Z_BUF_ERROR) ||
          (made == 0 && stream_.avail_in == given && status != Z_STREAM_END))
        throw InvalidInput(given == 0 ? "the compressed data are cut off"
                                      : "the compressed data are damaged");
      data.remove_prefix(given - stream_.avail_in);
      if (made > most - out.size())
        throw InvalidInput("the compressed data hold more than " + std::to_string(most) + " bytes");
      out.append(reinterpret_cast<const char*>(block.data()), made);
    }
  }

 private:
  z_stream stream_{};
};

}  // namespace

bool is_gzip(std::string_view content) { return content.starts_with("\x1f\x8b"); }

std::string gunzip(std::string_view data, std::size_t most) {
  Inflater inflater(MAX_WBITS + kGzipHeader);
  std::string out;
  do {
    inflater.member(data, out, most);
  } while (is_gzip(data));
  return out;
}

std::string inflate_block(std::string_view data, std::size_t most) {
  Inflater inflater(MAX_WBITS);
  std::string out;
  inflater.member(data, out, most);
  return out;
}

}  // namespace tripus
