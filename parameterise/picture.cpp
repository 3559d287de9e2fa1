#include "parameterise/picture.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "base/svg_text.hpp"
#include "embedding/colour.hpp"

namespace tripus::parameterise {
namespace {

using geometry::Vector3;

/// A triangle to be drawn, counterclockwise as seen from outside.
struct Facet {
  std::array<Vector3, 3> corners;
  std::array<double, 3> level{};  ///< distance to the boundary at the corners
  embedding::Colour colour{};
};

struct Camera {
  Vector3 right, up, towards;
  explicit Camera(const SolidPictureOptions& options) {
    const double a = options.azimuth * std::numbers::pi / 180;
    const double e = options.elevation * std::numbers::pi / 180;
    towards = Vector3(std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e));
    right = Vector3(-std::sin(a), std::cos(a), 0);
    up = towards.cross(right);
  }
};

constexpr int kBands = 5;

/// Cut at the level sets, so that bands have straight edges: pieces of one band each.
void append_pieces(const Facet& facet, double width, std::vector<Facet>& out) {
  const auto [low, high] = std::minmax({facet.level[0], facet.level[1], facet.level[2]});
  const double cut = (std::floor(low / width) + 1) * width;
  if (!(width > 0) || cut >= high - 1e-9 * width) {
    out.push_back(facet);
    return;
  }
  std::vector<std::pair<Vector3, double>> below, above;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const double a = facet.level[i], b = facet.level[j];
    (a <= cut ? below : above).emplace_back(facet.corners[i], a);
    if ((a <= cut) == (b <= cut)) continue;
    const double part = (cut - a) / (b - a);
    const Vector3 between = facet.corners[i] + part * (facet.corners[j] - facet.corners[i]);
    below.emplace_back(between, cut);
    above.emplace_back(between, cut);
  }
  const auto fan = [&](const auto& polygon, std::vector<Facet>& to) {
    for (std::size_t i = 2; i < polygon.size(); ++i)
      to.push_back({{polygon[0].first, polygon[i - 1].first, polygon[i].first},
                    {polygon[0].second, polygon[i - 1].second, polygon[i].second},
                    facet.colour});
  };
  fan(below, out);
  std::vector<Facet> rest;
  fan(above, rest);
  for (const Facet& each : rest) append_pieces(each, width, out);
}

std::string draw(std::vector<Facet> facets, const SolidPictureOptions& options, double band) {
  const Camera camera(options);
  std::erase_if(facets, [&](const Facet& f) {
    return (f.corners[1] - f.corners[0]).cross(f.corners[2] - f.corners[0]).dot(camera.towards) <=
           0;
  });
  const auto depth = [&](const Facet& f) {
    return (f.corners[0] + f.corners[1] + f.corners[2]).dot(camera.towards);
  };
  std::ranges::sort(facets, [&](const Facet& a, const Facet& b) { return depth(a) < depth(b); });
  Vector3 low = Vector3::Constant(1e300), high = Vector3::Constant(-1e300);
  for (const Facet& f : facets)
    for (const Vector3& x : f.corners) {
      const Vector3 seen(x.dot(camera.right), x.dot(camera.up), 0);
      low = low.cwiseMin(seen);
      high = high.cwiseMax(seen);
    }
  const double scale = 0.92 * std::min(options.width / std::max(high[0] - low[0], 1e-300),
                                       options.height / std::max(high[1] - low[1], 1e-300));
  const Vector3 light = (camera.towards + 0.5 * camera.up - 0.3 * camera.right).normalized();
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
      "height=\"{1}\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n"
      "<g stroke-width=\"0.6\" stroke-linejoin=\"round\">\n",
      options.width, options.height);
  for (const Facet& f : facets) {
    const Vector3 normal =
        (f.corners[1] - f.corners[0]).cross(f.corners[2] - f.corners[0]).normalized();
    double shade = 0.55 + 0.45 * std::max(0.0, normal.dot(light));
    const double level = (f.level[0] + f.level[1] + f.level[2]) / 3;
    if (band > 0 && static_cast<long>(std::floor(level / band)) % 2 == 1) shade *= 0.78;
    std::string points;
    for (const Vector3& x : f.corners)
      points +=
          fmt::format("{}{:.1f},{:.1f}", points.empty() ? "" : " ",
                      options.width / 2.0 + scale * (x.dot(camera.right) - (low[0] + high[0]) / 2),
                      options.height / 2.0 - scale * (x.dot(camera.up) - (low[1] + high[1]) / 2));
    const auto part = [&](std::size_t k) {
      return static_cast<std::uint8_t>(std::clamp(std::lround(f.colour[k] * shade), 0l, 255l));
    };
    const std::string colour = hex_colour(part(0), part(1), part(2));
    out +=
        fmt::format("<polygon points=\"{}\" fill=\"{}\" stroke=\"{}\"/>\n", points, colour, colour);
  }
  return out + "</g>\n</svg>\n";
}

