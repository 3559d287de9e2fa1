// Cone angles, the kinds of vertices that they make, Orb's files.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "topology/formats/formats.hpp"
#include "topology/isosig.hpp"
#include "topology/requirements.hpp"
#include "topology/vertex_kinds.hpp"

namespace tripus::topology {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(ConeAngle, OrdersAreExact) {
  EXPECT_EQ(parse_cone_order("1"), ConeAngle());
  EXPECT_TRUE(parse_cone_order("1").is_full());
  EXPECT_EQ(parse_cone_order("3"), ConeAngle::rational(2, 3));
  EXPECT_EQ(parse_cone_order("5/2"), ConeAngle::rational(4, 5));
  EXPECT_EQ(parse_cone_order("2.50"), ConeAngle::rational(4, 5));
  EXPECT_TRUE(parse_cone_order("0").is_parabolic());
  EXPECT_DOUBLE_EQ(parse_cone_order("7").radians(), 2 * kPi / 7);
  for (const char* order : {"0", "1", "2", "3", "5/2", "1000"})
    EXPECT_EQ(parse_cone_order(order).order_text(), order);
}

TEST(ConeAngle, WrongOrdersAreRefusedWithTheRemedy) {
  for (const char* order : {"", "-2", "1.5", "3/2", "0.5", "nan", "inf", "2pi", "1e3", "3/0", "x",
                            "99999999999999999999"}) {
    SCOPED_TRACE(order);
    try {
      parse_cone_order(order);
      ADD_FAILURE() << "accepted";
    } catch (const InvalidInput& error) {
      EXPECT_THAT(error.what(), ::testing::HasSubstr("is not a cone order; write 1"));
    }
  }
}

TEST(ConeAngle, DoublesThatAreFractionsOfPiAreKnown) {
  for (int q = 1; q <= 1000; q += 37)
    for (int p = 1; p <= 2 * q; p += 1 + q / 9) {
      const ConeAngle angle = p * kPi / q;
      ASSERT_TRUE(angle.is_rational()) << p << "/" << q;
      EXPECT_EQ(angle.numerator() * q, angle.denominator() * p);
    }
  for (const double x : {1.0, 3.0, 3.14159, 6.28}) EXPECT_FALSE(ConeAngle(x).is_rational()) << x;
  EXPECT_TRUE(ConeAngle(0.0).is_parabolic());
}

/// The first triangulation has one vertex, with a torus link, and two edge classes with both ends
/// there.
std::vector<OrbifoldLink> links(const char* isosig, const std::vector<const char*>& orders) {
  std::vector<ConeAngle> angles;
  for (const char* order : orders) angles.push_back(parse_cone_order(order));
  return orbifold_links(Triangulation(decode_isosig(isosig)), angles);
}

TEST(OrbifoldLinks, TheSignOfTheEulerCharacteristicDecides) {
  EXPECT_EQ(links("cPcbbbiht", {"1", "1"})[0].kind, VertexKind::kIdeal);
  EXPECT_EQ(links("cPcbbbiht", {"1", "2"})[0].kind, VertexKind::kHyperideal);
  EXPECT_DOUBLE_EQ(links("cPcbbbiht", {"2", "3"})[0].euler_characteristic, -1 - 4.0 / 3);
  EXPECT_EQ(links("cPcbbbiht", {"2", "3"})[0].cone_points, 4u);
  EXPECT_EQ(links("cPcbbbihq", {"1"})[0].kind, VertexKind::kHyperideal);
}

// Spheres with cone points of orders (2,3,6), (2,4,4), (3,3,3), (2,2,2,2) are Euclidean, exactly.
TEST(OrbifoldLinks, EuclideanSpheresAreIdealExactly) {
  // One tetrahedron folded twice onto itself: its edges are singular in the examples below.
  const Triangulation m(decode_isosig("bkaagj"));
  const auto angle = [](double order) { return ConeAngle(2 * kPi / order); };
  int ideal = 0;
  for (const double a : {2.0, 3.0, 4.0, 5.0, 6.0})
    for (const double b : {2.0, 3.0, 4.0, 5.0, 6.0}) {
      std::vector<ConeAngle> angles(m.edge_count(), angle(a));
      angles.back() = angle(b);
      for (const OrbifoldLink& link : orbifold_links(m, angles)) {
        if (link.kind == VertexKind::kIdeal) {
          ++ideal;
          EXPECT_EQ(link.euler_characteristic, 0);
        } else {
          EXPECT_GT(std::fabs(link.euler_characteristic), 1e-2);
        }
      }
    }
  EXPECT_GT(ideal, 0);
}

std::string objection(const char* isosig, const std::vector<const char*>& orders) {
  const Triangulation m(decode_isosig(isosig));
  std::vector<ConeAngle> angles(m.edge_count());
  for (std::size_t e = 0; e < orders.size(); ++e) angles[e] = parse_cone_order(orders[e]);
  try {
    require_solvable(m, angles);
    return {};
  } catch (const InvalidInput& error) {
    return error.what();
  }
}

TEST(Requirements, WhatSolveTakesAndWhatItRefuses) {
  EXPECT_EQ(objection("cPcbbbihq", {}), "");
  EXPECT_EQ(objection("cPcbbbiht", {}), "");
  EXPECT_EQ(objection("bkaaid", {}), "");
  EXPECT_EQ(objection("bkaagj", {}), "");  // closed: finite vertices
  EXPECT_EQ(objection("cPcbbbihq", {"0"}), "");
  EXPECT_THAT(objection("cPcbbbihqcPcbbbihq", {}), ::testing::HasSubstr("2 components"));
}

// A parabolic edge makes its ends hyperideal unless other labels undo that: at a sphere with two
// more cone points of order 2 it ends at a cusp.
TEST(Requirements, AParabolicEdgeAtACuspIsRefusedWithItsPlace) {
  // The double of a tetrahedron along its boundary: every vertex link is a sphere with three cone
  // points, one of each edge there.
  Gluings two(2);
  for (int f = 0; f < 4; ++f) two.glue(0, f, 1, Perm4());
  const Triangulation m(two);
  ASSERT_EQ(m.edge_count(), 6u);
  std::vector<ConeAngle> angles(6, ConeAngle::rational(1, 1));
  angles[m.edge_class(0, 0)] = ConeAngle::rational(0, 1);  // (2, 2, infinity) at both ends
  try {
    require_solvable(m, angles);
    ADD_FAILURE() << "accepted";
  } catch (const InvalidInput& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("edge class 0 is parabolic (cone angle 0)"));
    EXPECT_THAT(error.what(), ::testing::HasSubstr("end at a cusp"));
  }
  // (2, 3, infinity) is a hyperbolic triangle.
  for (int e = 1; e < 6; ++e) angles[m.edge_class(0, e)] = ConeAngle::rational(2, 3);
  EXPECT_NO_THROW(require_solvable(m, angles));
}

