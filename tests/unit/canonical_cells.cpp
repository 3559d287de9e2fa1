// Cells that no manifold of the census has: cubes, prisms, and one that must be coned from inside.
#include <string>

#include <gtest/gtest.h>

#include "canonical/canonize.hpp"
#include "topology/homology.hpp"
#include "topology/isomorphism.hpp"
#include "topology/isosig.hpp"
#include "topology/simplify/simplify.hpp"

namespace tripus::canonical {
namespace {

using topology::Gluings;
using topology::Triangulation;

CanonicalManifold found(const Gluings& gluings) {
  CanonizeAnswer answer = canonize(Triangulation(gluings));
  if (!answer.manifold) throw std::runtime_error("unresolved: " + topology::isosig(gluings));
  return std::move(*answer.manifold);
}

std::size_t finite_vertices(const Triangulation& triangulation) {
  std::size_t count = 0;
  for (std::size_t v = 0; v < triangulation.vertex_count(); ++v)
    count += triangulation.link(v).euler_characteristic == 2;
  return count;
}

/// Relabelling changes nothing, and the signature is a triangulation of the manifold that leads
/// back to it (laws K1 and K2).
void expect_invariant(const std::string& isosig, const CanonicalManifold& manifold) {
  const Gluings gluings = topology::decode_isosig(isosig);
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const CanonicalManifold same = found(topology::random_relabelling(gluings, seed));
    EXPECT_EQ(same.signature.unoriented, manifold.signature.unoriented);
    EXPECT_EQ(same.order.code, manifold.order.code);
    EXPECT_EQ(same.cells, manifold.cells);
  }
  const Triangulation decoded(topology::decode_isosig(manifold.signature.unoriented));
  EXPECT_EQ(first_homology(decoded), first_homology(Triangulation(gluings)));
  const Gluings ideal = finite_vertices(decoded) == 0
                            ? decoded.gluings()
                            : topology::simplify(decoded.gluings()).gluings;
  EXPECT_EQ(found(ideal).signature.unoriented, manifold.signature.unoriented);
}

// Glued from the faces of one cube and two prisms with a single edge or few, found by running
// through gluings at random.
TEST(Cells, AreCubesAndPrisms) {
  struct Case {
    const char* isosig;
    const char* cells;
  };
  for (const auto& [isosig, cells] :
       {Case{"gLLAQbcdeffflbbmqwg", "1 cube"}, Case{"gLLAQacedfffnkhhhha", "1 cube"},
        Case{"gLLPQcdeffeficqehhk", "2 prisms"}, Case{"gLLAQbecdffflhssprw", "2 prisms"},
        Case{"gvLQQcdefeffjwnhjhe", "2 prisms"}}) {
    SCOPED_TRACE(isosig);
    const CanonicalManifold manifold = found(topology::decode_isosig(isosig));
    EXPECT_EQ(manifold.cells, cells);
    EXPECT_TRUE(manifold.faces.precise);  // the cells are merged across zeros of 50 digits
    expect_invariant(isosig, manifold);
  }
}

TEST(Cells, OfACubeHaveItsFaces) {
  const CanonicalManifold manifold = found(topology::decode_isosig("gLLAQbcdeffflbbmqwg"));
  const CellType cube = cell_type(manifold.decomposition, 0);
  EXPECT_EQ(cube.vertex_count, 8u);
  EXPECT_EQ(cube.face_sizes, std::vector<std::size_t>(6, 4));
  EXPECT_EQ(manifold.decomposition.flag_count(), 48u);
  // All twelve edges are one, so that the cube is regular with angles pi/6: 48 divides into the
  // symmetries of the gluing.
  EXPECT_EQ(48 % manifold.isometries.order, 0u);
}

// A double cover of a manifold made of two prisms: for one of the four, no vertex allows the
// diagonals that the others have drawn, and its signature has a finite vertex inside.
TEST(Cells, AreConedFromInsideWhereNoVertexWillDo) {
  const std::string isosig = "mvLLzMMQQdghgfjkjljkllclxapowoecrhe";
  const CanonicalManifold manifold = found(topology::decode_isosig(isosig));
  EXPECT_EQ(manifold.cells, "4 prisms");
  const Triangulation decoded(topology::decode_isosig(manifold.signature.unoriented));
  EXPECT_EQ(finite_vertices(decoded), 1u);
  // Three tetrahedra a prism, and eight for the one with a point inside.
  EXPECT_EQ(decoded.tetrahedron_count(), 3u * 3u + 8u);
  expect_invariant(isosig, manifold);
}

}  // namespace
}  // namespace tripus::canonical
