// The polygons around faces, and which faces are drawn: without OpenGL.
#include <algorithm>
#include <cmath>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "embedding/universal_cover.hpp"
#include "tests/support/embedded_manifolds.hpp"
#include "viewer/faces/face_set.hpp"
#include "viewer/faces/proxies.hpp"
#include "viewer/faces/wall_outline.hpp"
#include "viewer/window/pace.hpp"

namespace tripus::viewer {
namespace {

using geometry::kModels;

struct Placed {
  std::vector<embedding::Cell> cells;
  Scene scene;
};

Placed placed(const testing::Embedded& manifold, std::size_t cells, Model model) {
  embedding::UniversalCoverOptions options;
  options.max_cells = cells;
  Placed result;
  result.cells = embedding::universal_cover(manifold.embedding, manifold.triangulation, options);
  result.scene = make_scene("scene", manifold.embedding, result.cells,
                            default_frame(model, manifold.embedding));
  return result;
}

/// A random point of a wall: all of them are sums of its corners; on a horosphere they are over
/// them.
Vector3 random_point(Model model, const SceneCell& cell, std::size_t wall, std::mt19937& random) {
  std::exponential_distribution<double> weight;
  Vector4 x = Vector4::Zero();
  double sum = 0;
  for (const Vector4& corner : corners_of_wall(cell, wall)) {
    const double share = weight(random);
    x += share * corner;
    sum += share;
  }
  if (is_horosphere(cell, wall))
    return geometry::to_model(model, geometry::on_horosphere(x / sum, wall_vector(cell, wall)));
  return geometry::to_model(model, x / std::sqrt(-geometry::lorentz_product(x, x)));
}

bool in_polygon(const ProxyMesh& mesh, const Eigen::Vector2d& p) {
  const std::size_t count = mesh.corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector2d a = mesh.corners[i].head<2>().cast<double>();
    const Eigen::Vector2d b = mesh.corners[(i + 1) % count].head<2>().cast<double>();
    if ((b - a).x() * (p - a).y() - (b - a).y() * (p - a).x() < 0) return false;
  }
  return count >= 4;
}

TEST(ViewerProxies, HoldTheirFaces) {
  constexpr int kSide = 400;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0, 1);
  for (const char* name : {"cPcbbbihq", "dLQabccjkjn", "eLMkbbddddhape", "dLQbccchrqg",
                           "dLQacccjjkg", "bkaaid", "cPcbbbihq 0=0", "dLQbcccherw 1=0"}) {
    const testing::Embedded manifold = *testing::try_embed_parabolic(name);
    for (const Model model : kModels) {
      const Scene scene = placed(manifold, 60, model).scene;
      const BoundingBall ball = bounding_ball(model, scene);
      const FaceSet set(model, scene, ball.radius);
      int seen = 0;
      for (int turn = 0; turn < 4; ++turn) {
        Camera camera;
        camera.azimuth = 360 * share(random);
        camera.elevation = 160 * share(random) - 80;
        camera.distance = 2.4 + 3 * share(random);
        const View view = view_of(camera, ball, kSide, kSide);
        const Projector projector(view, kSide, kSide);
        for (std::size_t i = 0; i < set.faces().size(); ++i) {
          const SceneFace& face = set.faces()[i];
          if (!has_wall(scene.cells[face.cell], face.wall)) continue;
          const std::span points(set.points().data() + face.first_point, face.point_count);
          ProxyMesh mesh;
          projector.add(points, face.margin, 0, mesh);
          const bool may = may_face(set.half_spaces()[i], points, face.margin, view.eye);
          for (int k = 0; k < 20; ++k) {
            const Vector3 p = random_point(model, scene.cells[face.cell], face.wall, random);
            EXPECT_LE((p - face.ball.centre).norm(), face.ball.radius * (1 + 1e-9));
            const BoundingBall& around = set.cell_balls()[face.cell];
            EXPECT_LE((p - around.centre).norm(), around.radius * (1 + 1e-9)) << name;
            const Vector4 clip = view.projection * view.model_view * p.homogeneous();
            const Eigen::Vector2d place = clip.head<2>() / clip[3];
            if (place.cwiseAbs().maxCoeff() < 1) {
              EXPECT_TRUE(in_polygon(mesh, place)) << name << " " << geometry::to_string(model);
            }
            const bool faces = set.half_spaces()[i].gradient(p).dot(p - view.eye) < 0;
            EXPECT_TRUE(may || !faces);
            seen += faces;
          }
        }
      }
      EXPECT_GT(seen, 1000);
    }
  }
}

