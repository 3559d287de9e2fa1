// The view from inside against geodesics on the processor, which stay in the frame where they
// begin: the tetrahedra on their way are placed in it one after the other.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <tuple>

#include <gtest/gtest.h>

#include "geometry/boost.hpp"
#include "tests/support/embedded_manifolds.hpp"
#include "tests/support/one_renderer.hpp"
#include "viewer/web/thumbnail.hpp"

namespace tripus::viewer {
namespace {

using geometry::lorentz_product;
using geometry::Matrix4;

constexpr int kSide = 90;  // of square pictures
constexpr double kTube = 0.05, kInfinity = std::numeric_limits<double>::infinity();

/// What a geodesic meets: kind, tetrahedron, number of the vertex or edge.
using Met = std::tuple<int, std::size_t, std::size_t>;

double meet_plane(const Vector4& n, const Vector4& x, const Vector4& u) {
  const double towards = lorentz_product(n, u), ratio = -lorentz_product(n, x) / towards;
  return towards > 0 && ratio < 1 ? std::atanh(std::max(ratio, 0.0)) : kInfinity;
}

/// Where the product with a null vector rises to -1: (a + b) y^2 + 2 y + a - b = 0 for y = e^s.
double meet_horosphere(const Vector4& v, const Vector4& x, const Vector4& u) {
  const double a = lorentz_product(v, x), b = lorentz_product(v, u);
  const double root = 1 - (a + b) * (a - b);
  if (b <= 0 || root <= 0) return kInfinity;
  return std::max(0.0, std::log((b - a) / (1 + std::sqrt(root))));
}

/// Where the distance from the line through two vertices falls to the radius: what of a vector lies
/// along the line is told by its products with both.
double meet_tube(const Vector4& v, const Vector4& w, const Vector4& x, const Vector4& u) {
  const double c = lorentz_product(v, w), vv = std::round(lorentz_product(v, v)),
               ww = std::round(lorentz_product(w, w));
  const auto across = [&](const Vector4& p, const Vector4& q) {
    const double pv = lorentz_product(p, v), pw = lorentz_product(p, w), qv = lorentz_product(q, v),
                 qw = lorentz_product(q, w);
    return lorentz_product(p, q) -
           (ww * pv * qv + vv * pw * qw - c * (pv * qw + pw * qv)) / (vv * ww - c * c);
  };
  const double square = std::pow(std::sinh(kTube), 2);
  const double a = across(x, x) - square, b = across(x, u), d = across(u, u) + square;
  const double root = b * b - a * d;
  if (root <= 0 || a <= 0 || b >= 0) return kInfinity;
  const double t = a / (std::sqrt(root) - b);
  return t < 1 ? std::atanh(t) : kInfinity;
}

/// The direction of the ray through a place of the picture, in the walker's frame.
Vector3 ray_of(double px, double py) {
  constexpr double kTangent = 0.72;
  return Vector3((2 * px / kSide - 1) * kTangent, (1 - 2 * py / kSide) * kTangent, 1).normalized();
}

/// Nothing where that is too far for single precision.
std::optional<Met> trace(const testing::Embedded& manifold, const Walker& walker, double px,
                         double py) {
  constexpr double kFar = 4;
  constexpr std::array<std::array<std::size_t, 2>, 6> kEnds{
      {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
  const Vector4 x = walker.position(), u = walker.frame.leftCols<3>() * ray_of(px, py);
  Matrix4 place = Matrix4::Identity();
  std::size_t t = walker.tetrahedron;
  int came_by = -1;
  double gone = 0;
  for (int crossing = 0; crossing < 60; ++crossing) {
    const auto& shape = manifold.embedding.tetrahedra[t];
    double leaves = kInfinity;
    int face = -1;
    for (int f = 0; f < 4; ++f) {
      const double s = meet_plane(place * shape.faces[static_cast<std::size_t>(f)], x, u);
      if (f == came_by || s >= leaves) continue;
      leaves = s;
      face = f;
    }
    double first = kInfinity;
    Met met;
    const auto take = [&](double s, int kind, std::size_t number) {
      // A tube that was met beside an earlier tetrahedron was its business.
      if (s < gone - 1e-9 || s >= first) return;
      first = s;
      met = {kind, t, number};
    };
    for (std::size_t v = 0; v < 4; ++v) {
      const Vector4 pole = place * shape.vertices[v];
      if (shape.is_hyperideal(v)) take(meet_plane(pole, x, u), 1, v);
      if (shape.is_ideal(v)) take(meet_horosphere(pole, x, u), 1, v);
    }
    for (std::size_t e = 0; e < 6; ++e) {
      const Vector4 v = place * shape.vertices[kEnds[e][0]],
                    w = place * shape.vertices[kEnds[e][1]];
      // Where two truncations touch, a horosphere around that point is a wall.
      if (shape.is_parabolic(e))
        take(meet_horosphere(shape.parabolic_scale * (v + w), x, u), 1, 4 + e);
      else
        take(meet_tube(v, w, x, u), 2, e);
    }
    if (first < leaves) return first < kFar ? std::optional(met) : std::nullopt;
    if (face < 0 || leaves > kFar) return std::nullopt;
    gone = leaves;
    place = place * manifold.embedding.face_pairings[t][static_cast<std::size_t>(face)];
    const auto& gluings = manifold.triangulation.gluings();
    came_by = gluings.gluing(t, face)(face);
    t = gluings.neighbour(t, face);
  }
  return std::nullopt;
}

struct Compared {
  int rays = 0, moved = 0, wrong = 0;
  std::array<int, 3> kinds{};
  int edge_walls = 0;
};

/// Pixels show what their ray meets, or one less than a pixel away.
void compare_inside(const testing::Embedded& manifold, const InsideOptions& inside,
                    Compared& compared) {
  const auto shared = std::make_shared<const InsideManifold>(
      inside_manifold(manifold.embedding, manifold.triangulation));
  PictureOptions options;
  const Image image =
      one_renderer().draw_inside(shared, inside, options, kSide, kSide, Pixels::kIdentities);
  for (int y = 2; y < kSide; y += 5) {
    for (int x = 2; x < kSide; x += 5) {
      const auto at = 4 * static_cast<std::size_t>(kSide * y + x);
      const Met shown{image.pixels[at], image.pixels[at + 1], image.pixels[at + 2]};
      const auto met = trace(manifold, inside.walker, x + 0.5, y + 0.5);
      if (!met) continue;
      ++compared.rays;
      ++compared.kinds.at(static_cast<std::size_t>(std::get<0>(*met)));
      compared.edge_walls += std::get<0>(*met) == 1 && std::get<2>(*met) >= 4;
      if (met == shown) continue;
      ++compared.moved;
      bool near = false;
      for (const double dx : {-0.7, 0.0, 0.7})
        for (const double dy : {-0.7, 0.0, 0.7})
          near = near || trace(manifold, inside.walker, x + 0.5 + dx, y + 0.5 + dy) == shown;
      compared.wrong += !near;
    }
  }
}

/// From places in a manifold.
void compare_places(const std::string& signature, std::mt19937& random, Compared& all) {
  std::uniform_real_distribution<double> share(-1, 1);
  const testing::Embedded manifold = *testing::try_embed_parabolic(signature);
  const InsideManifold places = inside_manifold(manifold.embedding, manifold.triangulation);
  for (int n = 0; n < 6; ++n) {
    InsideOptions inside;
    inside.tube = kTube;
    inside.walker = standing_at(places, static_cast<StandingPlace>(n % 3));
    if (n >= 3) {  // elsewhere
      inside.walker.turn(3 * share(random), share(random), share(random));
      inside.walker.walk(places, {share(random), share(random), share(random)}, 1.5);
    }
    ASSERT_TRUE(stands_inside(places, inside.walker)) << signature << n;
    compare_inside(manifold, inside, all);
  }
}

TEST(ViewerInside, ShowsWhatGeodesicsMeet) {
  std::mt19937 random(20261130);
  Compared all;
  for (const char* signature :
       {"cPcbbbihq", "dLQbcccherw", "eLMkbbddddhape", "cPcbbbiht", "bkaaid", "dLQbccchrqg"})
    compare_places(signature, random, all);
  EXPECT_GT(all.rays, 8000);
  EXPECT_GT(all.kinds[1], 1000);
  EXPECT_GT(all.kinds[2], 1000);
  EXPECT_LE(1000 * all.wrong, all.rays);
  EXPECT_LE(20 * all.moved, all.rays);
}

TEST(ViewerInside, ShowsWhatGeodesicsMeetAtParabolicEdges) {
  std::mt19937 random(20261201);
  Compared all;
  for (const char* name : testing::kParabolic) compare_places(name, random, all);
  EXPECT_GT(all.rays, 8000);
  EXPECT_GT(all.kinds[1], 1000);
  EXPECT_GT(all.kinds[2], 100);
  EXPECT_GT(all.edge_walls, 1000);
  EXPECT_LE(1000 * all.wrong, all.rays);
  EXPECT_LE(20 * all.moved, all.rays);
}

// Thumbnails are made by rays of their own; they have no tubes.
TEST(ViewerInside, ThumbnailsShowTheSameWalls) {
  int compared = 0, edge_walls = 0;
  std::vector<const char*> names(std::begin(testing::kParabolic), std::end(testing::kParabolic));
  names.insert(names.end(), {"cPcbbbihq", "cPcbbbiht"});
  for (const char* name : names) {
    const testing::Embedded manifold = *testing::try_embed_parabolic(name);
    Walker walker;
    for (int turn = 0; turn < 3; ++turn, walker.turn(2, 0.6)) {
      for (int y = 2; y < kSide; y += 7) {
        for (int x = 2; x < kSide; x += 7) {
          const auto met = trace(manifold, walker, x + 0.5, y + 0.5);
          if (!met || std::get<0>(*met) != 1) continue;
          const Sight sight =
              look(manifold.embedding, manifold.triangulation, walker.tetrahedron,
                   walker.position(), walker.frame.leftCols<3>() * ray_of(x + 0.5, y + 0.5));
          ASSERT_TRUE(sight.wall);
          EXPECT_EQ(sight.tetrahedron, std::get<1>(*met)) << name;
          EXPECT_EQ(sight.vertex, std::get<2>(*met)) << name;
          EXPECT_GE(sight.side, -1e-9);
          ++compared;
          edge_walls += sight.vertex >= 4;
        }
      }
    }
  }
  EXPECT_GT(compared, 2000);
  EXPECT_GT(edge_walls, 300);
}

TEST(ViewerInside, WalksEndBeforeTheWalls) {
  std::mt19937 random(3);
  std::normal_distribution<double> part;
  for (const char* signature :
       {"cPcbbbihq", "cPcbbbiht", "bkaaid", "cPcbbbihq 0=0", "dLQbcccherw 1=0"}) {
    const testing::Embedded manifold = *testing::try_embed_parabolic(signature);
    const InsideManifold places = inside_manifold(manifold.embedding, manifold.triangulation);
    Walker walker = standing_at(places, StandingPlace::kCentre);
    int touched = 0;
    for (int n = 0; n < 40; ++n) {
      touched += walker.walk(places, {part(random), part(random), part(random)}, 3);
      ASSERT_TRUE(stands_inside(places, walker)) << signature << n;
      const auto& shape = places.tetrahedra[walker.tetrahedron];
      for (std::size_t v = 0; v < 4; ++v) {
        const double level = shape.is_hyperideal(v) ? -std::sinh(kWallClearance) : -1;
        EXPECT_LE(lorentz_product(shape.vertices[v], walker.position()), level + 1e-6);
      }
      for (std::size_t e = 0; e < 6; ++e) {
        if (!shape.is_parabolic(e)) continue;
        EXPECT_LE(lorentz_product(shape.parabolic_point(e), walker.position()), -1 + 1e-6);
      }
    }
    EXPECT_GT(touched, 20);
  }
}

// One who walks a little and turns the other way is where he was.
TEST(ViewerInside, WalksGoBack) {
  const testing::Embedded manifold = *testing::try_embed("dLQbcccherw");
  const InsideManifold places = inside_manifold(manifold.embedding, manifold.triangulation);
  Walker walker = standing_at(places, StandingPlace::kCentre);
  const Walker before = walker;
  EXPECT_FALSE(walker.walk(places, {0, 0, 1}, 0.2));
  EXPECT_NEAR(geometry::hyperbolic_distance(walker.position(), before.position()), 0.2,
              walker.tetrahedron == before.tetrahedron ? 1e-12 : 10);
  walker.turn(2 * std::acos(0.0), 0);
  EXPECT_FALSE(walker.walk(places, {0, 0, 1}, 0.2));
  walker.turn(2 * std::acos(0.0), 0);
  EXPECT_EQ(walker.tetrahedron, before.tetrahedron);
  EXPECT_LT((walker.frame - before.frame).cwiseAbs().maxCoeff(), 1e-9);
}

// Means of samples come together. Larger pictures have thinner lines, so they are no reference.
TEST(ViewerInside, SamplesMakeEdgesSmooth) {
  const testing::Embedded manifold = *testing::try_embed("cPcbbbihq");
  const auto shared = std::make_shared<const InsideManifold>(
      inside_manifold(manifold.embedding, manifold.triangulation));
  InsideOptions inside;
  inside.walker = standing_at(*shared, StandingPlace::kWall);
  PictureOptions options;
  const auto drawn = [&](int samples) {
    options.samples = samples;
    return one_renderer().draw_inside(shared, inside, options, kSide, kSide).pixels;
  };
  const auto apart = [](const std::vector<std::uint8_t>& one,
                        const std::vector<std::uint8_t>& other) {
    double sum = 0;
    for (std::size_t i = 0; i < one.size(); ++i) sum += std::pow(one[i] - other[i], 2);
    return sum;
  };
  const auto one = drawn(1), some = drawn(3), many = drawn(4);
  EXPECT_GT(apart(one, many), 1e5);
  EXPECT_LT(5 * apart(some, many), apart(one, many));
}

TEST(ViewerInside, RefusesPlacesBeyondTheWalls) {
  const testing::Embedded manifold = *testing::try_embed("cPcbbbihq");
  const auto shared = std::make_shared<const InsideManifold>(
      inside_manifold(manifold.embedding, manifold.triangulation));
  InsideOptions inside;
  inside.walker.frame = geometry::boost({5, 0, 0});
  EXPECT_THROW(one_renderer().draw_inside(shared, inside, {}, 10, 10), InvalidInput);
  inside = {};
  EXPECT_THROW(one_renderer().draw_inside(shared, inside, {}, 0, 10), InvalidInput);
}

}  // namespace
}  // namespace tripus::viewer
