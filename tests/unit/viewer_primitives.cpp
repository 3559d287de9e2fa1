// Half-spaces in the models, their primitives, cameras, scenes: without OpenGL.
#include <cmath>
#include <map>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "embedding/universal_cover.hpp"
#include "structure/solve.hpp"
#include "tests/support/embedded_manifolds.hpp"
#include "topology/isosig.hpp"
#include "viewer/camera.hpp"
#include "viewer/inside/inside_manifold.hpp"
#include "viewer/opencsg/half_space_mesh.hpp"
#include "viewer/picture.hpp"
#include "viewer/scene.hpp"
#include "viewer/scene_words.hpp"

namespace tripus::viewer {
namespace {

using geometry::kModels;

Vector3 random_vector(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return {normal(random), normal(random), normal(random)};
}

/// A unit spacelike vector whose plane is at most about 2 away from the origin.
Vector4 random_normal(std::mt19937& random) {
  const double shift = std::uniform_real_distribution<double>(-2, 2)(random);
  Vector4 n;
  n << std::cosh(shift) * random_vector(random).normalized(), std::sinh(shift);
  return n;
}

Scene scene_of(std::size_t cells, Model model) {
  const topology::Triangulation triangulation(topology::decode_isosig("cPcbbbihq"));
  const auto embedding =
      embedding::embed(triangulation, structure::solve(triangulation).edge_lengths);
  embedding::UniversalCoverOptions options;
  options.max_cells = cells;
  return make_scene("cPcbbbihq", embedding,
                    embedding::universal_cover(embedding, triangulation, options),
                    default_frame(model, embedding));
}

// V1 for horospheres: f is <v, X> + 1 times a positive factor. Here by points at a signed distance
// s from the horosphere, for which the product is -e^s.
TEST(ViewerHalfSpace, OfAHorosphereIsThatOfTheHyperboloid) {
  std::mt19937 random(11);
  for (const Model model : kModels) {
    for (int i = 0; i < 2000; ++i) {
      Vector4 v;
      v << random_vector(random), 0;
      v[3] = v.head<3>().norm();
      const Vector3 place = 0.7 * random_vector(random);
      Vector4 x;
      x << place, std::sqrt(1 + place.squaredNorm());
      const double product = geometry::lorentz_product(v, x);
      const Vector3 p = geometry::to_model(model, x);
      const HalfSpace f = horosphere(model, v);
      if (std::abs(product + 1) > 1e-9) {
        EXPECT_EQ(f(p) > 0, product > -1);
      }
      // The same in a frame of its own, and its gradient.
      const Vector3 centre = p + 0.1 * random_vector(random);
      const HalfSpace local = in_local_frame(f, centre, 0.3);
      EXPECT_NEAR(local((p - centre) / 0.3), f(p) / 0.3, 1e-9 * (1 + v[3] * v[3]));
      const Vector3 step = 1e-5 * random_vector(random);
      EXPECT_NEAR(f(p + step) - f(p - step), 2 * f.gradient(p).dot(step), 1e-8 * (1 + v[3] * v[3]));
      if (model == Model::kKleinBall) continue;
      // On the wall: x moved along the geodesic to the ideal point.
      const double c = -product;
      const Vector4 on = x / c + (c - 1 / c) / (2 * c) * v;
      EXPECT_NEAR(geometry::lorentz_product(v, on), -1, 1e-9);
      const Vector3 q = geometry::to_model(model, on);
      EXPECT_NEAR(f(q), 0, 1e-9);
      EXPECT_NEAR(f.gradient(q).norm(), 1, 1e-7);
    }
  }
}

// V1: the same points lie inside as on the hyperboloid, and the gradient has length 1 on the wall.
TEST(ViewerHalfSpace, IsThatOfTheHyperboloid) {
  std::mt19937 random(1);
  for (const Model model : kModels) {
    for (int i = 0; i < 2000; ++i) {
      const Vector4 n = random_normal(random);
      const Vector3 place = 0.7 * random_vector(random);
      Vector4 x;
      x << place, std::sqrt(1 + place.squaredNorm());
      const Vector3 p = geometry::to_model(model, x);
      const double product = geometry::lorentz_product(n, x);
      const HalfSpace f = half_space(model, n);
      if (std::abs(product) > 1e-9) {
        EXPECT_EQ(f(p) > 0, product > 0);
      }
      EXPECT_NEAR(f.b.squaredNorm() - 4 * f.a * f.c, 1, 1e-12);
      EXPECT_LE(model_side(model)(p), 0);
      const Vector3 centre = p + 0.1 * random_vector(random);
      const double scale = 0.01 + 0.1 * (i % 10);
      const HalfSpace local = in_local_frame(f, centre, scale);
      EXPECT_NEAR(local((p - centre) / scale) * scale, f(p), 1e-12);
      EXPECT_NEAR(local.b.squaredNorm() - 4 * local.a * local.c, 1, 1e-11);
    }
  }
}

struct MeshFacts {
  bool closed = true;
  double volume = 0;
  double concave = 0;   ///< farthest that a point lies beyond the plane of a triangle
  double farthest = 0;  ///< of a point from the origin
};

MeshFacts facts(const ConvexMesh& mesh) {
  MeshFacts result;
  const auto point = [&](std::uint32_t i) {
    return Vector3(mesh.points[i][0], mesh.points[i][1], mesh.points[i][2]);
  };
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
    const Vector3 a = point(t[0]), b = point(t[1]), c = point(t[2]);
    const Vector3 area = (b - a).cross(c - a);
    result.volume += a.dot(b.cross(c)) / 6;
    if (area.norm() < 1e-9) continue;
    for (std::uint32_t i = 0; i < mesh.points.size(); i += 7)
      result.concave = std::max(result.concave, area.normalized().dot(point(i) - a));
  }
  for (const auto& [edge, count] : edges)
    result.closed = result.closed && count == 1 && edges.contains({edge.second, edge.first});
  for (std::uint32_t i = 0; i < mesh.points.size(); ++i)
    result.farthest = std::max(result.farthest, point(i).norm());
  return result;
}

bool contains(const ConvexMesh& mesh, const Vector3& p) {
  for (const auto& t : mesh.triangles) {
    const auto at = [&](std::uint32_t i) {
      return Vector3(mesh.points[i][0], mesh.points[i][1], mesh.points[i][2]);
    };
    const Vector3 a = at(t[0]);
    if ((at(t[1]) - a).cross(at(t[2]) - a).dot(p - a) > 0) return false;
  }
  return true;
}

/// The half-space whose wall is a sphere: inside of it, or outside.
HalfSpace ball_half_space(const Vector3& centre, double radius, bool inside) {
  const double s = inside ? 1 : -1;
  return {s / (2 * radius), -s * centre / radius,
          s * (centre.squaredNorm() - radius * radius) / (2 * radius)};
}

// V2: closed, convex, turned outwards, in front of the eye; and the half-space within reach.
TEST(ViewerPrimitive, IsTheHalfSpaceNearTheCell) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < 150; ++i) {
    const double radius = std::exp(6 * uniform(random) - 2);
    const Vector3 direction = random_vector(random).normalized();
    const double depth = 1.8 * uniform(random) - 0.9;  // the wall meets the unit ball
    const HalfSpace f = i % 10 == 0
                            ? HalfSpace{0, direction, -depth}
                            : ball_half_space((depth - radius) * direction, radius, i % 2 == 0);
    const double error = 0.004;
    const HalfSpacePrimitive primitive = half_space_primitive(f, error);
    EXPECT_EQ(primitive.operation == Operation::kSubtract, f.a < 0);
    const MeshFacts mesh = facts(primitive.mesh);
    EXPECT_TRUE(mesh.closed) << radius;
    EXPECT_GT(mesh.volume, 0) << radius;
    EXPECT_LT(mesh.concave, 1e-5) << radius;
    EXPECT_LT(mesh.farthest, kFarthestPoint) << radius;
    for (int k = 0; k < 40; ++k) {
      const Vector3 p =
          random_vector(random).normalized() * std::cbrt(uniform(random)) * kBoundingReach;
      if (std::abs(f(p)) < 3 * error) continue;
      const bool inside =
          contains(primitive.mesh, p) == (primitive.operation == Operation::kIntersect);
      EXPECT_EQ(inside, f(p) < 0) << "radius " << radius << ", f " << f(p);
    }
  }
}