// Two cells that are glued in the scene share a face, and no others do: here by the isometries.
TEST(ViewerFaceSet, KnowsSharedFaces) {
  for (const char* name : {"cPcbbbihq", "eLMkbbddddhape", "dLQbccchrqg", "cPcbbbiht", "bkaaid",
                           "cPcbbbihq 0=0", "dLQbcccherw 0=0"}) {
    const testing::Embedded manifold = *testing::try_embed_parabolic(name);
    for (const Model model : kModels) {
      const auto [cells, scene] = placed(manifold, 80, model);
      const FaceSet set(model, scene, bounding_ball(model, scene).radius);
      int shared = 0;
      for (const SceneFace& face : set.faces()) {
        if (!is_face(face.wall)) {
          EXPECT_FALSE(face.is_shared());
          continue;
        }
        const embedding::Cell& cell = cells[face.cell];
        const geometry::Matrix4 beyond =
            cell.isometry * manifold.embedding.face_pairings[cell.tetrahedron][face.wall];
        const bool there = std::ranges::any_of(cells, [&](const embedding::Cell& other) {
          return geometry::hyperbolic_distance(other.isometry.col(3), beyond.col(3)) < 1e-4;
        });
        EXPECT_EQ(face.is_shared(), there) << name << " " << geometry::to_string(model);
        shared += face.is_shared();
      }
      EXPECT_GE(shared, 2 * 79);  // every cell but the first was reached across a face
    }
  }
}

TEST(ViewerPace, FollowsTheTimeOfFrames) {
  double quality = 1;
  // A machine that needs 400 ms for all pixels settles where frames take what they should.
  for (int i = 0; i < 20; ++i) quality = next_quality(quality, 400 * quality * quality);
  EXPECT_NEAR(400 * quality * quality, kMovingFrame, 1e-6);
  for (int i = 0; i < 50; ++i) quality = next_quality(quality, 5);
  EXPECT_EQ(quality, 1);
  for (int i = 0; i < 50; ++i) quality = next_quality(quality, 1e6);
  EXPECT_EQ(quality, kCoarsest);
  EXPECT_GT(next_quality(0.5, 0), 0.5);
}

// Walls that have two corners in common bound each other. Two faces at a parabolic edge have none,
// and its wall is between them.
TEST(ViewerFaceSet, BoundsWallsByTheirNeighbours) {
  for (const char* name :
       {"cPcbbbihq", "cPcbbbiht", "cPcbbbihq 0=0", "dLQbcccherw 0=0", "dLQbcccherw 1=0"}) {
    const testing::Embedded manifold = *testing::try_embed_parabolic(name);
    for (const SceneCell& cell : placed(manifold, 4, Model::kPoincareBall).scene.cells) {
      const bool with_edge_walls = std::string(name).size() > 12;
      for (std::size_t wall = 0; wall < kWallCount; ++wall) {
        if (!has_wall(cell, wall)) continue;
        const auto bounds = bounds_of_wall(wall, with_edge_walls);
        EXPECT_EQ(bounds.size(), bound_count(record_kind(wall), with_edge_walls));
        const auto own = corners_of_wall(cell, wall);
        // They go around: each two next to each other lie on another wall.
        for (std::size_t k = 0; k < own.size(); ++k) {
          const auto on = [&](std::size_t other, const Vector4& x) {
            const double level = is_horosphere(cell, other) ? -1 : 0;
            return std::abs(geometry::lorentz_product(wall_vector(cell, other), x) - level) < 1e-9;
          };
          EXPECT_TRUE(on(wall, own[k]));
          EXPECT_EQ(std::ranges::count_if(bounds,
                                          [&](std::size_t other) {
                                            return has_wall(cell, other) && on(other, own[k]) &&
                                                   on(other, own[(k + 1) % own.size()]);
                                          }),
                    1)
              << name << " wall " << wall << " side " << k;
        }
        for (std::size_t other = 0; other < kWallCount; ++other) {
          if (other == wall || !has_wall(cell, other)) continue;
          const auto theirs = corners_of_wall(cell, other);
          const auto common = std::ranges::count_if(
              own, [&](const Vector4& corner) { return std::ranges::count(theirs, corner) > 0; });
          const bool touch = is_face(wall) && is_face(other) &&
                             parabolic_edge(cell, 5 - edge_between(wall, other)) != nullptr;
          if (touch) {
            EXPECT_EQ(common, 0);
          }
          EXPECT_EQ(std::ranges::count(bounds, other), common == 2 || touch ? 1 : 0)
              << name << " walls " << wall << ' ' << other;
        }
      }
    }
  }
}

}  // namespace
}  // namespace tripus::viewer
