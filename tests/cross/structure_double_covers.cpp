// Random non-orientable triangulations and their orientable double covers: one verdict, twice the
// volume.
#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <random>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "structure/solve.hpp"
#include "topology/covers/covers.hpp"
#include "topology/isomorphism.hpp"
#include "topology/isosig.hpp"
#include "topology/orientation.hpp"
#include "topology/requirements.hpp"

namespace tripus::structure {
namespace {

using topology::Perm4;
using topology::Triangulation;

/// The faces of labelled tetrahedra glued in pairs at random; nothing where that is no
/// non-orientable triangulation that `solve` takes, or has a finite vertex.
std::optional<Triangulation> random_non_orientable(std::size_t tetrahedra,
                                                   std::mt19937_64& random) {
  std::vector<std::size_t> faces(4 * tetrahedra);
  std::iota(faces.begin(), faces.end(), std::size_t{0});
  std::ranges::shuffle(faces, random);
  topology::Gluings gluings(tetrahedra);
  for (std::size_t i = 0; i < faces.size(); i += 2) {
    const int f = static_cast<int>(faces[i] % 4), g = static_cast<int>(faces[i + 1] % 4);
    Perm4 p;
    do p = Perm4::from_rank(static_cast<int>(random() % 24));
    while (p(f) != g);
    gluings.glue(faces[i] / 4, f, static_cast<topology::TetrahedronIndex>(faces[i + 1] / 4), p);
  }
  if (topology::is_orientable(gluings)) return std::nullopt;
  try {
    Triangulation triangulation(gluings);
    topology::require_solvable(triangulation);
    for (std::size_t v = 0; v < triangulation.vertex_count(); ++v)
      if (triangulation.link(v).euler_characteristic > 0) return std::nullopt;
    return triangulation;
  } catch (
      const InvalidInput&) {  // an edge glued to itself the wrong way round, a projective plane
    return std::nullopt;
  }
}

TEST(NonOrientable, DoubleCoversOfRandomOnesHaveTheVerdictAndTwiceTheVolume) {
  std::mt19937_64 random(20261130);
  int geometric = 0, infeasible = 0;
  std::set<Outcome> outcomes;
  for (int draw = 0; geometric < 1000 && draw < 100000; ++draw) {
    const auto base = random_non_orientable(2 + static_cast<std::size_t>(draw % 7), random);
    if (!base) continue;
    SCOPED_TRACE(draw);
    const topology::Cover cover = topology::orientable_double_cover(*base);
    const Triangulation above(cover.gluings);
    ASSERT_TRUE(above.is_orientable());
    const Report below = solve(*base), report = solve(above);
    EXPECT_EQ(report.outcome, below.outcome) << report.message;
    outcomes.insert(below.outcome);
    if (below.outcome == Outcome::kInfeasible) {
      ++infeasible;
      ASSERT_TRUE(below.certificate && report.certificate);
      EXPECT_TRUE(check(*base, *below.certificate)) << check(*base, *below.certificate).reason;
      EXPECT_TRUE(check(above, *report.certificate)) << check(above, *report.certificate).reason;
    }
    if (below.outcome != Outcome::kGeometric) continue;
    ++geometric;
    EXPECT_GE(below.volume, 1.0149416064);  // Gieseking's is the least with a cusp (C. Adams)
    EXPECT_NEAR(report.volume, 2 * below.volume, 1e-11 * report.volume);
  }
  EXPECT_EQ(geometric, 1000);
  EXPECT_GT(infeasible, 20);
  EXPECT_TRUE(outcomes.contains(Outcome::kGeometric) && outcomes.contains(Outcome::kInfeasible));
}

// Found by the draws above, in other labels. In the first pair all tetrahedra become thinner and
// thinner, with curvatures below any tolerance. In the others the tetrahedra that are not flat come
// apart, into pieces with cusps of their own.
TEST(NonOrientable, PairsThatFloatingPointHasTaughtUs) {
  struct Pair {
    const char *below, *above;
    Outcome outcome;
  };
  for (const auto& [below, above, outcome] :
       {Pair{"cMcabbile", "eLMkbcddddlihe", Outcome::kInfeasible},
        Pair{"dLQacccdqqu", "gLLMQceeefffdllpiih", Outcome::kDegenerate},
        Pair{"dLQacccdquu", "gLLMQceeefffdalphih", Outcome::kDegenerate},
        Pair{"eLMkbcdddabccb", "iLLLQPcceegfghhhatataatta", Outcome::kDegenerate},
        Pair{"gLLAQadedfffjmdigpp", "mLLAMzzQPadedfghjjkklljmdigaadgowpn", Outcome::kDegenerate}})
    for (const char* signature : {below, above})
      for (std::uint64_t seed = 0; seed < 20; ++seed) {
        SCOPED_TRACE(signature);
        const Triangulation m(
            topology::random_relabelling(topology::decode_isosig(signature), seed));
        const Report report = solve(m);
        EXPECT_EQ(report.outcome, outcome) << seed << ": " << report.message;
        ASSERT_TRUE(report.certificate);
        EXPECT_TRUE(check(m, *report.certificate)) << check(m, *report.certificate).reason;
        EXPECT_EQ(report.certificate->kind, Certificate::Kind::kSemi);
        SolveOptions quick;
        quick.evidence = false;
        EXPECT_NE(solve(m, quick).outcome, Outcome::kGeometric);
      }
}

}  // namespace
}  // namespace tripus::structure
