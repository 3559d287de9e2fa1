// The claims of docs/verdicts.md, on all small triangulations or a sample of them; scripts/verdicts
// measures them in full.
#include <atomic>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "structure/method.hpp"
#include "structure/obstruction.hpp"
#include "tests/support/data_files.hpp"
#include "tests/support/verdict_trials.hpp"
#include "topology/isomorphism.hpp"

namespace tripus::structure {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using tripus::testing::data_lines;
using tripus::testing::decode;

tripus::testing::VerdictCounts count_verdicts(const std::string& file) {
  tripus::testing::VerdictCounts counts;
  for (const auto& signature : data_lines(file)) {
    const auto triangulation = decode(signature);
    tripus::testing::count_verdict(signature, triangulation, solve(triangulation), counts);
  }
  return counts;
}

// Nothing is unresolved, and every verdict has its evidence: fault_of checks certificates and
// strict angles exactly, and minimisers with flat tetrahedra by formulae of its own.
TEST(Verdicts, OfTwoAndThreeTetrahedra) {
  const auto two = count_verdicts("triangulations-2.txt"),
             three = count_verdicts("triangulations-3.txt");
  EXPECT_THAT(two.wrong, IsEmpty());
  EXPECT_THAT(three.wrong, IsEmpty());
  EXPECT_EQ(two.geometric, 8);
  EXPECT_EQ(three.geometric, 166);
  EXPECT_EQ(three.infeasible_semi, 24);
  EXPECT_EQ(three.infeasible_none, 50);
}

// Strict and semi add up to the counts of the angle programme in structure_certificates.cpp.
TEST(Verdicts, OfFourTetrahedra) {
  const auto four = count_verdicts("triangulations-4.txt");
  EXPECT_THAT(four.wrong, IsEmpty());
  EXPECT_EQ(four.triangulations, 11048);
  EXPECT_EQ(four.geometric, 5820);
  EXPECT_EQ(four.degenerate_strict, 14);
  EXPECT_EQ(four.degenerate_semi + four.infeasible_semi, 1643);
  EXPECT_EQ(four.infeasible_none, 3571);
}

TEST(Verdicts, OfTheTableWithoutMetric) {
  for (const auto& row : tripus::testing::data_table("nongeometric-3.tsv")) {
    SCOPED_TRACE(row.at("isosig"));
    const auto triangulation = decode(row.at("isosig"));
    const Report report = solve(triangulation);
    ASSERT_TRUE(report.certificate);
    EXPECT_TRUE(check(triangulation, *report.certificate));
    const bool none = std::stod(row.at("angle_margin")) < -1e-5;
    EXPECT_EQ(report.certificate->kind, none ? Certificate::Kind::kNone : Certificate::Kind::kSemi);
    EXPECT_TRUE(report.outcome == Outcome::kInfeasible ||
                (!none && report.outcome == Outcome::kDegenerate));
  }
}

TEST(Verdicts, OfTheTableOfBoundaryCases) {
  for (const auto& row : tripus::testing::data_table("boundary-case-4.tsv")) {
    SCOPED_TRACE(row.at("isosig"));
    const auto triangulation = decode(row.at("isosig"));
    const Report report = solve(triangulation);
    ASSERT_EQ(report.outcome, Outcome::kDegenerate);
    EXPECT_FALSE(report.certificate);
    EXPECT_EQ(report.flat_tetrahedra.size(), 1u);
    ASSERT_TRUE(report.strict_angles);
    EXPECT_TRUE(check(triangulation, *report.strict_angles));
    EXPECT_EQ(tripus::testing::fault_of(triangulation, report), "");
    EXPECT_THAT(report.message, HasSubstr("1 of the 4 tetrahedra is flat"));
    EXPECT_EQ(report.advice, Advice::kRetriangulate);
  }
}

/// Every boundary case, every 3-tetrahedron triangulation without metric, and a sample of the rest.
std::vector<std::string> sample(std::size_t step) {
  std::vector<std::string> signatures;
  for (const char* table : {"boundary-case-4.tsv", "nongeometric-3.tsv"})
    for (const auto& row : tripus::testing::data_table(table))
      signatures.push_back(row.at("isosig"));
  const auto all = data_lines("triangulations-4.txt");
  for (std::size_t k = 0; k < all.size(); k += step) signatures.push_back(all[k]);
  return signatures;
}

class VerdictByMethod : public ::testing::TestWithParam<const char*> {};

TEST_P(VerdictByMethod, IsThatOfTheDefaultOptions) {
  // A flow takes seconds to run to infinity.
  const std::size_t step = std::string(GetParam()).starts_with("flow") ? 15 : 1;
  const auto signatures = sample(97);
  for (std::size_t k = 0; k < signatures.size(); k += step) {
    SCOPED_TRACE(signatures[k]);
    const auto triangulation = decode(signatures[k]);
    SolveOptions options;
    options.method = GetParam();
    const Report report = solve(triangulation, options);
    EXPECT_EQ(tripus::testing::verdict_of(report),
              tripus::testing::verdict_of(solve(triangulation)));
    EXPECT_EQ(tripus::testing::fault_of(triangulation, report), "");
  }
}
INSTANTIATE_TEST_SUITE_P(All, VerdictByMethod,
                         ::testing::Values("newton", "newton-cg", "ceres-lbfgs", "angles:newton",
                                           "flow:newton-flow/rk4"),
                         [](const auto& method) {
                           std::string name = method.param;
                           std::erase_if(name, [](char c) { return std::isalnum(c) == 0; });
                           return name;
                         });

TEST(Verdicts, DoNotDependOnTheStart) {
  for (const auto& signature : sample(61)) {
    SCOPED_TRACE(signature);
    const auto triangulation = decode(signature);
    const std::string expected = tripus::testing::verdict_of(solve(triangulation));
    SolveOptions options;
    for (const double length : {1e-8, 1e-3, 1.0, 37.8, 1e3, 1e5}) {
      options.initial_length = length;
      EXPECT_EQ(tripus::testing::verdict_of(solve(triangulation, options)), expected) << length;
    }
    options.initial_length = 0;
    std::mt19937_64 random(61);
    std::uniform_real_distribution<double> exponent(-6, 4);
    options.initial_lengths.resize(triangulation.edge_count());
    for (int start = 0; start < 5; ++start) {
      for (double& l : options.initial_lengths) l = std::pow(10, exponent(random));
      EXPECT_EQ(tripus::testing::verdict_of(solve(triangulation, options)), expected) << start;
    }
  }
}

TEST(Verdicts, DoNotDependOnTheLabels) {
  for (const auto& signature : sample(13)) {
    SCOPED_TRACE(signature);
    const auto original = decode(signature);
    const topology::Triangulation shuffled(topology::random_relabelling(original.gluings(), 13));
    const Report a = solve(original), b = solve(shuffled);
    EXPECT_EQ(tripus::testing::verdict_of(a), tripus::testing::verdict_of(b));
    EXPECT_EQ(a.flat_tetrahedra.size(), b.flat_tetrahedra.size());
    EXPECT_EQ(tripus::testing::fault_of(shuffled, b), "");
  }
}

// Where one length is past 38 its angles do not change any more, and all the sums are 2 pi in
// floating point: what is computed as K = 0 there is no metric.
TEST(Verdicts, AreNotDeceivedBySaturatedAngles) {
  for (const auto& row : tripus::testing::data_table("nongeometric-3.tsv")) {
    SCOPED_TRACE(row.at("isosig"));
    const auto triangulation = decode(row.at("isosig"));
    const std::string expected = tripus::testing::verdict_of(solve(triangulation));
    std::mt19937_64 random(62);
    std::uniform_real_distribution<double> length(0.1, 70);
    SolveOptions options;
    options.initial_lengths.resize(triangulation.edge_count());
    for (int start = 0; start < 100; ++start) {
      for (double& l : options.initial_lengths) l = length(random);
      EXPECT_EQ(tripus::testing::verdict_of(solve(triangulation, options)), expected);
    }
  }
}

class Starts : public ::testing::TestWithParam<const char*> {};

TEST_P(Starts, ReachTheSameMetric) {
  tripus::testing::StartTrials trials;
  for (const auto& signature : data_lines("triangulations-2.txt"))
    tripus::testing::try_starts(signature, GetParam(), 100, trials);
  for (const auto& signature : data_lines("triangulations-3.txt"))
    tripus::testing::try_starts(signature, GetParam(), 20, trials);
  const auto four = data_lines("triangulations-4.txt");
  for (std::size_t k = 0; k < four.size(); k += 50)
    tripus::testing::try_starts(four[k], GetParam(), 10, trials);
  EXPECT_THAT(trials.failed, IsEmpty());
  EXPECT_LE(trials.worst, 1e-11);
  EXPECT_GT(trials.solves, 5000);
}
INSTANTIATE_TEST_SUITE_P(All, Starts, ::testing::Values("newton", "newton-cg"),
                         [](const auto& method) {
                           return std::string(method.param) == "newton" ? "newton" : "newton_cg";
                         });

TEST(Retriangulation, UndoesRandomMoves) {
  std::vector<std::string> geometric;
  const auto four = data_lines("triangulations-4.txt");
  for (std::size_t k = 0; k < four.size(); k += 29)
    if (solve(decode(four[k])).outcome == Outcome::kGeometric) geometric.push_back(four[k]);
  tripus::testing::MoveTrials trials;
  std::mt19937_64 random(29);
  constexpr int kTrials = 60;
  for (std::size_t trial = 0; trial < kTrials; ++trial) {
    tripus::testing::try_recovery(geometric[random() % geometric.size()], 1 + trial % 10, random(),
                                  trials);
  }
  EXPECT_GE(trials.recovered, 0.99 * kTrials);
  EXPECT_THAT(trials.wrong, IsEmpty());
  EXPECT_LT(trials.still_geometric, kTrials / 2);
}

/// A boundary case: carries no metric, but a neighbour does.
const char* const kBoundaryCase = "eLAkbccdddprdk";
/// Of a manifold that is not known to carry a metric.
const char* const kNone = "dLQbcbcmebs";
/// Without angle structure, and without a quick proof that the manifold is not hyperbolic.
const char* const kOpen = "eLAkbcbddmpbds";

TEST(Retriangulation, FindsTheMetricsOfTheBoundaryCases) {
  for (const auto& row : tripus::testing::data_table("boundary-case-4.tsv")) {
    SCOPED_TRACE(row.at("isosig"));
    const auto triangulation = decode(row.at("isosig"));
    const Report start = solve(triangulation);
    const Retriangulation found = retriangulate(triangulation, start, {});
    ASSERT_EQ(found.report.outcome, Outcome::kGeometric);
    EXPECT_EQ(found.end, SearchEnd::kFound);
    EXPECT_EQ(found.start, topology::isosig(triangulation.gluings()));
    EXPECT_TRUE(tripus::testing::path_leads_there(triangulation.gluings(), found));
    // The flat tetrahedron has volume 0, and the others are pieces of the same manifold.
    ASSERT_FALSE(found.volumes.empty());
    EXPECT_EQ(found.volumes.front().isosig, found.start);
    EXPECT_EQ(found.volumes.front().outcome, Outcome::kDegenerate);
    EXPECT_EQ(found.volumes.front().volume, start.volume);
    for (const OtherVolume& other : found.volumes)
      EXPECT_NEAR(other.volume, found.report.volume, 1e-10);
  }
}

TEST(Retriangulation, IsTheSameForTheSameSeed) {
  topology::Gluings gluings = decode("eLPkbcdddlgscj").gluings();
  topology::randomize(gluings, {.count = 8, .seed = 5});
  const topology::Triangulation triangulation(std::move(gluings));
  const Report start = solve(triangulation);
  ASSERT_NE(start.outcome, Outcome::kGeometric);
  for (const std::uint64_t seed : {0u, 1u, 12345u}) {
    const auto a = retriangulate(triangulation, start, {}, {.seed = seed});
    const auto b = retriangulate(triangulation, start, {}, {.seed = seed});
    EXPECT_EQ(a.path, b.path);
    EXPECT_EQ(a.tried, b.tried);
    EXPECT_EQ(a.report.edge_lengths, b.report.edge_lengths);
  }
}

TEST(Retriangulation, KeepsTheEvidenceWhenTheBudgetEnds) {
  const auto triangulation = decode(kOpen);
  const Report start = solve(triangulation);
  ASSERT_EQ(start.outcome, Outcome::kInfeasible);
  const auto found = retriangulate(triangulation, start, {}, {.budget = 7});
  EXPECT_EQ(found.report.outcome, Outcome::kUnresolved);
  EXPECT_EQ(found.end, SearchEnd::kBudget);
  EXPECT_EQ(found.tried, 7u);
  EXPECT_TRUE(found.path.empty());
  EXPECT_TRUE(found.volumes.empty());
  EXPECT_EQ(found.report.certificate, start.certificate);
  EXPECT_EQ(topology::isosig(found.gluings), kOpen);
  EXPECT_THAT(found.report.message, HasSubstr("7 other triangulations"));
  EXPECT_THAT(found.report.message, HasSubstr("nothing follows about the manifold"));
  EXPECT_EQ(found.report.advice, Advice::kLargerSearch);
}

TEST(Retriangulation, SaysWhenThereIsNothingElseToTry) {
  const auto triangulation = decode(kOpen);
  const auto found = retriangulate(triangulation, solve(triangulation), {}, {.extra = 0});
  EXPECT_EQ(found.report.outcome, Outcome::kUnresolved);
  EXPECT_EQ(found.end, SearchEnd::kExhausted);
  EXPECT_LT(found.tried, 500u);
  EXPECT_THAT(found.report.message, HasSubstr("all that the moves reach"));
}

TEST(Retriangulation, EndsWithAProofThatThereIsNoMetric) {
  using Case = std::tuple<std::string, std::size_t, std::string>;
  for (const auto& [signature, tried, words] :
       {Case(kNone, 0, "group is free"), Case("dLQbcbcaekw", 0, "annulus"),
        Case(kOpen, 51, "Seen on")}) {
    const auto triangulation = decode(signature);
    const Report start = solve(triangulation);
    const auto found = retriangulate(triangulation, start, {});
    EXPECT_EQ(found.end, SearchEnd::kNotHyperbolic);
    EXPECT_EQ(found.tried, tried);
    EXPECT_THAT(found.report.message, HasSubstr(words));
    EXPECT_THAT(found.obstruction, HasSubstr(words));
    const std::string& shown = found.obstructed.empty() ? signature : found.obstructed;
    EXPECT_TRUE(found.obstruction.starts_with(obstruction(decode(shown)))) << found.obstruction;
    EXPECT_FALSE(obstruction(decode(shown)).empty());
    EXPECT_EQ(found.report.outcome, Outcome::kUnresolved);
    EXPECT_EQ(found.report.certificate, start.certificate);
    EXPECT_EQ(found.report.advice, Advice::kNone);
  }
}

// Other code has decided about all of the lists, with certificates that are checked.
TEST(Obstruction, IsFoundInManifoldsThatAreNotHyperbolicOnly) {
  std::size_t found = 0, others = 0;
  for (const auto& row : tripus::testing::data_table("hyperbolicity.tsv")) {
    const std::string& input = row.at("input");
    if (!topology::looks_like_isosig(input)) continue;
    if (obstruction(decode(input.c_str())).empty()) {
      ++others;
      continue;
    }
    ++found;
    EXPECT_EQ(row.at("hyperbolic"), "false") << input;
  }
  EXPECT_GT(found, 3000u);
  EXPECT_GT(others, 6000u);
}

TEST(Retriangulation, SimplifiesFirst) {
  const topology::MoveKind kinds[] = {topology::MoveKind::kTwoThree, topology::MoveKind::kThreeTwo,
                                      topology::MoveKind::kFourFour,
                                      topology::MoveKind::kZeroTwoEdge};
  for (const char* start : {"cPcbbbihq+", "cPcbbbihq-"}) {
    for (std::uint64_t seed = 1; seed <= 15; ++seed) {
      SCOPED_TRACE(seed);
      topology::Gluings gluings = topology::decode_isosig(start);
      topology::randomize(gluings, {.count = 40, .seed = seed, .kinds = kinds});
      const topology::Triangulation triangulation(gluings);
      SolveOptions quick;
      quick.evidence = false;
      const Report report = solve(triangulation, quick);
      if (report.outcome == Outcome::kGeometric) continue;
      const auto found = retriangulate(triangulation, report, quick);
      ASSERT_EQ(found.report.outcome, Outcome::kGeometric);
      EXPECT_NEAR(found.report.volume, 6.451990270835033, 1e-10);
      EXPECT_EQ(topology::full_isosig(found.gluings).oriented(), start);
      EXPECT_TRUE(tripus::testing::path_leads_there(gluings, found));
    }
  }
}

TEST(Tolerance, ThatDoublesDoNotReachIsNamed) {
  for (const double tolerance : {1e-15, 1e-30, 1e-300}) {
    SolveOptions options;
    options.tolerance = tolerance;
    for (const char* signature : {"cPcbbbihq", "cPcbbbdhq"}) {
      const Report report = solve(decode(signature), options);
      if (report.outcome == Outcome::kGeometric) continue;  // K may come out as exactly 0
      EXPECT_EQ(report.outcome, Outcome::kUnresolved);
      EXPECT_EQ(report.advice, Advice::kLooserTolerance);
      EXPECT_THAT(report.message, HasSubstr("A metric was found"));
    }
  }
}

TEST(Retriangulation, EndsInTime) {
  const auto triangulation = decode(kNone);
  SolveOptions options;
  options.time_limit = 1e-9;
  const auto found = retriangulate(triangulation, solve(triangulation), options);
  EXPECT_EQ(found.end, SearchEnd::kTimeLimit);
  EXPECT_EQ(found.report.outcome, Outcome::kUnresolved);
  EXPECT_LE(found.tried, 1u);
}

TEST(Retriangulation, CanBeInterrupted) {
  const auto triangulation = decode(kNone);
  const std::atomic<bool> stop = true;
  SolveOptions options;
  options.stop = &stop;
  const auto found = retriangulate(triangulation, solve(triangulation), options);
  EXPECT_EQ(found.end, SearchEnd::kInterrupted);
  EXPECT_EQ(found.report.outcome, Outcome::kUnresolved);
  EXPECT_EQ(found.tried, 0u);
}

void expect_nothing_claimed(const Report& report) {
  EXPECT_FALSE(report.certificate);
  EXPECT_FALSE(report.strict_angles);
}

TEST(Limits, LeaveUnresolvedWhatTheyCutShort) {
  for (const char* signature : {"cPcbbbihq", kBoundaryCase, kNone, "dLQbcbcaekw"}) {
    SCOPED_TRACE(signature);
    const auto triangulation = decode(signature);
    SolveOptions iterations, time;
    iterations.max_iterations = 1;
    iterations.initial_length = 5;
    time.time_limit = 1e-9;
    time.initial_length = 5;
    const std::atomic<bool> stop = true;
    SolveOptions interrupt;
    interrupt.stop = &stop;
    interrupt.initial_length = 5;
    for (const auto& options : {iterations, time, interrupt}) {
      const Report report = solve(triangulation, options);
      EXPECT_EQ(report.outcome, Outcome::kUnresolved);
      EXPECT_THAT(report.message, HasSubstr("Nothing follows about the manifold"));
      EXPECT_EQ(report.advice, Advice::kMoreTime);
      EXPECT_TRUE(tripus::testing::is_finite(report));
      expect_nothing_claimed(report);
    }
  }
}

TEST(ConeAngles, OtherThanAFullTurnClaimNothingExact) {
  for (const char* signature : {"cPcbbbihq", kBoundaryCase, kNone, "dLQbcbcaekw"}) {
    SCOPED_TRACE(signature);
    const auto triangulation = decode(signature);
    for (const double angle : {0.5, 3.0, 7.0}) {
      SolveOptions options;
      options.angle_structure = true;
      options.cone_angles.assign(triangulation.edge_count(), angle);
      const Report report = solve(triangulation, options);
      EXPECT_NE(report.outcome, Outcome::kInfeasible);
      EXPECT_TRUE(tripus::testing::is_finite(report));
      expect_nothing_claimed(report);
    }
  }
}

}  // namespace
}  // namespace tripus::structure