TEST(ViewerPrimitive, BoundingMeshHoldsTheUnitBall) {
  const ConvexMesh mesh = bounding_mesh();
  const MeshFacts of = facts(mesh);
  EXPECT_TRUE(of.closed);
  EXPECT_LT(of.farthest, kBoundingReach + 1e-6);
  std::mt19937 random(3);
  for (int i = 0; i < 500; ++i)
    EXPECT_TRUE(contains(mesh, 0.9999 * random_vector(random).normalized()));
}

// V3: all of a cell lies in its ball, and all cells in that of the scene.
TEST(ViewerScene, CellsLieInTheirBalls) {
  std::mt19937 random(4);
  std::exponential_distribution<double> weight;
  for (const Model model : kModels) {
    const Scene scene = scene_of(60, model);
    const BoundingBall all = bounding_ball(model, scene);
    for (const SceneCell& cell : scene.cells) {
      const BoundingBall ball = bounding_ball(model, cell);
      for (int i = 0; i < 50; ++i) {
        Vector4 x = Vector4::Zero();
        // Often near an edge: few corners have a say.
        for (std::size_t k = 0; k < 12; ++k) x += std::pow(weight(random), i % 8) * cell.corners[k];
        x /= std::sqrt(-geometry::lorentz_product(x, x));
        const Vector3 p = geometry::to_model(model, x);
        EXPECT_LE((p - ball.centre).norm(), ball.radius);
        EXPECT_LE((p - all.centre).norm(), all.radius);
        for (const Vector4& wall : cell.walls)
          EXPECT_LE(geometry::lorentz_product(wall, x), 1e-9 * x[3] * x[3]);
      }
    }
  }
}

