// tripus::Manifold from many threads at once.
#include "manifold/manifold.hpp"

#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "manifold/metric.hpp"

namespace tripus {
namespace {

TEST(ManifoldThreads, EightSolveOnce) {
  for (const char* input : {"dLQabccjkjn", "cPcbbbihq", "dLQbcbcaekw"}) {
    const Manifold M = load(input);
    std::vector<const structure::Report*> verdicts(8);
    std::vector<const Metric*> metrics(8);
    std::vector<const canonical::CanonizeAnswer*> answers(8);
    {
      std::vector<std::jthread> threads;
      for (std::size_t i = 0; i < metrics.size(); ++i)
        threads.emplace_back([&, i] {
          const Manifold copy = M;
          verdicts[i] = &copy.verdict();
          metrics[i] = copy.metric();
          if (metrics[i] != nullptr) {
            answers[i] = &copy.canonical();
            (void)metrics[i]->embedding();
          }
          (void)copy.homology();
          (void)copy.signature();
          (void)copy.to_json();
        });
    }
    for (std::size_t i = 1; i < metrics.size(); ++i) {
      EXPECT_EQ(verdicts[i], verdicts[0]) << input;
      EXPECT_EQ(metrics[i], metrics[0]) << input;
      EXPECT_EQ(answers[i], answers[0]) << input;
    }
  }
}

// The tables behind names, the census and the registries are read when they are first asked for.
TEST(ManifoldThreads, EightReadInputsOfEveryKind) {
  std::vector<std::string> found(8);
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < found.size(); ++i)
      threads.emplace_back([&, i] {
        for (const char* input : {"hk5_2", "4_1", "t3g2.13",
                                  "PD: X[4,2,5,1] X[8,6,1,5] X[6,3,7,4] "
                                  "X[2,7,3,8]",
                                  "cPcbbbihq+"}) {
          const Manifold M = load(input);
          found[i] +=
              M.signature().value_or("none") + (M.metric() != nullptr ? " has a metric;" : ";");
          if (const canonical::CensusEntry* entry = M.identify()) found[i] += entry->name + ";";
        }
      });
  }
  for (const std::string& one : found) EXPECT_EQ(one, found[0]);
}

}  // namespace
}  // namespace tripus
