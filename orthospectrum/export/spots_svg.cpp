#include "orthospectrum/export/spots_svg.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "base/svg_text.hpp"
#include "orthospectrum/boundary_discs.hpp"

namespace tripus::orthospectrum {
namespace {

constexpr double kDisc = 600;                                // pixels
constexpr int kLetters = 14;                                 // pixels
constexpr double kBorder = 20;                               // around a disc
constexpr double kFooter = 45;                               // for the scale of lengths
constexpr double kSmallestSpot = 0.35, kSmallestTile = 1.5;  // pixels
constexpr double kDrawnRadius = 6;                           // hyperbolic
constexpr std::size_t kMostTiles = 6000;

std::string colour_of(double share) {
  const LengthColour rgb = length_colour(share);
  return hex_colour(rgb[0], rgb[1], rgb[2]);
}

/// A disc of the boundary in the frame of its tile.
struct Spot {
  Vector3 foot;
  double length;
};

/// The Poincare disc of one component, in pixels.
class DiscPicture {
 public:
  DiscPicture(double left, const LengthScale& scale)
      : middle_x_(left + kBorder + kDisc / 2), scale_(scale) {}

  void tile(const BoundarySurface& surface, const DevelopedTile& developed) {
    std::string path;
    double size = 0;
    const auto [first_x, first_y] = pixel(developed.isometry * surface.corner(developed.tile, 0));
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3 a = developed.isometry * surface.corner(developed.tile, k);
      const Vector3 b = developed.isometry * surface.corner(developed.tile, (k + 1) % 3);
      constexpr int kPieces = 10;
      for (int n = 0; n < kPieces; ++n) {
        const double share = static_cast<double>(n) / kPieces;
        const auto [x, y] = pixel((1 - share) * a + share * b);
        size = std::max(size, std::hypot(x - first_x, y - first_y));
        path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", x, y);
      }
    }
    if (size < kSmallestTile) return;
    auto& layer = developed.first ? front_ : back_;
    layer += fmt::format("<path d=\"{}Z\"/>\n", path);
  }

  void spot(const Spot& spot, const Matrix3& isometry) {
    const Vector3 centre = (isometry * spot.foot).eval();
    const double distance = std::acosh(std::max(1.0, centre[2]));
    const double radius = disc_radius(spot.length);
    const double outer = std::tanh((distance + radius) / 2),
                 inner = std::tanh((distance - radius) / 2);
    const double pixels = kDisc / 2 * (outer - inner) / 2;
    if (pixels < kSmallestSpot) return;
    const double along = (outer + inner) / 2, size = std::hypot(centre[0], centre[1]);
    const double x = size > 0 ? along * centre[0] / size : 0;
    const double y = size > 0 ? along * centre[1] / size : 0;
    spots_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.2f}\" fill=\"{}\"/>\n",
                          middle_x_ + kDisc / 2 * x, kMiddleY - kDisc / 2 * y, pixels,
                          colour_of(scale_.share_of(spot.length)));
  }

  std::string text(const std::string& caption) const {
    return fmt::format(
        "<circle cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"{2:.1f}\" fill=\"#f4f4f4\" "
        "stroke=\"#888888\"/>\n"
        "<g stroke=\"none\">\n{3}</g>\n"
        "<g fill=\"none\" stroke=\"#000000\" stroke-opacity=\"0.25\" "
        "stroke-width=\"0.5\">\n{4}</g>\n"
        "<g fill=\"none\" stroke=\"#000000\" stroke-width=\"1.3\" "
        "stroke-linejoin=\"round\">\n{5}</g>\n"
        "<text x=\"{6:.1f}\" y=\"16\">{7}</text>\n",
        middle_x_, kMiddleY, kDisc / 2, spots_, back_, front_, middle_x_ - kDisc / 2, caption);
  }

 private:
  static constexpr double kMiddleY = kBorder + kDisc / 2;

  std::pair<double, double> pixel(const Vector3& point) const {
    const double norm =
        std::sqrt(std::max(std::numeric_limits<double>::min(),
                           point[2] * point[2] - point[0] * point[0] - point[1] * point[1]));
    const double scale = kDisc / 2 / (norm + point[2]);
    return {middle_x_ + scale * point[0], kMiddleY - scale * point[1]};
  }

  double middle_x_;
  LengthScale scale_;
  std::string spots_, back_, front_;
};

std::vector<std::vector<Spot>> spots_by_tile(const topology::Triangulation& triangulation,
                                             std::span<const double> edge_lengths,
                                             const BoundarySurface& surface,
                                             const Spectrum& spectrum) {
  std::vector<std::vector<Spot>> spots(4 * triangulation.tetrahedron_count());
  for (const Arc& arc : spectrum.arcs) {
    if (arc.edge != kNoEdge) continue;
    for (const ArcEnd& end : {arc.start, arc.end}) {
      spots[BoundarySurface::index(end.tile)].push_back({point_of(end), arc.length});
    }
  }
  // Edges end at corners, which several tiles share: each draws them.
  for (std::size_t n = 0; n < spots.size(); ++n) {
    const Tile tile{static_cast<std::uint32_t>(n / 4), static_cast<std::uint32_t>(n % 4)};
    if (!surface.has(tile)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const int to = surface.corner_vertex(tile, k);
      if (!surface.has({tile.tetrahedron, static_cast<std::uint32_t>(to)}))
        continue;  // into a cusp
      const double length = edge_lengths[triangulation.edge_class(
          n / 4, topology::kEdgeNumber[n % 4][static_cast<std::size_t>(to)])];
      if (length <= spectrum.length) spots[n].push_back({surface.corner(tile, k), length});
    }
  }
  return spots;
}

