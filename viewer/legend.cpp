#include "viewer/legend.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include <fmt/format.h>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_easy_font.h>
#pragma GCC diagnostic pop

namespace tripus::viewer {
namespace {

constexpr int kLeastWidth = 240, kLeastHeight = 160;
constexpr std::array<std::uint8_t, 4> kPaper{255, 255, 255, 205}, kInk{33, 41, 51, 255};

class Legend {
 public:
  explicit Legend(float scale) : scale_(scale) {}

  void fill(float left, float top, float right, float bottom, std::array<std::uint8_t, 4> colour) {
    rectangles_.push_back({left, top, right, bottom, colour});
  }

  float width(std::string text) const {  // the font's functions take it without const
    return scale_ * static_cast<float>(stb_easy_font_width(text.data()));
  }

  /// `anchor`: the share of the text that lies left of x.
  void write(std::string text, float x, float y, float anchor) {
    const float left = x - anchor * width(text);
    std::vector<char> quads(64 * 12 * (text.size() + 1));  // more than any letter needs
    const int count = stb_easy_font_print(0, 0, text.data(), nullptr, quads.data(),
                                          static_cast<int>(quads.size()));
    for (int n = 0; n < count; ++n) {  // four corners of x, y, z and a colour
      std::array<float, 2> low{}, high{};
      std::memcpy(low.data(), quads.data() + 64 * n, sizeof(low));
      std::memcpy(high.data(), quads.data() + 64 * n + 32, sizeof(high));
      fill(left + scale_ * low[0], y + scale_ * low[1], left + scale_ * high[0],
           y + scale_ * high[1], kInk);
    }
  }

  std::vector<LegendRectangle> rectangles() && { return std::move(rectangles_); }

 private:
  float scale_;
  std::vector<LegendRectangle> rectangles_;
};

void paint_one(Image& image, const LegendRectangle& rectangle) {
  const auto pixel = [](float x, int most) {
    return std::clamp(static_cast<int>(std::lround(x)), 0, most);
  };
  const int right = pixel(rectangle.right, image.width),
            bottom = pixel(rectangle.bottom, image.height);
  for (int y = pixel(rectangle.top, image.height); y < bottom; ++y) {
    for (int x = pixel(rectangle.left, image.width); x < right; ++x) {
      std::uint8_t* const at =
          image.pixels.data() +
          4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
               static_cast<std::size_t>(x));
      for (std::size_t c = 0; c < 3; ++c) {
        const int alpha = rectangle.colour[3];
        at[c] = static_cast<std::uint8_t>(
            (rectangle.colour[c] * alpha + at[c] * (255 - alpha) + 127) / 255);
      }
    }
  }
}

}  // namespace

std::vector<LegendRectangle> legend_of(const WallDiscs& discs, int width, int height) {
  if (width < kLeastWidth || height < kLeastHeight) return {};
  const auto scale = static_cast<float>(std::max(1, std::min(width / 600, height / 450)));
  const float border = 10 * scale, bar = 12 * scale, line = 12 * scale;
  const float long_side = std::min(200 * scale, static_cast<float>(width) - 4 * border);
  const float left = 2 * border, top = static_cast<float>(height) - 2 * border - bar - 2 * line;
  Legend legend(scale);
  legend.fill(border, top - border, left + long_side + border, static_cast<float>(height) - border,
              kPaper);
  constexpr int kSteps = 100;
  for (int n = 0; n < kSteps; ++n) {
    const auto rgb = orthospectrum::length_colour((n + 0.5) / kSteps);
    const auto at = [&](int step) { return left + long_side * static_cast<float>(step) / kSteps; };
    legend.fill(at(n), top, at(n + 1), top + bar, {rgb[0], rgb[1], rgb[2], 255});
  }
  constexpr int kLabels = 4;
  for (int n = 0; n <= kLabels; ++n) {
    const float share = static_cast<float>(n) / kLabels;
    legend.write(fmt::format("{:.3g}", discs.scale.shortest +
                                           share * (discs.scale.longest - discs.scale.shortest)),
                 left + share * long_side, top + bar + 0.3F * line,
                 n == 0 ? 0 : (n == kLabels ? 1 : 0.5F));
  }
  legend.write("discs by length of arc", left, top + bar + 1.4F * line, 0);
  return std::move(legend).rectangles();
}

std::vector<LegendRectangle> rectangles_of(std::span<const SceneLabel> labels, int scale) {
  const auto size = static_cast<float>(scale);
  Legend legend(size);
  for (const SceneLabel& label : labels) {
    const float half = legend.width(label.text) / 2;
    legend.fill(label.x - half - 2 * size, label.y - 6 * size, label.x + half + 2 * size,
                label.y + 6 * size, kPaper);
    legend.write(label.text, label.x, label.y - 4 * size, 0.5F);
  }
  return std::move(legend).rectangles();
}

void paint(Image& image, std::span<const LegendRectangle> rectangles) {
  for (const LegendRectangle& rectangle : rectangles) paint_one(image, rectangle);
}

void add_labels(const Scene& scene, const PictureOptions& options, const Image& identities,
                Image& image) {
  const int scale = image.height < 900 ? 1 : image.height / 450;
  paint(image, rectangles_of(labels_of(scene, options, identities), scale));
}

void add_legend(const Scene& scene, const PictureOptions& options, Image& image) {
  if (scene.discs == nullptr || !options.discs) return;
  paint(image, legend_of(*scene.discs, image.width, image.height));
}

}  // namespace tripus::viewer
