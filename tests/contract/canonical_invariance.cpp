// The signature is one of the manifold: relabellings and moves leave it, mirrors change the sign.
#include <gtest/gtest.h>

#include "canonical/canonize.hpp"
#include "canonical/compare.hpp"
#include "tests/support/data_files.hpp"
#include "topology/cyclic_cover.hpp"
#include "topology/isomorphism.hpp"
#include "topology/isosig.hpp"
#include "topology/orientation.hpp"

namespace tripus::canonical {
namespace {

using topology::Gluings;
using topology::Triangulation;

/// A hundred geometric triangulations, from all three lists.
const std::vector<std::string>& sample() {
  static const std::vector<std::string> kSample = [] {
    std::vector<std::string> result = testing::data_lines("triangulations-2.txt");
    const auto take = [&](const char* file, std::size_t step, std::size_t count) {
      const auto lines = testing::data_lines(file);
      for (std::size_t k = 0; k < lines.size() && count > 0; k += step) {
        const Triangulation triangulation(topology::decode_isosig(lines[k]));
        structure::SolveOptions options;
        options.evidence = false;
        if (structure::solve(triangulation, options).outcome != structure::Outcome::kGeometric)
          continue;
        result.push_back(lines[k]);
        --count;
      }
    };
    take("triangulations-3.txt", 11, 12);
    take("triangulations-4.txt", 61, 80);
    return result;
  }();
  return kSample;
}

CanonicalManifold found(const Gluings& gluings) {
  CanonizeAnswer answer = canonize(Triangulation(gluings));
  if (!answer.manifold) throw std::runtime_error("unresolved: " + topology::isosig(gluings));
  return std::move(*answer.manifold);
}

std::string mirrored(std::string signature) {
  if (signature.back() == '+' || signature.back() == '-')
    signature.back() = signature.back() == '+' ? '-' : '+';
  return signature;
}

TEST(Signature, IsUnchangedByRelabelling) {
  ASSERT_EQ(sample().size(), 100u);
  for (const std::string& isosig : sample()) {
    SCOPED_TRACE(isosig);
    const Gluings gluings = topology::oriented(topology::decode_isosig(isosig));
    const CanonicalManifold manifold = found(gluings);
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
      const auto relabelling = topology::random_isomorphism(gluings.tetrahedron_count(), seed);
      const auto same = found(topology::relabelled(gluings, relabelling));
      ASSERT_EQ(same.signature.unoriented, manifold.signature.unoriented);
      ASSERT_EQ(same.order.code, manifold.order.code);
      ASSERT_EQ(same.isometries.order, manifold.isometries.order);
      // The labels of the new tetrahedron 0 say which way round it is.
      const auto& images = relabelling.tetrahedron_images;
      const auto first = static_cast<std::size_t>(std::ranges::find(images, 0u) - images.begin());
      ASSERT_EQ(same.signature.oriented, relabelling.perms[first].is_odd()
                                             ? mirrored(manifold.signature.oriented)
                                             : manifold.signature.oriented);
    }
  }
}

TEST(Signature, IsUnchangedByMoves) {
  int unresolved = 0, walks = 0;
  for (const std::string& isosig : sample()) {
    SCOPED_TRACE(isosig);
    const Gluings gluings = topology::oriented(topology::decode_isosig(isosig));
    const CanonicalManifold manifold = found(gluings);
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
      Gluings walked = gluings;
      topology::randomize(
          walked,
          {.count = 1 + seed % 4, .seed = seed, .max_tetrahedra = gluings.tetrahedron_count() + 2});
      CanonizeOptions options;
      options.retriangulation.budget = 200;
      const CanonizeAnswer answer = canonize(Triangulation(walked), options);
      ++walks;
      unresolved += !answer.manifold;
      if (!answer.manifold) continue;
      ASSERT_EQ(answer.manifold->signature.oriented, manifold.signature.oriented) << seed;
      ASSERT_EQ(answer.manifold->order.code, manifold.order.code) << seed;
    }
  }
  EXPECT_EQ(walks, 10000);
  EXPECT_EQ(unresolved, 0);
}

