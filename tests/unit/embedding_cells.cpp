// Cells as surfaces, and the files that hold them. Laws E6 and E8 of embedding/README.md.
#include <algorithm>
#include <cstring>
#include <map>
#include <set>
#include <sstream>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include "embedding/colour.hpp"
#include "embedding/developing_map.hpp"
#include "embedding/export/circle_svg.hpp"
#include "embedding/export/mesh_formats.hpp"
#include "tests/support/embedded_manifolds.hpp"

namespace tripus::embedding {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// Every side of a triangle is that of exactly one other, in the opposite direction.
void expect_closed(const Triangles& triangles) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
  for (const auto& t : triangles)
    for (std::size_t n = 0; n < 3; ++n) ASSERT_TRUE(sides.insert({t[n], t[(n + 1) % 3]}).second);
  for (const auto& [from, to] : sides) ASSERT_TRUE(sides.contains({to, from}));
}

double euclidean_volume(const std::vector<Vector3>& points, const Triangles& triangles) {
  double volume = 0;
  for (const auto& [a, b, c] : triangles) volume += points[a].dot(points[b].cross(points[c])) / 6;
  return volume;
}

const testing::Embedded& sample(const std::string& name) {
  static std::map<std::string, testing::Embedded> made;
  auto place = made.find(name);
  if (place == made.end()) place = made.emplace(name, *testing::try_embed(name)).first;
  return place->second;
}

class Cells : public ::testing::TestWithParam<const char*> {};

TEST_P(Cells, AreClosedAndFaceOutward) {  // E6
  const testing::Embedded& m = sample(GetParam());
  const auto cells = universal_cover(m.embedding, m.triangulation, {.max_cells = 40});
  for (const Model model : geometry::kModels) {
    const Tessellation tessellation(m.embedding, cells, {model, 0.02});
    std::size_t points = 0, triangles = 0;
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const auto places = tessellation.points(c);
      const Triangles shape = tessellation.triangles(c);
      expect_closed(shape);
      EXPECT_EQ(places.size(), point_count(tessellation.subdivisions(c)));
      EXPECT_EQ(shape.size(), triangle_count(tessellation.subdivisions(c)));
      EXPECT_EQ(tessellation.sides(c).size(), shape.size());
      EXPECT_GT(euclidean_volume(places, shape), 0) << to_string(model) << ' ' << c;
      points += places.size();
      triangles += shape.size();
    }
    EXPECT_EQ(tessellation.point_count(), points);
    EXPECT_EQ(tessellation.triangle_count(), triangles);
  }
}

TEST_P(Cells, LieOnTheirPlanesAndInsideTheOthers) {  // E6
  const testing::Embedded& m = sample(GetParam());
  for (const HyperboloidTetrahedron& tetrahedron : m.embedding.tetrahedra) {
    const CellShape shape = cell_shape(tetrahedron, 2);
    for (std::size_t n = 0; n < shape.triangles.size(); ++n) {
      for (const std::uint32_t p : shape.triangles[n]) {
        for (std::size_t side = 0; side < 8; ++side) {
          const Vector4& plane =
              side < 4 ? tetrahedron.faces[side] : tetrahedron.vertices[side - 4];
          const double height = geometry::lorentz_product(shape.points[p], plane);
          EXPECT_LT(height, 1e-11);
          if (side == shape.sides[n]) {
            EXPECT_GT(height, -1e-11);
          }
        }
      }
    }
  }
}

TEST_P(Cells, KeepTheErrorThatWasChosen) {  // E6
  // Measured otherwise than the library does: points of the triangles against the Euclidean spheres
  // that the planes are in the ball, centre n / n_4 and radius 1 / n_4.
  const testing::Embedded& m = sample(GetParam());
  const auto cells = universal_cover(m.embedding, m.triangulation, {.max_cells = 6});
  for (const double error : {0.05, 0.005}) {
    const Tessellation tessellation(m.embedding, cells, {Model::kPoincareBall, error});
    double worst = 0;
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const auto places = tessellation.points(c);
      const Triangles triangles = tessellation.triangles(c);
      const HyperboloidTetrahedron& tetrahedron = m.embedding.tetrahedra[cells[c].tetrahedron];
      for (std::size_t n = 0; n < triangles.size(); ++n) {
        const std::size_t side = tessellation.sides(c)[n];
        const Vector4 plane = cells[c].isometry *
                              (side < 4 ? tetrahedron.faces[side] : tetrahedron.vertices[side - 4]);
        const auto& [p, q, r] = triangles[n];
        for (const Vector3& place : {Vector3((places[p] + places[q] + places[r]) / 3),
                                     Vector3((places[p] + places[q]) / 2)}) {
          // (|n_4 x - n|^2 - 1) / n_4 without the difference, as |n|^2 = 1 + n_4^2.
          const Vector3 from_centre = plane[3] * place - plane.head<3>();
          const double off =
              (plane[3] * (place.squaredNorm() + 1) - 2 * place.dot(plane.head<3>())) /
              (from_centre.norm() + 1);
          worst = std::max(worst, std::abs(off));
        }
      }
    }
    EXPECT_LT(worst, error);
    EXPECT_GT(worst, error / 1000);
  }
}