TEST(ViewerScene, FirstCellStandsAsInThePaper) {
  const Scene scene = scene_of(1, Model::kUpperHalfSpace);
  // Edge 03 is on the vertical axis: the two faces at it, 1 and 2, are vertical planes through it.
  for (const std::size_t face : {1U, 2U}) {
    const HalfSpace f = half_space(Model::kUpperHalfSpace, scene.cells[0].walls[face]);
    EXPECT_NEAR(f.a, 0, 1e-12);
    EXPECT_NEAR(f.c, 0, 1e-12);
  }
  // And the truncations of its ends are hemispheres around the origin.
  for (const std::size_t end : {4U, 7U})
    EXPECT_NEAR(half_space(Model::kUpperHalfSpace, scene.cells[0].walls[end]).b.norm(), 0, 1e-12);
}

TEST(ViewerScene, IsNeverEmpty) {
  EXPECT_THROW(bounding_ball(Model::kPoincareBall, Scene{}), InvalidInput);
}

TEST(ViewerCamera, RaysGoWhereTheMatricesPutThem) {
  Camera camera{-70, 35, 5, 1.7, {0.3, -0.2}};
  const BoundingBall ball{{1, 2, 3}, 4};
  const View view = view_of(camera, ball, 300, 200);
  for (const auto& [x, y] : {std::pair(10.0, 20.0), {150.0, 100.0}, {280.5, 190.25}}) {
    const Ray ray = ray_through(view, 300, 200, x, y);
    Vector4 p;
    p << ray.origin + 13 * ray.direction, 1;
    const Vector4 clip = view.projection * (view.model_view * p);
    EXPECT_NEAR((clip[0] / clip[3] + 1) * 150, x, 1e-9);
    EXPECT_NEAR((1 - clip[1] / clip[3]) * 100, y, 1e-9);
  }
  EXPECT_NEAR((view.eye - ball.centre).norm(), 20, 1e-12);
}

