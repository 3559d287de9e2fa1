// With cusps the signature is one of the manifold too, and with cone angles one of the orbifold.
#include <algorithm>
#include <stop_token>

#include <gtest/gtest.h>

#include "canonical/canonize.hpp"
#include "canonical/compare.hpp"
#include "tests/support/data_files.hpp"
#include "topology/isomorphism.hpp"
#include "topology/isosig.hpp"
#include "topology/labelled_isosig.hpp"
#include "topology/orientation.hpp"

namespace tripus::canonical {
namespace {

using topology::ConeAngle;
using topology::Gluings;
using topology::Triangulation;

CanonicalManifold found(const Gluings& gluings, std::vector<ConeAngle> cone_angles = {}) {
  CanonizeOptions options;
  options.solve.evidence = false;
  options.solve.cone_angles = std::move(cone_angles);
  CanonizeAnswer answer = canonize(Triangulation(gluings), options);
  if (!answer.manifold) throw std::runtime_error(topology::isosig(gluings) + ": " + answer.message);
  return std::move(*answer.manifold);
}

std::string flipped(std::string signature) {
  for (char& c : signature)
    if (c == '+' || c == '-') c = c == '+' ? '-' : '+';
  return signature;
}

bool is_reversed(const topology::Isomorphism& relabelling) {
  const auto& images = relabelling.tetrahedron_images;
  const auto first = static_cast<std::size_t>(std::ranges::find(images, 0u) - images.begin());
  return relabelling.perms[first].is_odd();
}

/// Every seventh of SnapPy's census, and the geometric ones of the list with geodesic boundary.
std::vector<std::string> sample() {
  std::vector<std::string> result;
  const auto rows = testing::data_table("cusped-census-5.tsv");
  for (std::size_t k = 0; k < rows.size(); k += 11) result.push_back(rows[k].at("isosig"));
  for (const std::string& isosig : testing::data_lines("triangulations-cusped.txt")) {
    structure::SolveOptions options;
    options.evidence = false;
    const Triangulation triangulation(topology::decode_isosig(isosig));
    if (structure::solve(triangulation, options).outcome == structure::Outcome::kGeometric)
      result.push_back(isosig);
  }
  return result;
}

TEST(CuspedSignature, IsUnchangedByRelabelling) {
  for (const std::string& isosig : sample()) {
    SCOPED_TRACE(isosig);
    const Gluings gluings = topology::oriented(topology::decode_isosig(isosig));
    const CanonicalManifold manifold = found(gluings);
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
      const auto relabelling = topology::random_isomorphism(gluings.tetrahedron_count(), seed);
      const auto same = found(topology::relabelled(gluings, relabelling));
      ASSERT_EQ(same.signature.unoriented, manifold.signature.unoriented);
      ASSERT_EQ(same.order.code, manifold.order.code);
      ASSERT_EQ(same.isometries.order, manifold.isometries.order);
      ASSERT_EQ(same.signature.oriented, is_reversed(relabelling)
                                             ? flipped(manifold.signature.oriented)
                                             : manifold.signature.oriented);
    }
  }
}

TEST(CuspedSignature, IsUnchangedByMoves) {
  int walks = 0, unresolved = 0;
  for (const std::string& isosig : sample()) {
    SCOPED_TRACE(isosig);
    const Gluings gluings = topology::oriented(topology::decode_isosig(isosig));
    const CanonicalManifold manifold = found(gluings);
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      Gluings walked = gluings;
      topology::randomize(
          walked,
          {.count = 1 + seed % 4, .seed = seed, .max_tetrahedra = gluings.tetrahedron_count() + 2});
      CanonizeOptions options;
      options.solve.evidence = false;
      const CanonizeAnswer answer = canonize(Triangulation(walked), options);
      ++walks;
      unresolved += !answer.manifold;
      if (!answer.manifold) continue;
      ASSERT_EQ(answer.manifold->signature.oriented, manifold.signature.oriented) << seed;
      ASSERT_EQ(answer.manifold->order.code, manifold.order.code) << seed;
    }
  }
  EXPECT_GT(walks, 300);
  EXPECT_EQ(unresolved, 0);
}

TEST(CuspedSignature, DecodesToTheManifold) {
  for (const std::string& isosig : sample()) {
    SCOPED_TRACE(isosig);
    const CanonicalManifold manifold = found(topology::decode_isosig(isosig));
    const Triangulation decoded(topology::decode_isosig(manifold.signature.oriented));
    bool has_finite = false;  // a cell that is coned from its inside
    for (std::size_t v = 0; v < decoded.vertex_count(); ++v)
      has_finite = has_finite || decoded.link(v).euler_characteristic == 2;
    if (has_finite) continue;
    EXPECT_EQ(found(decoded.gluings()).signature.oriented, manifold.signature.oriented);
  }
}

