// Thinned studies: what they measure agrees with theory where it says something.
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>

#include <gtest/gtest.h>

#include "studies/study.hpp"
#include "tests/support/data_files.hpp"
#include "topology/isosig.hpp"

namespace tripus::studies {
namespace {

namespace fs = std::filesystem;

/// Runs a study in a folder of its own and gives its facts by name.
std::map<std::string, double> facts_of(const char* name, const std::vector<std::string>& inputs,
                                       StudyOptions options) {
  std::string folder = (fs::temp_directory_path() / "tripus-study-XXXXXX").string();
  if (mkdtemp(folder.data()) == nullptr) throw std::runtime_error("no folder");
  for (const std::string& input : inputs)
    options.inputs.push_back({input, topology::decode_isosig(input)});
  const RunResult result = run_study(find_study(name), options, {folder, 2, nullptr, {}});
  fs::remove_all(folder);
  EXPECT_TRUE(result.finished());
  EXPECT_FALSE(result.paragraph.empty());
  std::map<std::string, double> facts;
  for (const Fact& fact : result.facts) facts[fact.name] = fact.value;
  return facts;
}

/// Every k-th triangulation with n tetrahedra.
std::vector<std::string> every(std::size_t k, int n) {
  const auto lines = testing::data_lines("triangulations-" + std::to_string(n) + ".txt");
  std::vector<std::string> result;
  for (std::size_t i = 0; i < lines.size(); i += k) result.push_back(lines[i]);
  return result;
}

TEST(StudyLaws, Convergence) {
  StudyOptions options;
  options.covers = {2, 3, 7, 30, 410};  // beyond 400 edge classes too
  options.methods = {"newton", "newton-cg", "flow:curvature/dopri5"};
  options.samples = 12;
  std::vector<std::string> inputs = every(700, 4);
  inputs.insert(inputs.begin(), "cPcbbbihq");
  const auto facts = facts_of("convergence", inputs, options);
  EXPECT_GE(facts.at("newton_order_least"), 1.9);
  EXPECT_LE(facts.at("euler_deviation"), 0.01);
  EXPECT_LE(facts.at("decay_deviation"), 0.02);
  EXPECT_EQ(facts.at("flows_not_decreasing"), 0);
  EXPECT_EQ(facts.at("runs_geometric"), facts.at("runs"));
  EXPECT_LE(facts.at("cover_volume_error"), 1e-14);
  EXPECT_EQ(facts.at("laws_broken"), 0);
  EXPECT_GE(facts.at("triangulations"), 8);
}

TEST(StudyLaws, Stability) {
  StudyOptions options;
  options.samples = 30;
  options.methods = {"newton", "newton-cg"};
  const auto facts = facts_of("stability", {"cPcbbbihq", "eLAkbcbddhejqn"}, options);
  EXPECT_NEAR(facts.at("breakdown_double"), 54.5 * std::log(2.0), 1e-9);       // 37.7765
  EXPECT_NEAR(facts.at("breakdown_long_double"), 65.5 * std::log(2.0), 1e-9);  // 45.4011
  EXPECT_NEAR(facts.at("breakdown_float"), 25.5 * std::log(2.0), 0.1);
  EXPECT_LE(facts.at("kernel_error"), 1e-15);
  EXPECT_EQ(facts.at("found_Tripus_solve"), 1);
  for (const char* method : {"newton", "newton_cg"})
    EXPECT_EQ(facts.at(std::string("found_Tripus_") + method), 1) << method;
  EXPECT_LE(facts.at("irregular_ratio"), 30);  // a few ulp of the lengths
  EXPECT_LT(facts.at("found_paper_flow_double"), 1);
}

TEST(StudyLaws, Triangulations) {
  StudyOptions options;
  options.samples = 60;
  const auto facts = facts_of("triangulations", {"cPcbbbihq"}, options);
  EXPECT_EQ(facts.at("triangulations"), 60);
  EXPECT_EQ(facts.at("unresolved"), 0);
  EXPECT_GT(facts.at("geometric"), 3);
  EXPECT_EQ(facts.at("low_valence_geometric"), 0);
  EXPECT_LE(facts.at("volume_spread"), 1e-13);
}

TEST(StudyLaws, PaperAgainstTheAlgebraicRoute) {
  StudyOptions options;
  options.samples = 40;
  std::vector<std::string> inputs = every(40, 3);
  for (const auto& input : every(600, 4)) inputs.push_back(input);
  const auto facts = facts_of("paper", inputs, options);
  EXPECT_GE(facts.at("geometric"), 10);
  EXPECT_EQ(facts.at("flow_found"), facts.at("geometric"));
  EXPECT_EQ(facts.at("algebraic_found"), facts.at("geometric"));
  EXPECT_LE(facts.at("residual"), 1e-50);
  EXPECT_LE(facts.at("flow_error"), 1e-8);
  EXPECT_LE(facts.at("newton_error"), 1e-12);
  EXPECT_GE(facts.at("manifolds"), facts.at("volumes"));
  EXPECT_GT(facts.at("manifolds_sharing"), facts.at("shared_volumes"));
  EXPECT_GT(facts.at("least_gap"), 1e-6);
}

}  // namespace
}  // namespace tripus::studies