constexpr std::array<std::array<std::size_t, 3>, 4> kOutwards{
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// The faces that only one of the chosen tetrahedra has: (tetrahedron, face).
std::vector<std::pair<std::size_t, std::size_t>> outer_faces(const meshing::TetrahedralMesh& mesh,
                                                             const std::vector<bool>& chosen) {
  struct Entry {
    std::array<std::uint32_t, 3> key;
    std::size_t t, f;
  };
  std::vector<Entry> entries;
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
    for (std::size_t f = 0; f < 4 && chosen[t]; ++f) {
      Entry entry{{}, t, f};
      for (std::size_t i = 0; i < 3; ++i) entry.key[i] = mesh.tetrahedra[t][kOutwards[f][i]];
      std::ranges::sort(entry.key);
      entries.push_back(entry);
    }
  std::ranges::sort(entries, {}, &Entry::key);
  std::vector<std::pair<std::size_t, std::size_t>> faces;
  for (std::size_t i = 0, end = 0; i < entries.size(); i = end) {
    while (end < entries.size() && entries[end].key == entries[i].key) ++end;
    if (end - i == 1) faces.emplace_back(entries[i].t, entries[i].f);
  }
  return faces;
}

Vector3 space(const meshing::Point& p) { return {p[0], p[1], p[2]}; }

}  // namespace

std::string solid_picture(const ColouredSolid& solid, const SolidPictureOptions& options) {
  const Camera camera(options);
  const auto& mesh = solid.mesh;
  double near = -1e300, far = 1e300, deepest = 0;
  for (const meshing::Point& p : mesh.points) {
    near = std::max(near, space(p).dot(camera.towards));
    far = std::min(far, space(p).dot(camera.towards));
  }
  for (const double level : solid.distance_to_boundary) deepest = std::max(deepest, level);
  const double plane = near - options.cut_away * (near - far);
  std::vector<bool> kept(mesh.tetrahedra.size());
  for (std::size_t t = 0; t < kept.size(); ++t) {
    double middle = 0;
    for (const std::uint32_t v : mesh.tetrahedra[t])
      middle += space(mesh.points[v]).dot(camera.towards) / 4;
    kept[t] = options.cut_away <= 0 || middle <= plane;
  }
  const double band = deepest / kBands;
  std::vector<Facet> facets;
  for (const auto& [t, f] : outer_faces(mesh, kept)) {
    Facet facet;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t v = mesh.tetrahedra[t][kOutwards[f][i]];
      facet.corners[i] = space(mesh.points[v]);
      facet.level[i] = solid.distance_to_boundary[v];
    }
    facet.colour = embedding::tetrahedron_colour(solid.tetrahedron[t]);
    append_pieces(facet, band, facets);
  }
  return draw(std::move(facets), options, band);
}

