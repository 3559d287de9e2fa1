#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "embedding/universal_cover.hpp"
#include "tests/support/embedded_manifolds.hpp"
#include "tests/support/one_renderer.hpp"

namespace tripus::viewer {

inline constexpr int kWidth = 200, kHeight = 150;

/// The universal cover of a manifold, as it is shown by default.
inline Scene scene_of(const testing::Embedded& manifold, std::size_t cells, Model model) {
  embedding::UniversalCoverOptions options;
  options.max_cells = cells;
  return make_scene("scene", manifold.embedding,
                    embedding::universal_cover(manifold.embedding, manifold.triangulation, options),
                    default_frame(model, manifold.embedding));
}

inline Image draw(const Scene& scene, const PictureOptions& options, Pixels pixels,
                  int width = kWidth, int height = kHeight) {
  return one_renderer().draw(scene, options, width, height, pixels);
}

/// The pixel numbers of an image, 0 for the background.
inline std::vector<std::uint32_t> numbers(const Image& image) {
  std::vector<std::uint32_t> result;
  for (std::size_t i = 0; i < image.pixels.size(); i += 4)
    result.push_back(image.pixels[i] + 256U * image.pixels[i + 1] + 65536U * image.pixels[i + 2]);
  return result;
}

/// Whether all pixels of an image within `reach` of one have its number.
inline bool is_alone(const std::vector<std::uint32_t>& of, int x, int y, int reach) {
  const auto at = [&](int i, int j) { return of[static_cast<std::size_t>(j * kWidth + i)]; };
  for (int j = std::max(0, y - reach); j <= std::min(kHeight - 1, y + reach); ++j)
    for (int i = std::max(0, x - reach); i <= std::min(kWidth - 1, x + reach); ++i)
      if (at(i, j) != at(x, y)) return false;
  return true;
}

}  // namespace tripus::viewer