std::string drawn_scale(double width, const LengthScale& scale) {
  constexpr int kSteps = 100;
  const double left = kBorder, span = std::min(width - 2 * kBorder, kDisc);
  const double top = 2 * kBorder + kDisc;
  std::string text;
  for (int n = 0; n < kSteps; ++n) {
    text += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.2f}\" height=\"14\" fill=\"{}\"/>\n",
        left + span * n / kSteps, top, span / kSteps + 0.5, colour_of((n + 0.5) / kSteps));
  }
  constexpr int kLabels = 5;
  for (int n = 0; n <= kLabels; ++n) {
    const double share = static_cast<double>(n) / kLabels;
    text += fmt::format(
        "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}{:.3g}</text>\n", left + span * share,
        top + 32, n == 0 ? "start" : (n == kLabels ? "end" : "middle"),
        n == kLabels ? "length " : "", scale.shortest + share * (scale.longest - scale.shortest));
  }
  return text;
}

}  // namespace

std::string spots_as_svg(const topology::Triangulation& triangulation,
                         std::span<const double> edge_lengths, const Spectrum& spectrum,
                         const std::string& title) {
  std::vector<std::size_t> components;
  for (std::size_t v = 0; v < triangulation.vertex_count(); ++v)
    if (triangulation.link(v).euler_characteristic < 0) components.push_back(v);
  const double width = (kDisc + 2 * kBorder) * static_cast<double>(components.size());
  const LengthScale scale = scale_of(spectrum);
  const BoundarySurface surface(triangulation, edge_lengths);
  const auto spots = spots_by_tile(triangulation, edge_lengths, surface, spectrum);
  std::string svg = svg_head(static_cast<int>(width),
                             static_cast<int>(kDisc + 2 * kBorder + kFooter), kLetters, title);
  for (std::size_t place = 0; place < components.size(); ++place) {
    const std::size_t v = components[place];
    std::size_t n = 0;
    while (triangulation.vertex_classes()[n] != v) ++n;
    const Tile from{static_cast<std::uint32_t>(n / 4), static_cast<std::uint32_t>(n % 4)};
    DiscPicture picture((kDisc + 2 * kBorder) * static_cast<double>(place), scale);
    for (const DevelopedTile& developed : surface.develop(from, kDrawnRadius, kMostTiles)) {
      picture.tile(surface, developed);
      for (const Spot& spot : spots[BoundarySurface::index(developed.tile)])
        picture.spot(spot, developed.isometry);
    }
    svg += picture.text(
        fmt::format("boundary component {}, genus {}", v, triangulation.link(v).genus()));
  }
  return svg + drawn_scale(width, scale) + "</svg>\n";
}

std::string counting_as_svg(const Spectrum& spectrum, const Identities& identities,
                            const std::string& title) {
  constexpr double kWidth = 720, kHeight = 480, kLeft = 70, kRight = 20, kTop = 40, kBottom = 50;
  const double count = static_cast<double>(std::max<std::uint64_t>(spectrum.arc_count, 10));
  const double decades = std::ceil(std::log10(count)), length = std::max(spectrum.length, 1.0);
  const auto x = [&](double l) { return kLeft + (kWidth - kLeft - kRight) * l / length; };
  const auto y = [&](double n) {
    return kHeight - kBottom - (kHeight - kTop - kBottom) * std::log10(n) / decades;
  };
  std::string svg = svg_head(static_cast<int>(kWidth), static_cast<int>(kHeight), kLetters, title);
  for (int d = 0; d <= static_cast<int>(decades); ++d) {
    const double height = y(std::pow(10, d));
    svg += fmt::format(
        "<line x1=\"{0}\" y1=\"{2:.1f}\" x2=\"{1}\" y2=\"{2:.1f}\" stroke=\"#dddddd\"/>\n"
        "<text x=\"{3}\" y=\"{4:.1f}\" text-anchor=\"end\">10<tspan dy=\"-6\" "
        "font-size=\"10\">{5}</tspan></text>\n",
        kLeft, kWidth - kRight, height, kLeft - 8, height + 5, d);
  }
  for (int l = 0; l <= static_cast<int>(length); ++l) {
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n", x(l),
                       kHeight - kBottom + 20, l);
  }
  svg += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"end\">length</text>\n", kWidth - kRight,
                     kHeight - 10);
  std::string path;
  double so_far = 0;
  const auto& histogram = spectrum.sums.histogram();
  for (std::size_t n = 0; n < histogram.size(); ++n) {
    if (histogram[n] == 0) continue;
    const double at = x(std::min(length, (static_cast<double>(n) + 0.5) * Sums::kBin));
    if (so_far > 0) path += fmt::format("L{:.1f} {:.1f}", at, y(so_far));
    so_far += static_cast<double>(histogram[n]) / 2;
    path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", at, y(std::max(so_far, 1.0)));
  }
  svg +=
      fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"#0072b2\" stroke-width=\"2\"/>\n", path);
  std::string caption = "number of arcs up to a length";
  if (identities.dimension && so_far > 1) {
    const double delta = identities.dimension->value;
    const double start = std::max(0.0, length - std::log(count) / delta);
    svg += fmt::format(
        "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"#d55e00\" "
        "stroke-width=\"1.5\" stroke-dasharray=\"6 4\"/>\n",
        x(start), y(std::max(1.0, so_far * std::exp(delta * (start - length)))), x(length),
        y(so_far));
    caption += fmt::format("; dashed: growth with the exponent {:.3f}", delta);
  }
  svg += fmt::format("<text x=\"{}\" y=\"24\">{}</text>\n", kLeft, caption);
  return svg + "</svg>\n";
}

}  // namespace tripus::orthospectrum