std::string image_picture(const MarkedSolid& solid, const HarmonicMap& map, const Quality& quality,
                          const SolidPictureOptions& options) {
  std::vector<bool> all(solid.mesh.tetrahedra.size(), true);
  std::vector<Facet> facets;
  for (std::size_t t = 0; t < all.size(); ++t) {
    const std::array<Vector4, 4> corners = image(solid, map.points, t);
    std::array<Vector3, 4> klein;
    for (std::size_t v = 0; v < 4; ++v)
      klein[v] = geometry::to_model(geometry::Model::kKleinBall, corners[v]);
    const Located at = located(solid, middle(corners));
    const bool is_turned = quality.cells[t].orientation < 0;
    for (const auto& face : kOutwards) {
      Facet facet;
      for (std::size_t i = 0; i < 3; ++i) facet.corners[i] = klein[face[i]];
      if (is_turned) std::swap(facet.corners[1], facet.corners[2]);
      facet.colour =
          is_turned ? embedding::Colour{20, 20, 20} : embedding::tetrahedron_colour(at.tetrahedron);
      facets.push_back(facet);
    }
  }
  return draw(std::move(facets), options, 0);
}

namespace {

/// A curve of log10 |gradient| and energy by iterations.
std::string convergence_picture(const HarmonicMap& map) {
  constexpr double kWidth = 640, kHeight = 300, kLeft = 60, kBottom = 40;
  double low = 1e300, high = -1e300;
  for (const MapStep& step : map.history) {
    const double y = std::log10(std::max(step.max_gradient, 1e-17));
    low = std::min(low, std::floor(y));
    high = std::max(high, std::ceil(y));
  }
  if (!(high > low)) high = low + 1;
  const double last = std::max(1, map.history.empty() ? 1 : map.history.back().iteration);
  std::string points;
  const auto x_of = [&](double i) { return kLeft + (kWidth - kLeft - 10) * i / last; };
  const auto y_of = [&](double y) {
    return 10 + (kHeight - kBottom - 10) * (high - y) / (high - low);
  };
  for (const MapStep& step : map.history)
    points += fmt::format("{:.1f},{:.1f} ", x_of(step.iteration),
                          y_of(std::log10(std::max(step.max_gradient, 1e-17))));
  std::string out =
      fmt::format("<svg viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\">", kWidth, kHeight);
  for (double y = low; y <= high; y += std::max(1.0, std::floor((high - low) / 6)))
    out += fmt::format(
        "<line x1=\"{0}\" x2=\"{1}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\" stroke=\"#ddd\"/>"
        "<text x=\"{3}\" y=\"{4:.1f}\" text-anchor=\"end\">1e{5}</text>",
        kLeft, kWidth - 10, y_of(y), kLeft - 6, y_of(y) + 4, static_cast<int>(y));
  return out + fmt::format(
                   "<polyline points=\"{}\" fill=\"none\" stroke=\"#0072b2\" "
                   "stroke-width=\"2\"/><text x=\"{}\" y=\"{}\">steps (0 to {})"
                   "</text></svg>",
                   points, kLeft, kHeight - 10, static_cast<int>(last));
}

/// Bars of log2 of the anisotropy of what is not turned over.
std::string distortion_picture(const Quality& quality) {
  constexpr std::size_t kBars = 12;
  std::array<std::size_t, kBars> counts{};
  for (const CellQuality& cell : quality.cells)
    if (cell.orientation > 0)
      ++counts[std::min(kBars - 1,
                        static_cast<std::size_t>(std::log2(std::max(1.0, cell.anisotropy))))];
  const double most =
      static_cast<double>(std::max<std::size_t>(1, *std::ranges::max_element(counts)));
  std::string out = "<svg viewBox=\"0 0 640 300\" width=\"640\" height=\"300\">";
  for (std::size_t i = 0; i < kBars; ++i) {
    const double height = 230 * static_cast<double>(counts[i]) / most;
    out += fmt::format(
        "<rect x=\"{}\" y=\"{:.1f}\" width=\"40\" height=\"{:.1f}\" fill=\"#009e73\"/>"
        "<text x=\"{}\" y=\"270\" text-anchor=\"middle\">{}{}</text>",
        20 + 50 * i, 250 - height, height, 40 + 50 * i, 1u << i, i + 1 == kBars ? "+" : "");
  }
  return out +
         "<text x=\"20\" y=\"294\">largest by smallest stretch of a tetrahedron, from</text></svg>";
}

}  // namespace

