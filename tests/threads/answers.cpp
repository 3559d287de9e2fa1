// Answers that are computed on several threads are the same as on one.
#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "base/in_order.hpp"
#include "canonical/census.hpp"
#include "orthospectrum/spectrum.hpp"
#include "structure/existence.hpp"
#include "structure/proof/proof.hpp"
#include "structure/solve.hpp"
#include "tests/support/data_files.hpp"
#include "tests/support/triangulations.hpp"
#include "topology/cyclic_cover.hpp"

namespace tripus {
namespace {

Context on_threads(unsigned count) {
  Context context;
  context.threads = count;
  return context;
}

/// Large enough for more than one thread.
topology::Triangulation large_cover() {
  const auto base = testing::decode("cPcbbbihq");
  return topology::Triangulation(
      topology::cyclic_cover(base.gluings(), *topology::primitive_class(base), 4000));
}

TEST(Threads, InOrderUsesEveryResultOnceInItsPlace) {
  for (const std::size_t threads : {1u, 2u, 8u})
    for (const std::size_t count : {0u, 1u, 7u, 1000u}) {
      std::vector<std::size_t> used;
      const std::size_t done = in_order(
          count, threads, [](std::size_t k) { return std::optional(k * k); },
          [&](std::size_t k, std::size_t square) {
            EXPECT_EQ(square, k * k);
            used.push_back(k);
            return true;
          });
      EXPECT_EQ(done, count);
      ASSERT_EQ(used.size(), count);
      for (std::size_t k = 0; k < count; ++k) EXPECT_EQ(used[k], k);
    }
}

TEST(Threads, InOrderEndsWhereItIsToldToAndPassesOnWhatIsThrown) {
  const auto all = [](std::size_t, std::size_t) { return true; };
  EXPECT_EQ(
      in_order(
          100, 4, [](std::size_t k) { return k < 40 ? std::optional(k) : std::nullopt; }, all),
      40u);
  EXPECT_EQ(in_order(
                100, 4, [](std::size_t k) { return std::optional(k); },
                [](std::size_t k, std::size_t) { return k < 39; }),
            39u);
  const auto throws = [](std::size_t k) -> std::optional<std::size_t> {
    if (k == 17) throw std::runtime_error("seventeen");
    return k;
  };
  EXPECT_THROW(in_order(100, 4, throws, all), std::runtime_error);
}

TEST(Threads, ProofsDoNotDependOnThem) {
  const auto triangulation = large_cover();
  const structure::Report report = structure::solve(triangulation);
  const structure::Proof one =
      structure::prove(triangulation, report.edge_lengths, {}, on_threads(1));
  const structure::Proof four =
      structure::prove(triangulation, report.edge_lengths, {}, on_threads(4));
  ASSERT_TRUE(one.proved);
  EXPECT_EQ(one.radii, four.radii);
  EXPECT_EQ(one.volume.lower, four.volume.lower);
  EXPECT_EQ(one.volume.upper, four.volume.upper);
}

TEST(Threads, OrthospectraDoNotDependOnThem) {
  const auto triangulation = testing::decode("dLQbccchrqg");
  const structure::Report report = structure::solve(triangulation);
  orthospectrum::SpectrumOptions options;
  options.length = 4;
  const auto one =
      orthospectrum::orthospectrum(triangulation, report.edge_lengths, options, on_threads(1));
  const auto four =
      orthospectrum::orthospectrum(triangulation, report.edge_lengths, options, on_threads(4));
  ASSERT_EQ(one.arcs.size(), four.arcs.size());
  for (std::size_t k = 0; k < one.arcs.size(); ++k)
    EXPECT_EQ(one.arcs[k].length, four.arcs[k].length);
}

TEST(Threads, ACensusDoesNotDependOnThem) {
  const auto list = testing::data_lines("triangulations-2.txt");
  canonical::ClassifyOptions options;
  options.threads = 1;
  const auto one = canonical::classify(list, options);
  options.threads = 4;
  const auto four = canonical::classify(list, options);
  ASSERT_EQ(one.size(), four.size());
  for (std::size_t k = 0; k < one.size(); ++k) {
    EXPECT_EQ(one[k].triangulation, four[k].triangulation);
    EXPECT_EQ(one[k].entry.signature, four[k].entry.signature);
  }
}

TEST(Threads, CertificatesDoNotDependOnThem) {
  const auto signatures = testing::data_lines("triangulations-3.txt");
  std::array<std::vector<structure::Existence>, 4> proofs;
  {
    std::vector<std::jthread> threads;
    for (auto& mine : proofs)
      threads.emplace_back([&mine, &signatures] {
        for (const std::string& signature : signatures)
          mine.push_back(structure::existence(testing::decode(signature)));
      });
  }
  for (const auto& others : proofs) {
    ASSERT_EQ(others.size(), signatures.size());
    for (std::size_t k = 0; k < others.size(); ++k) EXPECT_TRUE(others[k] == proofs[0][k]);
  }
}

}  // namespace
}  // namespace tripus