TEST(ViewerPicture, RefusesWhatCannotBeDrawn) {
  const Scene scene = scene_of(2, Model::kPoincareBall);
  const PictureOptions good;
  EXPECT_NO_THROW(require_drawable(scene, good, 1, kLargestSide));
  EXPECT_THROW(require_drawable(scene, good, 0, 10), InvalidInput);
  EXPECT_THROW(require_drawable(scene, good, 10, kLargestSide + 1), InvalidInput);
  EXPECT_THROW(require_drawable(Scene{}, good, 10, 10), InvalidInput);
  const auto refuses = [&](auto&& change) {
    PictureOptions options;
    change(options);
    EXPECT_THROW(require_drawable(scene, options, 10, 10), InvalidInput);
  };
  refuses([](auto& o) { o.camera.azimuth = NAN; });
  refuses([](auto& o) { o.camera.elevation = 90; });
  refuses([](auto& o) { o.camera.elevation = NAN; });
  refuses([](auto& o) { o.camera.distance = 1; });
  refuses([](auto& o) { o.camera.distance = INFINITY; });
  for (const double zoom : {0.0, -1.0, 1e-9, 1e9, double{NAN}})
    refuses([&](auto& o) { o.camera.zoom = zoom; });
  for (const double shift : {10.0, -10.0, 1e300, double{NAN}}) {
    refuses([&](auto& o) { o.camera.shift.x() = shift; });
    refuses([&](auto& o) { o.camera.shift.y() = shift; });
  }
  refuses([](auto& o) { o.cut_away = NAN; });
  refuses([](auto& o) { o.samples = 5; });
  refuses([](auto& o) { o.faces = o.truncations = false; });
}

// One edge class of two is parabolic: it is named by its wall, which has a colour of its own.
TEST(ViewerWords, NameParabolicEdges) {
  const testing::Embedded manifold = *testing::try_embed_parabolic("dLQbcccherw 1=0");
  embedding::UniversalCoverOptions one;
  one.max_cells = 1;
  Scene scene =
      make_scene("scene", manifold.embedding,
                 embedding::universal_cover(manifold.embedding, manifold.triangulation, one),
                 geometry::Matrix4::Identity());
  add_classes(scene, manifold.triangulation, manifold.report.edge_lengths);
  const SceneCell& cell = scene.cells[0];
  const InsideManifold inside =
      inside_manifold(manifold.embedding, manifold.triangulation, manifold.report.edge_lengths);
  int parabolic = 0;
  for (std::size_t e = 0; e < 6; ++e) {
    const std::string words =
        topology::kEdgeEnds[e][0] == 0
            ? "0" + std::to_string(topology::kEdgeEnds[e][1])
            : std::to_string(10 * topology::kEdgeEnds[e][0] + topology::kEdgeEnds[e][1]);
    const std::string face = describe(scene, 0, faces_at_edge(e)[0]);
    EXPECT_EQ(has_wall(cell, 8 + e), cell.edge_class[e] == 1);
    if (cell.edge_class[e] != 1) {
      EXPECT_NE(face.find(words + " of class 0 (length"), std::string::npos) << face;
      continue;
    }
    ++parabolic;
    const std::string expected =
        "tetrahedron 0, horosphere of the parabolic edge " + words + " of class 1";
    EXPECT_EQ(describe(scene, 0, 8 + e), expected);
    EXPECT_EQ(describe_inside(inside, 1, 0, 4 + e), expected);
    EXPECT_NE(face.find(words + " of class 1 (parabolic)"), std::string::npos) << face;
    for (std::size_t wall = 0; wall < 8; ++wall)
      EXPECT_NE(wall_colour(ColourBy::kComponent, cell, 8 + e),
                wall_colour(ColourBy::kComponent, cell, wall));
    EXPECT_NE(wall_colour(ColourBy::kTetrahedron, cell, 8 + e),
              wall_colour(ColourBy::kTetrahedron, cell, 4));
  }
  EXPECT_GT(parabolic, 0);
  EXPECT_LT(parabolic, 6);
}

TEST(ViewerColours, TellThingsApart) {
  const Scene scene = scene_of(20, Model::kPoincareBall);
  const SceneCell& cell = scene.cells[0];
  for (std::size_t face = 1; face < 4; ++face)
    EXPECT_NE(wall_colour(ColourBy::kFace, cell, 0), wall_colour(ColourBy::kFace, cell, face));
  SceneCell other = cell;
  other.tetrahedron = 1 - cell.tetrahedron;
  EXPECT_NE(wall_colour(ColourBy::kTetrahedron, cell, 0),
            wall_colour(ColourBy::kTetrahedron, other, 0));
  other.depth = cell.depth + 1;
  EXPECT_NE(wall_colour(ColourBy::kDepth, cell, 0), wall_colour(ColourBy::kDepth, other, 0));
  for (const ColourBy by : {ColourBy::kTetrahedron, ColourBy::kFace, ColourBy::kDepth})
    EXPECT_NE(wall_colour(by, cell, 0), wall_colour(by, cell, 4));
}

}  // namespace
}  // namespace tripus::viewer