std::string solid_page(const std::string& title, const ColouredSolid& solid) {
  std::string out = fmt::format(
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{0}</title>\n"
      "<style>body{{font:16px/1.5 sans-serif;text-align:center}}svg{{max-width:95vw;"
      "max-height:80vh;height:auto}}.cut{{display:none}}.shown{{display:block}}</style></head>"
      "<body>\n<h1>{0}</h1>\n<p><label>cut away <input id=\"cut\" type=\"range\" min=\"0\" "
      "max=\"{1}\" value=\"{2}\"></label></p>\n",
      escaped_xml(title), kSolidCuts, kSolidCuts / 2);
  for (int cut = 0; cut <= kSolidCuts; ++cut)
    out += fmt::format("<div class=\"cut{}\">{}</div>\n", cut == kSolidCuts / 2 ? " shown" : "",
                       solid_picture(solid, {.cut_away = cut / (kSolidCuts + 1.0)}));
  return out +
         "<script>\nconst cuts = document.querySelectorAll('.cut');\n"
         "document.getElementById('cut').addEventListener('input', (event) => {\n"
         "  cuts.forEach((cut, i) => cut.classList.toggle('shown', i === "
         "Number(event.target.value)));\n});\n</script>\n</body></html>\n";
}

std::string report_page(const std::string& title, const MarkedSolid& solid, const HarmonicMap& map,
                        const Quality& quality) {
  const ColouredSolid shown = coloured(solid, map.points);
  SolidPictureOptions whole, open;
  whole.cut_away = 0;
  whole.width = whole.height = open.width = open.height = 640;
  std::string out = fmt::format(
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{0}</title>\n"
      "<style>body{{font:16px/1.5 sans-serif;max-width:1320px;margin:2em auto;padding:0 1em}}"
      "td{{padding:0 1.5em 0 0}}svg{{max-width:100%;height:auto}}text{{font:12px sans-serif}}"
      ".row{{display:flex;flex-wrap:wrap;gap:16px}}figure{{margin:0}}</style></head><body>\n"
      "<h1>{0}</h1>\n<table>\n",
      escaped_xml(title));
  const auto row = [&](std::string_view name, const std::string& value) {
    out += fmt::format("<tr><td>{}</td><td>{}</td></tr>\n", name, value);
  };
  row("tetrahedra, points",
      fmt::format("{}, {}", solid.mesh.tetrahedra.size(), solid.mesh.points.size()));
  row("manifold", fmt::format("{} tetrahedra, volume {:.12g}", solid.manifold->tetrahedron_count(),
                              quality.manifold_volume));
  row("energy", fmt::format("{:.12g}", map.energy));
  row("largest gradient", fmt::format("{:.3g} after {} steps: {}", map.max_gradient, map.iterations,
                                      solver::to_string(map.termination)));
  row("volume of the image", fmt::format("{:.12g}", quality.image_volume));
  row("turned over, flat", fmt::format("{}, {}", quality.inverted, quality.flat));
  row("anisotropy, median", fmt::format("{:.4g}", quality.median_anisotropy));
  out +=
      "</table>\n<h2>The solid, by the tetrahedra of its manifold</h2>\n<p>Each colour is a "
      "truncated tetrahedron of the hyperbolic manifold; bands show the distance to the geodesic "
      "boundary.</p>\n<div class=\"row\"><figure>";
  out += solid_picture(shown, whole) + "</figure><figure>" + solid_picture(shown, open) +
         "</figure></div>\n<h2>Its image in hyperbolic space (Klein ball)</h2>\n<figure>" +
         image_picture(solid, map, quality, open) + "</figure>\n<h2>Convergence</h2>\n" +
         convergence_picture(map) + "\n<h2>Distortion</h2>\n" + distortion_picture(quality) +
         "\n</body></html>\n";
  return out;
}

}  // namespace tripus::parameterise
