#include "meshing/picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/svg_text.hpp"

#include "base/svg_text.hpp"

namespace tripus::meshing {
namespace {

/// Pixels a side. Whole numbers keep the files small.
constexpr double kSize = 1200;
constexpr double kMargin = 60;
constexpr int kShades = 16;

Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Point unit(const Point& a) {
  const double length = std::sqrt(dot(a, a));
  return {a[0] / length, a[1] / length, a[2] / length};
}

/// A parallel projection from a fixed direction, with the solid in the middle.
struct Camera {
  Point right, up, towards;  ///< the viewer is far away in direction `towards`
  Point centre{};
  double scale = 1;

  explicit Camera(const TetrahedralMesh& solid) {
    towards = unit({0.55, -0.75, 0.42});
    right = unit(cross({0, 0, 1}, towards));
    up = cross(towards, right);
    Point low = solid.points.front(), high = low;
    for (const Point& p : solid.points)
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], p[k]);
        high[k] = std::max(high[k], p[k]);
      }
    for (std::size_t k = 0; k < 3; ++k) centre[k] = (low[k] + high[k]) / 2;
    double radius = 0;
    for (const Point& p : solid.points)
      radius =
          std::max({radius, std::fabs(dot(p - centre, right)), std::fabs(dot(p - centre, up))});
    scale = (kSize / 2 - kMargin) / radius;
  }
  long x(const Point& p) const { return std::lround(kSize / 2 + scale * dot(p - centre, right)); }
  long y(const Point& p) const { return std::lround(kSize / 2 - scale * dot(p - centre, up)); }
};

struct Facet {
  std::array<std::uint32_t, 3> corners;  ///< counterclockwise from outside
  bool cut = false;                      ///< within the solid, laid open
};

