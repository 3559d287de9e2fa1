// T-junctions on every sort of edge, and faces that are cut one way or the other: families made
// from one good surface.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <random>
#include <sstream>

#include <gtest/gtest.h>

#include "meshing/formats/read_mesh.hpp"
#include "meshing/mend.hpp"
#include "meshing/validate.hpp"
#include "tests/support/data_folder.hpp"

namespace tripus::meshing {
namespace {

SurfaceFile read_text(const std::string& text) {
  return std::get<SurfaceFile>(read_mesh(text, "x.off", {}));
}

SurfaceMesh knotted_y(const std::string& path = "examples/surfaces/knotted-y.off") {
  std::ifstream in(testing::data_folder() + "/../" + path);
  std::ostringstream text;
  text << in.rdbuf();
  return read_text(text.str()).mesh;
}

using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// The two triangles at each edge.
std::map<Edge, std::vector<std::size_t>> edges_of(const SurfaceMesh& mesh) {
  std::map<Edge, std::vector<std::size_t>> edges;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
      edges[{std::min(a, b), std::max(a, b)}].push_back(t);
    }
  return edges;
}

std::uint32_t opposite(const Triangle& t, const Edge& edge) {
  return *std::ranges::find_if(
      t, [&](std::uint32_t c) { return c != edge.first && c != edge.second; });
}

int genus_of(const SurfaceFile& file) {
  return require_valid(file.mesh, file.lines).components.at(0).genus;
}

TEST(MendFamilies, ATJunctionOnAnyEdge) {
  const SurfaceMesh whole = knotted_y();
  std::mt19937 random(7);
  std::size_t tried = 0;
  for (const auto& [edge, triangles] : edges_of(whole)) {
    if (++tried % 20 != 0) continue;
    SurfaceFile file;
    file.mesh = whole;
    const double share = 0.2 + 0.6 * static_cast<double>(random() % 1000) / 1000;
    Point middle;
    for (std::size_t k = 0; k < 3; ++k)
      middle[k] = whole.points[edge.first][k] +
                  share * (whole.points[edge.second][k] - whole.points[edge.first][k]);
    const auto added = static_cast<std::uint32_t>(whole.points.size());
    file.mesh.points.push_back(middle);
    // Splits one of the two triangles at the edge.
    Triangle& kept = file.mesh.triangles[triangles[tried % 2]];
    Triangle other = kept;
    std::ranges::replace(kept, edge.second, added);
    std::ranges::replace(other, edge.first, added);
    file.mesh.triangles.push_back(other);
    const SurfaceFile mended = mend(std::move(file));
    ASSERT_EQ(mended.mesh.triangles.size(), whole.triangles.size() + 2) << edge.first;
    EXPECT_EQ(genus_of(mended), 2) << edge.first << "-" << edge.second;
  }
}

/// Pairs of triangles that meet at no more than `angle` become quadrilaterals, in an OFF text whose
/// readers choose a diagonal.
std::string with_quads(const SurfaceMesh& mesh, std::uint32_t seed, double angle,
                       std::size_t* quads) {
  std::vector<std::pair<Edge, std::vector<std::size_t>>> edges;
  for (const auto& each : edges_of(mesh)) edges.push_back(each);
  std::mt19937 random(seed);
  for (std::size_t i = edges.size(); i > 1; --i) std::swap(edges[i - 1], edges[random() % i]);
  std::vector<bool> used(mesh.triangles.size());
  std::vector<std::vector<std::uint32_t>> faces;
  for (const auto& [edge, triangles] : edges) {
    if (triangles.size() != 2 || used[triangles[0]] || used[triangles[1]]) continue;
    const Triangle &s = mesh.triangles[triangles[0]], &t = mesh.triangles[triangles[1]];
    Point normals[2];
    for (int side = 0; side < 2; ++side) {
      const Triangle& each = side == 0 ? s : t;
      const Point &a = mesh.points[each[0]], &b = mesh.points[each[1]], &c = mesh.points[each[2]];
      double length = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
        normals[side][k] = (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]);
        length += normals[side][k] * normals[side][k];
      }
      for (double& x : normals[side]) x /= std::sqrt(length);
    }
    double cosine = 0;
    for (std::size_t k = 0; k < 3; ++k) cosine += normals[0][k] * normals[1][k];
    if (cosine < std::cos(angle)) continue;
    used[triangles[0]] = used[triangles[1]] = true;
    // From the triangle whose side runs first to second: first, opposite of t, second, opposite of
    // s.
    const std::size_t at = static_cast<std::size_t>(std::ranges::find(s, edge.first) - s.begin());
    const bool runs = s[(at + 1) % 3] == edge.second;
    const std::uint32_t o = opposite(s, edge), p = opposite(t, edge);
    faces.push_back(runs ? std::vector{edge.first, p, edge.second, o}
                         : std::vector{edge.second, p, edge.first, o});
  }
  *quads = faces.size();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (!used[t]) faces.emplace_back(mesh.triangles[t].begin(), mesh.triangles[t].end());
  std::ostringstream text;
  text.precision(17);
  text << "OFF\n" << mesh.points.size() << " " << faces.size() << " 0\n";
  for (const Point& p : mesh.points) text << p[0] << " " << p[1] << " " << p[2] << "\n";
  for (const auto& face : faces) {
    text << face.size();
    for (const std::uint32_t corner : face) text << " " << corner;
    text << "\n";
  }
  return text.str();
}

TEST(MendFamilies, QuadrilateralsAreCutWhereTheyCanBe) {
  const SurfaceMesh whole = knotted_y();
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    std::size_t quads = 0;
    const SurfaceFile mended = mend(read_text(with_quads(whole, seed, 0.45, &quads)));
    EXPECT_GT(quads, 500u);
    ASSERT_EQ(mended.mesh.triangles.size(), whole.triangles.size()) << seed;
    EXPECT_EQ(genus_of(mended), 2) << seed;
  }
}

// A coarse surface with quadrilaterals folded by any angle: many of the diagonals that look best
// collide, but the surface that they were made from has none that do.
TEST(MendFamilies, FoldedQuadrilateralsAreCutWhereThereIsAWay) {
  const SurfaceMesh whole = knotted_y("tests/dialects/off-glued-header.off");
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    std::size_t quads = 0;
    const SurfaceFile mended = mend(read_text(with_quads(whole, seed, 4, &quads)));
    EXPECT_GT(quads, 150u);
    ASSERT_EQ(mended.mesh.triangles.size(), whole.triangles.size()) << seed;
    EXPECT_EQ(genus_of(mended), 2) << seed;
  }
}

TEST(MendFamilies, ADiagonalThatIsAnEdgeAlreadyIsTurned) {
  // A tetrahedron with a quadrilateral for two of its faces: one of its diagonals is the edge 0-2.
  for (const char* quad : {"4 0 1 2 3", "4 1 2 3 0", "4 2 3 0 1", "4 3 0 1 2"}) {
    const std::string text =
        std::string("OFF\n4 3 0\n0 0 0\n1 0 0.2\n1 1 0\n0 1 0.2\n") + quad + "\n3 0 2 1\n3 0 3 2\n";
    const SurfaceFile mended = mend(read_text(text));
    EXPECT_EQ(genus_of(mended), 0) << quad;
  }
}

}  // namespace
}  // namespace tripus::meshing