INSTANTIATE_TEST_SUITE_P(Manifolds, Cells,
                         ::testing::Values("cPcbbbihq", "dLQbcccdhkw", "eLPkbcdddhjoow"));

TEST(Colours, OfDifferentTetrahedraDiffer) {
  std::set<Colour> seen;
  for (std::uint32_t t = 0; t < 40; ++t) seen.insert(tetrahedron_colour(t));
  EXPECT_GE(seen.size(), 38u);
}

class Files : public ::testing::Test {
 protected:
  const testing::Embedded& m_ = sample("cPcbbbihq");
  std::vector<Cell> cells_ = fundamental_domain(m_.embedding, m_.triangulation.gluings());
  Tessellation tessellation_{m_.embedding, cells_, {Model::kKleinBall, 0.1}};

  std::string text_of(WriteMesh write) const {
    std::ostringstream out;
    write(out, tessellation_);
    return out.str();
  }
};

TEST_F(Files, ObjHasAClosedGroupForEachCell) {  // E8
  std::istringstream in(text_of(write_obj));
  std::vector<Vector3> points;
  std::map<std::string, Triangles> groups;
  std::string word, group, line;
  while (std::getline(in, line)) {
    std::istringstream words(line);
    words >> word;
    if (word == "g") words >> group;
    if (word == "v") words >> points.emplace_back()[0] >> points.back()[1] >> points.back()[2];
    if (word == "f") {
      auto& triangle = groups[group].emplace_back();
      for (auto& p : triangle) {
        words >> p;
        --p;
        ASSERT_LT(p, points.size());
      }
    }
  }
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_TRUE(groups.contains("cell_1_tetrahedron_1"));
  for (const auto& [name, triangles] : groups) {
    EXPECT_EQ(triangles.size(), 28u);
    expect_closed(triangles);
    EXPECT_GT(euclidean_volume(points, triangles), 0) << name;
  }
}

TEST_F(Files, PlyHoldsCellsAndColours) {  // E8
  const std::string text = text_of(write_ply);
  const std::size_t body = text.find("end_header\n") + 11;
  constexpr std::size_t kPoint = 24 + 3 + 4 + 4, kFace = 1 + 12;
  ASSERT_EQ(text.size(), body + 32 * kPoint + 56 * kFace);
  Triangles triangles;
  for (std::size_t n = 0; n < 56; ++n) {
    const char* face = text.data() + body + 32 * kPoint + n * kFace;
    EXPECT_EQ(face[0], 3);
    std::array<std::uint32_t, 3> triangle{};
    std::memcpy(triangle.data(), face + 1, 12);
    triangles.push_back(triangle);
    for (const std::uint32_t p : triangle) {
      ASSERT_LT(p, 32u);
      const char* point = text.data() + body + p * kPoint;
      std::int32_t cell = -1, tetrahedron = -1;
      std::memcpy(&cell, point + 27, 4);
      std::memcpy(&tetrahedron, point + 31, 4);
      ASSERT_EQ(cell, n < 28 ? 0 : 1);
      EXPECT_EQ(tetrahedron, static_cast<std::int32_t>(cells_[std::size_t(cell)].tetrahedron));
      EXPECT_EQ(static_cast<std::uint8_t>(point[24]), tetrahedron_colour(unsigned(tetrahedron))[0]);
    }
  }
  expect_closed(triangles);
}

TEST_F(Files, VtkHasItsSectionsInOrder) {  // E8
  const std::string text = text_of(write_vtk);
  std::size_t at = 0;
  for (const char* section :
       {"# vtk DataFile Version 3.0\n", "BINARY\n", "DATASET POLYDATA\n", "POINTS 32 double\n",
        "POLYGONS 56 224\n", "CELL_DATA 56\n", "SCALARS cell int 1\n",
        "SCALARS tetrahedron int 1\n", "SCALARS depth int 1\n", "SCALARS side int 1\n",
        "COLOR_SCALARS colour 3\n"}) {
    const std::size_t found = text.find(section, at);
    ASSERT_NE(found, std::string::npos) << section;
    at = found + std::strlen(section);
  }
  EXPECT_EQ(text.size(), at + std::size_t{56} * 3 + 1);
}

TEST_F(Files, SvgNamesTheCirclesOfTheFirstCell) {
  const auto pictures = circle_pictures(m_.embedding, cells_, m_.report.dihedral_angles);
  const std::string svg = circles_as_svg(pictures, "a <b>");
  for (const char* name : {">f1<", ">f4<", ">v1<", ">v4<", "a &lt;b&gt;"})
    EXPECT_NE(svg.find(name), std::string::npos) << name;
  // The root stands in the paper's place.
  const auto expected = geometry::circle_packing(m_.report.dihedral_angles[0]);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_LT((plane_of(pictures[0].packing.faces[i]) - plane_of(expected.faces[i])).norm(), 1e-12);
    EXPECT_LT((plane_of(pictures[0].packing.vertices[i]) - plane_of(expected.vertices[i])).norm(),
              1e-12);
  }
}

}  // namespace
}  // namespace tripus::embedding
