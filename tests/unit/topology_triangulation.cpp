#include <vector>

#include <gtest/gtest.h>

#include "topology/components.hpp"
#include "topology/requirements.hpp"
#include "topology/triangulation.hpp"

namespace tripus::topology {
namespace {

/// The knotted Y as the paper glues it.
Gluings glued_knotted_y() {
  Gluings gluings(2);
  gluings.glue(0, 0, 1, Perm4::from_images(1, 2, 3, 0));  // A1 -> B2: b->c, d->a, c->d
  gluings.glue(0, 1, 1, Perm4::from_images(3, 0, 1, 2));
  gluings.glue(0, 2, 1, Perm4::from_images(0, 3, 2, 1));
  gluings.glue(0, 3, 1, Perm4::from_images(0, 2, 1, 3));
  return gluings;
}

TEST(Perm4, TablesObeyTheGroupLaws) {
  for (int i = 0; i < 24; ++i) {
    const Perm4 p = Perm4::from_rank(i);
    EXPECT_EQ(Perm4::from_images(p(0), p(1), p(2), p(3)), p);
    EXPECT_EQ(p * p.inverse(), Perm4());
    EXPECT_EQ(p.inverse() * p, Perm4());
    for (int j = 0; j < 24; ++j) {
      const Perm4 q = Perm4::from_rank(j);
      for (int k = 0; k < 4; ++k) EXPECT_EQ((p * q)(k), p(q(k)));
      EXPECT_EQ((p * q).is_odd(), p.is_odd() != q.is_odd());
    }
  }
}

TEST(Perm4, RanksAreLexicographic) {
  for (int i = 0; i + 1 < 24; ++i)
    EXPECT_LT(word(Perm4::from_rank(i)), word(Perm4::from_rank(i + 1)));
}

TEST(Triangulation, KnottedYHasOneEdgeAndOneVertexOfGenusTwo) {
  const Triangulation y(glued_knotted_y());
  EXPECT_EQ(y.tetrahedron_count(), 2u);
  ASSERT_EQ(y.edge_count(), 1u);
  EXPECT_EQ(y.valence(0), 12u);
  ASSERT_EQ(y.vertex_count(), 1u);
  EXPECT_EQ(y.link(0).euler_characteristic, -2);
  EXPECT_EQ(y.link(0).genus(), 2);
  EXPECT_EQ(y.link(0).triangle_count, 8u);
  EXPECT_TRUE(y.link(0).orientable);
  EXPECT_TRUE(y.is_orientable());
  EXPECT_TRUE(y.is_connected());
  EXPECT_NO_THROW(require_solvable(y));
}

// Law T3: consecutive corners share the face between them.
TEST(Triangulation, CornersFollowOneAnotherAroundTheEdge) {
  const Triangulation y(glued_knotted_y());
  const auto corners = y.corners(0);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const EdgeCorner here = corners[i];
    const EdgeCorner next = corners[(i + 1) % corners.size()];
    bool shared = false;
    for (int f = 0; f < 4; ++f) {
      auto ends = kEdgeEnds[static_cast<std::size_t>(here.edge())];
      if (f == ends[0] || f == ends[1]) continue;
      if (y.gluings().neighbour(here.tetrahedron(), f) != next.tetrahedron()) continue;
      if (here.reversed()) std::swap(ends[0], ends[1]);
      auto wanted = kEdgeEnds[static_cast<std::size_t>(next.edge())];
      if (next.reversed()) std::swap(wanted[0], wanted[1]);
      const Perm4 p = y.gluings().gluing(here.tetrahedron(), f);
      shared = shared || (p(ends[0]) == wanted[0] && p(ends[1]) == wanted[1]);
    }
    EXPECT_TRUE(shared) << "between corners " << i << " and the next";
  }
}

TEST(Triangulation, ComponentsComeApart) {
  const Gluings one = glued_knotted_y();
  Gluings two(4);
  for (std::size_t t = 0; t < 2; ++t)
    for (int f = 0; f < 4; ++f) {
      two.set_one_side(2 * t, f, 2 * one.neighbour(t, f), one.gluing(t, f));
      two.set_one_side(2 * t + 1, f, 2 * one.neighbour(t, f) + 1, one.gluing(t, f));
    }
  const Triangulation both(two);
  EXPECT_EQ(both.component_count(), 2u);
  const auto parts = components(both);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].gluings(), one);
  EXPECT_EQ(parts[1].gluings(), one);
}

}  // namespace
}  // namespace tripus::topology