/// The faces of the kept tetrahedra that no other kept one shares.
std::vector<Facet> open_faces(const TetrahedralMesh& solid, const std::vector<bool>& kept) {
  constexpr std::array<std::array<std::size_t, 3>, 4> kOutwards{
      {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
  struct Entry {
    std::array<std::uint32_t, 3> key, corners;
    bool kept;
  };
  std::vector<Entry> entries;
  entries.reserve(4 * solid.tetrahedra.size());
  for (std::size_t t = 0; t < solid.tetrahedra.size(); ++t)
    for (const auto& face : kOutwards) {
      Entry entry{{}, {}, kept[t]};
      for (std::size_t i = 0; i < 3; ++i) entry.corners[i] = solid.tetrahedra[t][face[i]];
      entry.key = entry.corners;
      std::sort(entry.key.begin(), entry.key.end());
      entries.push_back(entry);
    }
  std::sort(entries.begin(), entries.end(),
            [](const Entry& a, const Entry& b) { return a.key < b.key; });
  std::vector<Facet> facets;
  for (std::size_t i = 0, end = 0; i < entries.size(); i = end) {
    while (end < entries.size() && entries[end].key == entries[i].key) ++end;
    for (std::size_t j = i; j < end; ++j)
      if (entries[j].kept && (end - i == 1 || !entries[i + (end - 1 - j)].kept))
        facets.push_back({entries[j].corners, end - i == 2});
  }
  return facets;
}

struct Colour {
  double red, green, blue;
};
constexpr Colour kWall{95, 140, 190}, kCut{232, 178, 96};

std::string hex(const Colour& colour, double light) {
  const auto part = [&](double share) {
    return static_cast<std::uint8_t>(std::clamp(share * light, 0.0, 255.0));
  };
  return hex_colour(part(colour.red), part(colour.green), part(colour.blue));
}

std::string head(double width, double height) {
  const std::string w = std::to_string(std::lround(width)), h = std::to_string(std::lround(height));
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + w + " " + h + "\" width=\"" +
         std::to_string(std::lround(width / 2)) + "\" height=\"" +
         std::to_string(std::lround(height / 2)) + "\"><rect width=\"" + w + "\" height=\"" + h +
         "\" fill=\"#fff\"/>";
}

/// Facets that face the viewer (or, from within, turn their back), one path for neighbours in depth
/// of one shade.
std::string painted(const TetrahedralMesh& solid, const Camera& camera, std::vector<Facet> facets,
                    bool from_within) {
  struct Seen {
    double depth;
    int shade;  ///< with kShades added for cut faces
    const Facet* facet;
  };
  std::vector<Seen> seen;
  for (const Facet& facet : facets) {
    const auto& [a, b, c] = facet.corners;
    const auto& p = solid.points;
    double facing = dot(unit(cross(p[b] - p[a], p[c] - p[a])), camera.towards);
    if (from_within) facing = -facing;
    if (!(facing > 0)) continue;
    const double depth =
        dot(p[a], camera.towards) + dot(p[b], camera.towards) + dot(p[c], camera.towards);
    const int shade = std::min(kShades - 1, static_cast<int>(kShades * facing));
    seen.push_back({depth, shade + (facet.cut ? kShades : 0), &facet});
  }
  std::stable_sort(seen.begin(), seen.end(),
                   [](const Seen& a, const Seen& b) { return a.depth < b.depth; });
  std::string out =
      "<g stroke=\"#000\" stroke-opacity=\".45\" stroke-width=\"1\" "
      "stroke-linejoin=\"round\">";
  for (std::size_t i = 0, end = 0; i < seen.size(); i = end) {
    const int shade = seen[i].shade % kShades;
    out += "<path fill=\"" +
           hex(seen[i].shade >= kShades ? kCut : kWall, 0.5 + 0.65 * (shade + 0.5) / kShades) +
           "\" d=\"";
    for (; end < seen.size() && seen[end].shade == seen[i].shade; ++end) {
      const auto& corners = seen[end].facet->corners;
      for (std::size_t k = 0; k < 3; ++k) {
        const Point& p = solid.points[corners[k]];
        out +=
            (k == 0 ? 'M' : 'L') + std::to_string(camera.x(p)) + " " + std::to_string(camera.y(p));
      }
      out += 'z';
    }
    out += "\"/>\n";
  }
  return out + "</g>";
}

/// Behind a plane through the centre that leans away from the viewer a little.
std::vector<bool> behind_cut(const TetrahedralMesh& solid, const Camera& camera) {
  Point normal;
  for (std::size_t k = 0; k < 3; ++k) normal[k] = camera.towards[k] - 0.3 * camera.right[k];
  std::vector<bool> kept;
  for (const Tetrahedron& t : solid.tetrahedra) {
    double sum = 0;
    for (const std::uint32_t corner : t) sum += dot(solid.points[corner] - camera.centre, normal);
    kept.push_back(sum < 0);
  }
  return kept;
}

}  // namespace

std::string boundary_picture(const TetrahedralMesh& solid) {
  const Camera camera(solid);
  const std::vector<bool> all(solid.tetrahedra.size(), true);
  return head(kSize, kSize) + painted(solid, camera, open_faces(solid, all), true) + "</svg>\n";
}

std::string cut_picture(const TetrahedralMesh& solid) {
  const Camera camera(solid);
  return head(kSize, kSize) +
         painted(solid, camera, open_faces(solid, behind_cut(solid, camera)), false) + "</svg>\n";
}

std::string cone_picture(const TetrahedralMesh& solid) {
  const Camera camera(solid);
  const double height = 1.5 * kSize, x = kSize / 2, y = kMargin - kSize / 2;
  std::vector<bool> seen(solid.points.size(), false);
  const std::vector<Facet> facets = open_faces(solid, behind_cut(solid, camera));
  for (const Facet& facet : facets)
    if (!facet.cut)
      for (const std::uint32_t corner : facet.corners) seen[corner] = true;
  std::string lines;
  const std::string point =
      "M" + std::to_string(std::lround(x)) + " " + std::to_string(std::lround(y));
  for (std::size_t i = 0; i < seen.size(); ++i)
    if (seen[i])
      lines += point + "L" + std::to_string(camera.x(solid.points[i])) + " " +
               std::to_string(camera.y(solid.points[i]));
  return head(kSize, height) + "<g transform=\"translate(0 " +
         std::to_string(std::lround(height - kSize)) +
         ")\"><path fill=\"none\" stroke=\"#b03a48\" "
         "stroke-opacity=\".35\" stroke-width=\"1\" d=\"" +
         lines + "\"/>" + painted(solid, camera, facets, false) + "<circle cx=\"" +
         std::to_string(std::lround(x)) + "\" cy=\"" + std::to_string(std::lround(y)) +
         "\" r=\"14\" fill=\"#b03a48\"/></g></svg>\n";
}

std::string stages_picture(const MeshedManifold& manifold) {
  constexpr double kWidth = 1200, kRow = 90, kLeft = 230, kRight = 190;
  double most = 1;
  for (const std::size_t count : manifold.tetrahedra) most = std::max(most, double(count));
  std::string out = head(kWidth, kRow * kStageCount + 20) +
                    "<g font-family=\"sans-serif\" font-size=\"36\" fill=\"#222\">";
  for (std::size_t i = 0; i < kStageCount; ++i) {
    const double count = double(std::max<std::size_t>(manifold.tetrahedra[i], 1));
    // One tetrahedron has a bar as well.
    const double length =
        (kWidth - kLeft - kRight) * (0.03 + 0.97 * std::log(count) / std::log(most + 1));
    const long y = std::lround(kRow * double(i)) + 20;
    out += "<text x=\"" + std::to_string(std::lround(kLeft - 20)) + "\" y=\"" +
           std::to_string(y + 48) + "\" text-anchor=\"end\">" +
           std::string(stage_name(static_cast<MeshStage>(i))) + "</text><rect x=\"" +
           std::to_string(std::lround(kLeft)) + "\" y=\"" + std::to_string(y) + "\" width=\"" +
           std::to_string(std::lround(length)) + "\" height=\"66\" fill=\"" +
           hex(i == kStageCount - 1 ? kCut : kWall, 1) + "\"/><text x=\"" +
           std::to_string(std::lround(kLeft + length + 16)) + "\" y=\"" + std::to_string(y + 48) +
           "\">" + std::to_string(manifold.tetrahedra[i]) + "</text>\n";
  }
  return out + "</g></svg>\n";
}

}  // namespace tripus::meshing