TEST(Signature, OfAmphicheiralManifoldsHasNoSign) {
  for (const std::string& isosig : sample()) {
    const CanonicalManifold manifold = found(topology::decode_isosig(isosig));
    const char last = manifold.signature.oriented.back();
    EXPECT_EQ(manifold.isometries.is_amphicheiral, last != '+' && last != '-') << isosig;
  }
}

/// Whether the map of flags respects all steps.
bool is_automorphism(const Decomposition& decomposition, const std::vector<FlagIndex>& image) {
  for (FlagIndex flag = 0; flag < image.size(); ++flag)
    for (int i = 0; i < 4; ++i)
      if (image[decomposition.step(i, flag)] != decomposition.step(i, image[flag])) return false;
  return true;
}

TEST(Isometries, AreAutomorphismsAndMakeTheGroup) {
  const Triangulation tripus(topology::decode_isosig("cPcbbbihq"));
  const auto shifts = topology::primitive_class(tripus);
  ASSERT_TRUE(shifts);
  for (const std::size_t degree : {1u, 2u, 3u, 5u}) {
    const CanonicalManifold cover =
        found(topology::cyclic_cover(tripus.gluings(), *shifts, degree));
    EXPECT_NEAR(cover.report.volume, 6.4519902708350328653 * static_cast<double>(degree), 1e-12);
    EXPECT_EQ(cover.isometries.order % degree, 0u);  // deck transformations
    const auto all =
        topology::all_isomorphisms(cover.triangulation.gluings(), cover.triangulation.gluings());
    EXPECT_EQ(cover.isometries.order, all.size());
    for (const auto& generator : cover.isometries.generators)
      EXPECT_TRUE(is_automorphism(cover.decomposition, generator));
  }
}

// Whatever is equal by signature is homeomorphic by comparison, and nothing else.
TEST(Compare, AgreesWithTheSignatures) {
  std::vector<CanonicalManifold> manifolds;
  for (std::size_t k = 0; k < 24; ++k)
    manifolds.push_back(found(topology::decode_isosig(sample()[k])));
  for (std::size_t a = 0; a < manifolds.size(); ++a) {
    for (std::size_t b = 0; b < manifolds.size(); ++b) {
      const Comparison comparison = compare(manifolds[a].triangulation, manifolds[b].triangulation);
      const bool same = manifolds[a].signature.unoriented == manifolds[b].signature.unoriented;
      EXPECT_EQ(comparison.verdict, same ? Verdict::kHomeomorphic : Verdict::kDifferent);
      EXPECT_FALSE(comparison.decided_by.empty());
      EXPECT_EQ(comparison.isometry.has_value(), same);
    }
  }
}

TEST(Compare, SaysWhatDistinguishes) {
  const auto verdict = [](const char* a, const char* b) {
    return compare(Triangulation(topology::decode_isosig(a)),
                   Triangulation(topology::decode_isosig(b)));
  };
  // Same boundary, homology and volume: only the decomposition is left.
  EXPECT_EQ(verdict("cPcbbbihq", "cPcbbbdhq").decided_by, "decomposition");
  EXPECT_EQ(verdict("cPcbbbihq", "cPcbbbdhq").verdict, Verdict::kDifferent);
  const auto [mirror, chiral] = std::pair("cMcabbjdw", "cPcbbbihq");
  const Comparison amphicheiral = verdict(mirror, mirror);
  EXPECT_TRUE(amphicheiral.keeps_orientation && amphicheiral.reverses_orientation);
  const Comparison itself = verdict(chiral, chiral);
  EXPECT_TRUE(itself.keeps_orientation && !itself.reverses_orientation);
}

}  // namespace
}  // namespace tripus::canonical
