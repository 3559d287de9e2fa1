#include "base/error.hpp"
#include "base/output_file.hpp"
#include "viewer/picture.hpp"

// The encoder is compiled here, and nowhere else; its own warnings are not ours to mend.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#pragma GCC diagnostic ignored "-Wunused-function"
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace tripus::viewer {

void write_png(const Image& image, const std::string& path) {
  std::vector<std::uint8_t> encoded;
  const auto append = [](void* to, void* data, int size) {
    const auto* bytes = static_cast<const std::uint8_t*>(data);
    auto& out = *static_cast<std::vector<std::uint8_t>*>(to);
    out.insert(out.end(), bytes, bytes + size);
  };
  stbi_write_png_compression_level = 9;
  if (stbi_write_png_to_func(append, &encoded, image.width, image.height, 4, image.pixels.data(),
                             4 * image.width) == 0)
    throw InternalError("the picture could not be encoded as PNG");
  write_file(path, {reinterpret_cast<const char*>(encoded.data()), encoded.size()});
}

}  // namespace tripus::viewer