TEST(Requirements, BadOrbifoldsAndProjectivePlanesAreRefused) {
  Gluings two(2);
  for (int f = 0; f < 4; ++f) two.glue(0, f, 1, Perm4());
  const Triangulation m(two);
  std::vector<ConeAngle> angles(6);
  angles[0] = ConeAngle::rational(1, 1);
  try {
    require_solvable(m, angles);
    ADD_FAILURE() << "accepted";
  } catch (const InvalidInput& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("a sphere with one cone point"));
  }
  int projective = 0;
  std::mt19937_64 random(4);
  for (int n = 0; n < 20000 && projective == 0; ++n) {
    std::array<int, 8> faces{0, 1, 2, 3, 4, 5, 6, 7};
    std::ranges::shuffle(faces, random);
    Gluings gluings(2);
    for (std::size_t i = 0; i < 8; i += 2) {
      const int f = faces[i] % 4, g = faces[i + 1] % 4;
      Perm4 p;
      do p = Perm4::from_rank(static_cast<int>(random() % 24));
      while (p(f) != g);
      gluings.glue(std::size_t(faces[i] / 4), f, TetrahedronIndex(faces[i + 1] / 4), p);
    }
    try {
      require_solvable(Triangulation(gluings));
    } catch (const InvalidInput& error) {
      projective += std::string(error.what()).find("is a projective plane") != std::string::npos;
    }
  }
  EXPECT_GT(projective, 0);
}

