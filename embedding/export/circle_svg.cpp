#include "embedding/export/circle_svg.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>
#include <fmt/format.h>

#include "base/svg_text.hpp"
#include "embedding/colour.hpp"

namespace tripus::embedding {
namespace {

using geometry::Circle;
using geometry::CirclePacking;
using geometry::Complex;

constexpr int kSize = 640;          // pixels
constexpr double kMargin = 0.08;    // of the picture
constexpr double kSmallest = 0.25;  // circles of a smaller radius, in pixels, are left out
constexpr const char* kBlack = "#222222";
constexpr const char* kFaceName = "#0072b2";

std::string hex(const Colour& colour) { return hex_colour(colour[0], colour[1], colour[2]); }

/// The part of the plane that is drawn: a square.
struct Window {
  Complex centre;
  double half;
  double x(const Complex& w) const { return kSize / 2.0 * (1 + (w - centre).real() / half); }
  double y(const Complex& w) const { return kSize / 2.0 * (1 - (w - centre).imag() / half); }
  double pixels(double length) const { return kSize / 2.0 * length / half; }
};

/// A circle too large for its arc to be told from a line in the window is treated as one.
bool draws_as_line(const Circle& circle, const Window& window) {
  return std::abs(circle.curvature) * window.half < 1e-6;
}

/// Around the circles of the first cell, lines apart.
Window window_of(const CirclePacking& packing) {
  double left = 0, right = 0, low = 0, high = 0;
  for (const auto* circles : {&packing.faces, &packing.vertices}) {
    for (const Circle& circle : *circles) {
      if (circle.is_line()) continue;
      left = std::min(left, circle.centre().real() - circle.radius());
      right = std::max(right, circle.centre().real() + circle.radius());
      low = std::min(low, circle.centre().imag() - circle.radius());
      high = std::max(high, circle.centre().imag() + circle.radius());
    }
  }
  const double half = std::max(right - left, high - low) / 2;
  return {{(left + right) / 2, (low + high) / 2}, half * (1 + kMargin)};
}

/// A point of a line, and its direction.
std::pair<Complex, Complex> line_of(const Circle& circle) {
  const double length = std::abs(circle.weighted_centre);
  const Complex normal = circle.weighted_centre / length;
  return {normal * (circle.co_curvature / (2 * length)), normal * Complex(0, 1)};
}

std::string drawn(const Circle& circle, const Window& window, const std::string& style) {
  if (draws_as_line(circle, window)) {
    const auto [point, direction] = line_of(circle);
    // Long enough to leave the window on both sides.
    const double reach = std::abs(point - window.centre) + 2 * window.half;
    const Complex start = point - reach * direction, end = point + reach * direction;
    return fmt::format("<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" {}/>\n",
                       window.x(start), window.y(start), window.x(end), window.y(end), style);
  }
  const double radius = window.pixels(circle.radius());
  if (radius < kSmallest) return {};
  return fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" {}/>\n",
                     window.x(circle.centre()), window.y(circle.centre()), radius, style);
}

/// Where the names of the faces stand: in the middle of a circle, towards the left end of a line.
Complex place_of_face(const Circle& circle, const Window& window) {
  if (!draws_as_line(circle, window)) return circle.centre();
  const auto [point, direction] = line_of(circle);
  const double middle = (std::conj(direction) * (window.centre - point)).real();
  return point + direction * (middle + (direction.real() < 0 ? 0.85 : -0.85) * window.half);
}

/// The names of the truncations stand on their circles: v1 above, v2 below, v3 and v4 to the left,
/// as the paper's place puts the first two side by side within the others.
Complex place_of_vertex(const Circle& circle, std::size_t vertex) {
  constexpr double kDirections[4] = {1.6, 4.7, 2.6, 2.6};
  if (circle.is_line()) return {};
  return circle.centre() + std::polar(circle.radius(), kDirections[vertex]);
}

std::string label(const Complex& place, const Window& window, const std::string& name,
                  const char* colour) {
  return fmt::format(
      "<text x=\"{:.1f}\" y=\"{:.1f}\" fill=\"{}\" stroke=\"white\" stroke-width=\"4\" "
      "paint-order=\"stroke\" text-anchor=\"middle\">{}</text>\n",
      window.x(place), window.y(place) + 6, colour, name);
}

/// Whether the vertices are oriented otherwise than in the paper's place.
bool is_mirrored(const HyperboloidTetrahedron& tetrahedron) {
  Matrix4 vertices;
  for (int v = 0; v < 4; ++v) vertices.col(v) = tetrahedron.vertices[static_cast<std::size_t>(v)];
  return vertices.determinant() < 0;
}

}  // namespace

std::vector<CirclePicture> circle_pictures(const Embedding& embedding, std::span<const Cell> cells,
                                           std::span<const std::array<double, 6>> dihedral_angles) {
  std::vector<CirclePicture> pictures;
  if (cells.empty()) return pictures;
  const std::uint32_t root = cells.front().tetrahedron;
  // Exactly where the paper has it, or its mirror image: its lines are lines to the last bit.
  CirclePacking first = geometry::circle_packing(dihedral_angles[root]);
  if (is_mirrored(embedding.tetrahedra[root])) first = geometry::mirrored(first);
  const Matrix4 to_paper =
      geometry::isometry_between(embedding.tetrahedra[root], geometry::to_hyperboloid(first));
  const geometry::MoebiusMap frame = geometry::to_moebius(to_paper);
  for (const Cell& cell : cells) {
    const geometry::MoebiusMap map =
        geometry::normalised(frame * geometry::to_moebius(cell.isometry));
    CirclePicture picture{geometry::circles_of(embedding.tetrahedra[cell.tetrahedron]),
                          cell.tetrahedron};
    for (auto* circles : {&picture.packing.faces, &picture.packing.vertices})
      for (Circle& circle : *circles) circle = geometry::apply(map, circle);
    pictures.push_back(picture);
  }
  pictures.front().packing = first;
  return pictures;
}

std::string circles_as_svg(std::span<const CirclePicture> pictures, const std::string& title) {
  constexpr int kLetters = 18;
  std::string svg = svg_head(kSize, kSize, kLetters, title);
  if (!pictures.empty()) {
    const Window window = window_of(pictures.front().packing);
    const bool single = pictures.size() == 1;
    // Later cells are smaller: they go on top, and the names of the first above everything.
    for (const CirclePicture& picture : pictures) {
      const std::string colour = hex(tetrahedron_colour(picture.tetrahedron));
      const double width = single || &picture == &pictures.front() ? 2.5 : 1;
      for (const Circle& circle : picture.packing.faces) {
        svg += drawn(circle, window,
                     fmt::format("fill=\"{}\" fill-opacity=\"{}\" stroke=\"{}\" "
                                 "stroke-width=\"{}\"",
                                 circle.curvature > 0 ? colour : "none", single ? 0.25 : 0.08,
                                 colour, width));
      }
      for (const Circle& circle : picture.packing.vertices) {
        svg += drawn(circle, window,
                     fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" "
                                 "stroke-dasharray=\"{}\"",
                                 kBlack, width / 2 + 0.25, single ? "7 4" : "3 2"));
      }
    }
    const CirclePacking& first = pictures.front().packing;
    for (std::size_t i = 0; i < 4; ++i) {
      svg += label(place_of_face(first.faces[i], window), window, fmt::format("f{}", i + 1),
                   kFaceName);
      svg +=
          label(place_of_vertex(first.vertices[i], i), window, fmt::format("v{}", i + 1), kBlack);
    }
  }
  return svg + "</svg>\n";
}

}  // namespace tripus::embedding