/// Triangulations with labels that carry metrics: cone orders 2 to 4 on one edge or on all, or
/// parabolic edges (order 0).
std::vector<std::pair<std::string, std::vector<ConeAngle>>> orbifolds() {
  std::vector<std::pair<std::string, std::vector<ConeAngle>>> result;
  for (const std::string isosig : {"cPcbbbiht", "cPcbbbdxm", "dLQbcccdxwb", "dLQacccjsjb",
                                   "eLAkbbcdddhwqn", "cPcbbbihq", "dLQacccjjkg", "bkaaid"}) {
    const Triangulation triangulation(topology::oriented(topology::decode_isosig(isosig)));
    for (std::size_t edge = 0; edge <= triangulation.edge_count(); ++edge) {
      for (const std::int64_t order : {0, 2, 3, 4}) {
        structure::SolveOptions options;
        options.evidence = false;
        options.cone_angles.resize(triangulation.edge_count());
        for (std::size_t e = 0; e < triangulation.edge_count(); ++e)
          if (e == edge || edge == triangulation.edge_count())
            options.cone_angles[e] =
                order == 0 ? ConeAngle::rational(0, 1) : ConeAngle::rational(2, order);
        if (structure::solve(triangulation, options).outcome == structure::Outcome::kGeometric)
          result.emplace_back(isosig, options.cone_angles);
      }
    }
  }
  return result;
}

std::string before_labels(const std::string& signature) {
  return signature.substr(0, signature.find(' '));
}

TEST(OrbifoldSignature, IsUnchangedByRelabellingAndDecodes) {
  int canonical = 0, parabolic = 0;
  for (const auto& [isosig, labels] : orbifolds()) {
    SCOPED_TRACE(isosig + " " + topology::labels_text(labels));
    const Gluings gluings = topology::oriented(topology::decode_isosig(isosig));
    CanonizeOptions options;
    options.solve.evidence = false;
    options.solve.cone_angles = labels;
    const CanonizeAnswer answer = canonize(Triangulation(gluings), options);
    if (!answer.manifold) continue;
    ++canonical;
    parabolic += std::ranges::any_of(labels, &ConeAngle::is_parabolic);
    const CanonicalManifold& manifold = *answer.manifold;
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      const auto relabelling = topology::random_isomorphism(gluings.tetrahedron_count(), seed);
      const Gluings turned = topology::relabelled(gluings, relabelling);
      const auto moved = topology::relabelled_edges(Triangulation(gluings), labels, relabelling,
                                                    Triangulation(turned));
      const CanonicalManifold same = found(turned, moved);
      ASSERT_EQ(same.signature.unoriented, manifold.signature.unoriented);
      ASSERT_EQ(same.isometries.order, manifold.isometries.order);
      // The two signs stand for two triangulations, with edges numbered in two ways.
      if (!is_reversed(relabelling)) {
        ASSERT_EQ(same.signature.oriented, manifold.signature.oriented);
      } else {
        ASSERT_EQ(before_labels(same.signature.oriented),
                  flipped(before_labels(manifold.signature.oriented)));
      }
    }
    EXPECT_TRUE(topology::all_full(labels) ||
                manifold.signature.unoriented.find('=') != std::string::npos);
  }
  EXPECT_GT(canonical, 20);
  EXPECT_GT(parabolic, 10);
}

// The edges of the tripus's relatives are all alike, those of the figure-eight knot's complement
// are exchanged by an isometry: labels distinguish them, and their orders do.
TEST(OrbifoldSignature, ComparesLabels) {
  const Triangulation m(topology::decode_isosig("cPcbbbiht"));
  const ConeAngle two = ConeAngle::rational(1, 1), three = ConeAngle::rational(2, 3);
  const Comparison same = compare(Labelled{m, {two, three}}, Labelled{m, {three, two}});
  EXPECT_EQ(same.verdict, Verdict::kHomeomorphic) << same.message;
  const Comparison other = compare(Labelled{m, {two, three}}, Labelled{m, {three, three}});
  EXPECT_EQ(other.verdict, Verdict::kDifferent) << other.message;
  const Comparison plain = compare(Labelled{m, {two, two}}, Labelled{m, {}});
  EXPECT_EQ(plain.verdict, Verdict::kDifferent) << plain.message;
  const ConeAngle zero = ConeAngle::rational(0, 1);
  const Comparison turned = compare(Labelled{m, {zero, two}}, Labelled{m, {two, zero}});
  EXPECT_EQ(turned.verdict, Verdict::kHomeomorphic) << turned.message;
  const Comparison nearly =
      compare(Labelled{m, {zero, two}}, Labelled{m, {ConeAngle::rational(2, 1000), two}});
  EXPECT_EQ(nearly.verdict, Verdict::kDifferent) << nearly.message;
}

// m086 and m109 need a way through flat tetrahedra: without a budget there is none, and no answer.
TEST(CuspedSignature, WaysThroughFlatTetrahedraKeepToTheBudget) {
  for (const auto& row : testing::data_table("cusped-census-5.tsv")) {
    if (row.at("name") != "m086" && row.at("name") != "m109") continue;
    SCOPED_TRACE(row.at("name"));
    const Triangulation triangulation(topology::decode_isosig(row.at("isosig")));
    CanonizeOptions options;
    EXPECT_TRUE(canonize(triangulation, options).manifold);
    options.proto_canonical.budget = 0;
    EXPECT_FALSE(canonize(triangulation, options).manifold);
    options.proto_canonical.budget = 2000;
    std::stop_source stop;
    stop.request_stop();
    options.proto_canonical.stop = stop.get_token();
    EXPECT_FALSE(canonize(triangulation, options).manifold);
  }
}

}  // namespace
}  // namespace tripus::canonical