TEST(ConeAngles, CompletedNamesTheEdgeClass) {
  EXPECT_EQ(completed({}, 3).size(), 3u);
  const std::vector<ConeAngle> wrong = {1.0, -1.0};
  EXPECT_THROW(completed(wrong, 3), InvalidInput);
  try {
    completed(wrong, 2);
    ADD_FAILURE();
  } catch (const InvalidInput& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("edge class 1"));
  }
}

TEST(Formats, ConeOrdersInJsonComeBack) {
  NamedGluings labelled{"m", decode_isosig("cPcbbbiht"), {}};
  labelled.cone_angles = {parse_cone_order("5/2"), parse_cone_order("0")};
  const NamedGluings back = read_triangulation(write_json(labelled));
  EXPECT_EQ(back.gluings, labelled.gluings);
  EXPECT_EQ(back.cone_angles, labelled.cone_angles);
}

TEST(Formats, OrbFilesComeBack) {
  for (const char* isosig : {"cPcbbbiht", "cPcbbbihq", "dLQacccjjkg", "eLAkbbcddpuctj"}) {
    SCOPED_TRACE(isosig);
    NamedGluings labelled{"some name", decode_isosig(isosig), {}};
    labelled.cone_angles.resize(Triangulation(labelled.gluings).edge_count());
    labelled.cone_angles[0] = parse_cone_order("3");
    const std::string text = write_orb(labelled);
    EXPECT_EQ(detect_format(text), "Orb triangulation");
    const NamedGluings back = read_triangulation(text);
    EXPECT_EQ(back.name, labelled.name);
    EXPECT_EQ(topology::isosig(back.gluings), isosig);
    // Written again it is the same to the last letter.
    EXPECT_EQ(write_orb(back), text);
    const Triangulation before(labelled.gluings), after(back.gluings);
    int singular = 0;
    for (std::size_t e = 0; e < after.edge_count(); ++e) {
      if (back.cone_angles[e].is_full()) continue;
      ++singular;
      EXPECT_EQ(back.cone_angles[e], labelled.cone_angles[0]);
      EXPECT_EQ(after.valence(e), before.valence(0));
    }
    EXPECT_EQ(singular, 1);
    std::string macintosh = text;
    std::ranges::replace(macintosh, '\n', '\r');
    EXPECT_EQ(read_triangulation(macintosh).gluings, back.gluings);
  }
  EXPECT_THROW(write_orb({"Gieseking", decode_isosig("bkaaid"), {}}), InvalidInput);
}

TEST(Formats, BrokenOrbFilesAreRefusedWithTheirLine) {
  const std::string good = write_orb({"x", decode_isosig("cPcbbbihq"), {}});
  const auto refused = [](const std::string& text, const char* part) {
    try {
      read_orb(text);
      ADD_FAILURE() << text;
    } catch (const InvalidInput& error) {
      EXPECT_THAT(error.what(), ::testing::HasSubstr(part));
    }
  };
  refused("% orb", "expected \"% orb\", a name");
  refused("% orb\nx\nSolutionType y\n1 0 1 1uu\n", "line 4: \"1uu\" is not a corner");
  refused("% orb\nx\nSolutionType y\n1 0 1.5 1uv\n", "line 4: \"1.5\" is not a cone order");
  refused("% orb\nx\nSolutionType y\n1 0 1 1uv\n", "1 corners, but 1 tetrahedra have 6");
  refused("% orb\nx\nSolutionType y\n1 0 1 9999999999uv\n", "is not a corner");
  refused("% orb\nx\nSolutionType y\na 0 1 1uv\n", "line 4: expected the index");
  std::string twice = good;
  const std::size_t corner = twice.find("1uv");
  if (corner != std::string::npos) refused(twice.replace(corner, 3, "1vu"), "Orb file");
}

}  // namespace
}  // namespace tripus::topology
